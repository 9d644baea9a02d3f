// SPDX-License-Identifier: MIT
// What is wrong with the closures that were found of a random linkage? Its own pose, Newton's method and another seed tell.
#pragma once

#include <algorithm>
#include <string>

#include "moivre/closures/closures.h"
#include "moivre/mechanism/pose.h"
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

inline bool has_pose(const Mechanism& mechanism, const ClosureResult& result,
                     const Eigen::VectorXd& q, double size) {
  constexpr double kSame = 1e-6;
  return std::any_of(result.closures.begin(), result.closures.end(), [&](const Closure& closure) {
    return pose_distance(mechanism, closure.q, q, size) < kSame;
  });
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

/// Empty where nothing is: q = 0 is a closure, closures are different poses, another seed counts as many complex ones, and Newton's
/// method from `starts` random poses comes to no regular one that is not among them.
inline std::string fault_of(const Mechanism& mechanism, const ClosureResult& result,
                            const ClosureResult& again, std::uint64_t starts, Draw draw) {
  const Phi phi(mechanism);
  const double size = phi.length();
  if (!has_pose(mechanism, result, Eigen::VectorXd::Zero(phi.dimension()), size))
    return "its own pose is lost";
  for (std::size_t k = 0; k < result.closures.size(); ++k) {
    ClosureResult others;
    others.closures.assign(result.closures.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                           result.closures.end());
    if (has_pose(mechanism, others, result.closures[k].q, size)) {
      return "closure " + result.closures[k].id + " is told twice";
    }
  }
  if (again.complete && again.counts.complex != result.counts.complex) {
    return std::to_string(result.counts.complex) + " complex closures, by another seed " +
           std::to_string(again.counts.complex);
  }
  for (std::uint64_t k = 0; k < starts; ++k) {
    // Far turns round what they add up to: once more from the shortest ones.
    const NewtonResult first = newton(phi, random_pose(phi, draw));
    const NewtonResult there = newton(phi, phi.canonical(first.q));
    constexpr double kRegular = 1e-6;
    constexpr double kFar = 1e3;  // beyond, rounding of angles is no longer small
    const bool is_regular = there.status == NewtonStatus::converged && !there.is_singular &&
                            there.q.cwiseAbs().maxCoeff() < kFar &&
                            there.smallest_singular_value > kRegular;
    if (is_regular && !has_pose(mechanism, result, there.q, size)) {
      return "Newton's method finds one more, at " + number_text(there.q);
    }
  }
  return "";
}

}  // namespace moivre::test
