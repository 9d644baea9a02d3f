// SPDX-License-Identifier: MIT
// What is wrong with the closures that were found of a random linkage? Its own pose, Newton's
// method and another seed tell.
#pragma once

#include <algorithm>
#include <string>

#include "moivre/closures/closures.h"
#include "moivre/mechanism/pose.h"
#include "random_assemblies.h"
#include "random_linkages.h"

namespace moivre::test {

/// Largest difference of any body's axes, or of its origin beside `size`.
inline double pose_distance(const Mechanism& mechanism, const Eigen::VectorXd& a,
                            const Eigen::VectorXd& b, double size) {
  double largest = 0;
  const Eigen::Index per_body = mechanism.space == Space::planar ? 3 : 6;
  const Eigen::Index axes = per_body / 3 + 1;  // of a place: 2 or 3
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    const Eigen::Index at = per_body * static_cast<Eigen::Index>(body - 1);
    const Eigen::Matrix3d turned =
        orientation(mechanism, body, a) - orientation(mechanism, body, b);
    largest = std::max(largest, turned.cwiseAbs().maxCoeff());
    largest =
        std::max(largest, (a.segment(at, axes) - b.segment(at, axes)).cwiseAbs().maxCoeff() / size);
  }
  return largest;
}

inline bool has_pose(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses,
                     const Eigen::VectorXd& q, double size, double same = 1e-6) {
  return std::any_of(poses.begin(), poses.end(), [&](const Eigen::VectorXd& pose) {
    return pose_distance(mechanism, pose, q, size) < same;
  });
}

inline std::vector<Eigen::VectorXd> poses_of(const std::vector<Closure>& closures) {
  std::vector<Eigen::VectorXd> poses;
  for (const Closure& closure : closures) poses.push_back(closure.q);
  return poses;
}

inline Eigen::VectorXd random_pose(const Phi& phi, Draw& draw) {
  Eigen::VectorXd q(phi.dimension());
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const bool is_length =
        phi.coordinates()[static_cast<std::size_t>(k)].kind == CoordinateKind::length;
    q[k] = (2 * draw.unit() - 1) * (is_length ? 2 * phi.length() : 3);
  }
  return q;
}

inline std::string number_text(const Eigen::VectorXd& q) {
  std::string text;
  for (const double x : q) text += " " + std::to_string(x);
  return text;
}

/// The smallest singular value of a closure that is surely one.
inline constexpr double kRegular = 1e-6;

/// Regular poses to which Newton's method comes from random ones: rounds of `starts` of these,
/// until one brings nothing new.
inline std::vector<Eigen::VectorXd> poses_by_newton(const Mechanism& mechanism,
                                                    std::uint64_t starts, Draw draw) {
  constexpr int kRounds = 20;
  const Phi phi(mechanism);
  std::vector<Eigen::VectorXd> poses;
  std::size_t before = 1;
  for (int round = 0; round < kRounds && before != poses.size(); ++round) {
    before = poses.size();
    for (std::uint64_t k = 0; k < starts; ++k) {
      // Far turns round what they add up to: once more from the shortest ones.
      const NewtonResult first = newton(phi, random_pose(phi, draw));
      const NewtonResult there = newton(phi, phi.canonical(first.q));
      constexpr double kFar = 1e3;  // beyond, rounding of angles is no longer small
      const bool is_regular = there.status == NewtonStatus::converged && !there.is_singular &&
                              there.q.cwiseAbs().maxCoeff() < kFar &&
                              there.smallest_singular_value > kRegular;
      if (is_regular && !has_pose(mechanism, poses, there.q, phi.length())) {
        poses.push_back(there.q);
      }
    }
  }
  return poses;
}

/// Empty where nothing is: q = 0 is a closure, closures are different poses and satisfy every
/// constraint, another seed counts as many complex ones, and those that were found `by_newton` are
/// among them. `mechanism` has the first bodies of the one that was solved.
inline std::string fault_of(const Mechanism& mechanism, const ClosureResult& result,
                            const ClosureResult& again,
                            const std::vector<Eigen::VectorXd>& by_newton) {
  const Phi phi(mechanism);
  const double size = phi.length();
  const std::vector<Eigen::VectorXd> poses = poses_of(result.closures);
  if (!has_pose(mechanism, poses, Eigen::VectorXd::Zero(phi.dimension()), size))
    return "its own pose is lost";
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const std::string& id = result.closures[k].id;
    const double residual = residual_by_size(phi, poses[k].head(phi.dimension()), 0);
    if (!(residual <= kAssembled)) return "closure " + id + " leaves " + std::to_string(residual);
    const std::vector<Eigen::VectorXd> others(poses.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                                              poses.end());
    // A double closure of rounded lengths may be two beside each other.
    const bool is_regular = result.closures[k].smallest_singular_value > kRegular;
    if (is_regular && has_pose(mechanism, others, poses[k], size)) {
      return "closure " + id + " is told twice";
    }
  }
  if (again.complete && again.counts.complex != result.counts.complex) {
    return std::to_string(result.counts.complex) + " complex closures, by another seed " +
           std::to_string(again.counts.complex);
  }
  // Beside a double closure Newton's method comes to rest half as many digits away.
  constexpr double kSameSingular = 1e-4;
  std::vector<Eigen::VectorXd> singular;
  for (const Closure& closure : result.closures) {
    if (closure.singular) singular.push_back(closure.q);
  }
  for (const Eigen::VectorXd& q : by_newton) {
    if (!has_pose(mechanism, poses, q, size) &&
        !has_pose(mechanism, singular, q, size, kSameSingular)) {
      return "Newton's method finds one more, at " + number_text(q);
    }
  }
  return "";
}

}  // namespace moivre::test
