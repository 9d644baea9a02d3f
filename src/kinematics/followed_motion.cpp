// SPDX-License-Identifier: MIT
// Nine poses of a curve, equally spaced along a chord, and their central differences.
#include "moivre/kinematics/followed_motion.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "moivre/kinematics/null_space.h"
#include "moivre/kinematics/own_units.h"
#include "slicing.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kSide = 4;  // poses on each side of q
// h: short beside what bends a motion, long beside rounding; the shorter one where curves bend
// more.
constexpr double kSpacings[] = {5e-3, 1.25e-3};
constexpr double kSameCurve = 1e-2;  // of directions of length 1: chords to where a curve was left

/// The value at s of the polynomial through values at the nodes.
VectorXd at(double s, const std::vector<double>& nodes, const std::vector<VectorXd>& values) {
  VectorXd sum = VectorXd::Zero(values.front().size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    double share = 1;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      if (j != i) share *= (s - nodes[j]) / (nodes[i] - nodes[j]);
    }
    sum += share * values[i];
  }
  return sum;
}

/// The curve's unit tangent at q, from the pose z beside it; nullopt where it was not followed
/// through q.
std::optional<VectorXd> tangent_of(const Slicing& slicing, const VectorXd& z, double h) {
  const VectorXd chord = slicing.null_space() * (slicing.null_space().transpose() * z);
  const MatrixXd A = chord.normalized().transpose();
  std::array<VectorXd, 2 * kSide + 1> pose;  // at s = (k - kSide) h
  std::vector<double> nodes = {0};
  std::vector<VectorXd> followed = {VectorXd::Zero(z.size())};
  const auto follow = [&](int k, const VectorXd& guess) {
    auto there = slicing.arrival(A, k * h, guess);
    if (!there) return false;
    nodes.push_back(k);
    followed.push_back(*there);
    pose[static_cast<std::size_t>(k + kSide)] = std::move(*there);
    return true;
  };
  if (!follow(kSide, z * (kSide * h / chord.norm()))) return std::nullopt;
  for (int k = kSide - 1; k >= -kSide; --k) {
    if (k != 0 && !follow(k, at(k, nodes, followed))) return std::nullopt;
  }
  const auto difference = [&](int k) -> VectorXd {
    return (pose[static_cast<std::size_t>(kSide + k)] - pose[static_cast<std::size_t>(kSide - k)]) /
           h;
  };
  // Central differences: the derivative at 0 of the polynomial through these.
  const VectorXd by_six = 3. / 4 * difference(1) - 3. / 20 * difference(2) + difference(3) / 60;
  const VectorXd by_eight =
      4. / 5 * difference(1) - difference(2) / 5 + 4. / 105 * difference(3) - difference(4) / 280;
  const VectorXd tangent = by_eight.normalized();
  const MatrixXd& N = slicing.null_space();
  const bool agree = (by_six.normalized() - tangent).norm() <= kFollowed;
  const bool is_free = (tangent - N * (N.transpose() * tangent)).norm() <= kFollowed;
  if (!agree || !is_free) return std::nullopt;
  return tangent;
}

bool is_among(const std::vector<VectorXd>& known, const VectorXd& direction, double within) {
  return std::any_of(known.begin(), known.end(), [&](const VectorXd& other) {
    return std::min((other - direction).norm(), (other + direction).norm()) <= within;
  });
}

/// Of each curve that starts at a spacing come to.
std::vector<VectorXd> tangents(const Slicing& slicing, double h) {
  std::vector<VectorXd> found;
  const double step = kSide * h;
  for (int slice = 0; slice < Slicing::kSlices; ++slice) {
    const MatrixXd A = slicing.planes(1, slice);
    for (int start = 0; start < Slicing::kStarts; ++start) {
      const int number = slice * Slicing::kStarts + start;
      const auto z = slicing.arrival(A, step, slicing.start_on(A, step, number));
      if (!z || is_among(found, z->normalized(), kSameCurve)) continue;
      const auto tangent = tangent_of(slicing, *z, h);
      if (tangent && !is_among(found, *tangent, kSameCurve)) found.push_back(*tangent);
    }
  }
  return found;
}

/// Of length 1 by the mechanism's own sizes; which way is forward is a convention.
VectorXd as_told(const Phi& phi, const VectorXd& rates) {
  const VectorXd size = own_sizes(phi);
  VectorXd relative = rates.cwiseQuotient(size).normalized();
  for (double& part : relative) part = std::abs(part) <= kFollowed ? 0 : part;
  relative.normalize();
  // Of parts that are equally large but for rounding the first one decides.
  const double large = relative.lpNorm<Eigen::Infinity>() * (1 - kFollowed);
  const double lead = *std::find_if(relative.begin(), relative.end(),
                                    [&](double p) { return std::abs(p) >= large; });
  return size.cwiseProduct(lead < 0 ? (-relative).eval() : relative);
}

}  // namespace

std::vector<VectorXd> followed_directions(const Phi& phi, const VectorXd& q, double t,
                                          std::uint64_t seed, const std::vector<Index>& moving) {
  require_place(phi, q, t);
  const VectorXd size = own_sizes(phi);
  const MatrixXd J = phi.jacobian(q, t) * size.asDiagonal();
  const MatrixXd own = J(Eigen::all, moving);
  const MatrixXd all = in_own_units(phi, phi.jacobian(q, t));
  if (numerical_rank(all(Eigen::all, moving)) + 1 == own.cols()) {
    VectorXd only = VectorXd::Zero(q.size());
    only(moving) = shortest_direction(own);
    return {only.cwiseProduct(size)};
  }
  const Slicing slicing(phi, q, t, seed, moving);
  for (const double h : kSpacings) {
    std::vector<VectorXd> found = tangents(slicing, h);
    if (found.empty()) continue;
    for (VectorXd& direction : found) direction = as_told(phi, slicing.rates_of(direction));
    return found;
  }
  return {};
}

std::vector<VectorXd> followed_directions(const Phi& phi, const VectorXd& q, double t,
                                          std::uint64_t seed) {
  std::vector<Index> all(static_cast<std::size_t>(phi.dimension()));
  std::iota(all.begin(), all.end(), Index{0});
  return followed_directions(phi, q, t, seed, all);
}

}  // namespace moivre
