// SPDX-License-Identifier: MIT
// Derivatives of what moves by the drivers.
#include "sampled_pose.h"

#include <cmath>
#include <limits>

#include "moivre/kinematics/null_space.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

const Eigen::MatrixXd& SampledPose::jacobian() const {
  if (!jacobian_) jacobian_ = phi_.jacobian(pose_.q, pose_.time);
  return *jacobian_;
}

const KinematicCoefficients& SampledPose::coefficients() const {
  if (!coefficients_) coefficients_ = kinematic_coefficients(phi_, pose_.q, pose_.time);
  return *coefficients_;
}

ScalarState SampledPose::along(const Observable& what, Index a) const {
  const KinematicCoefficients& k = coefficients();
  if (!k.is_determined) return {kNothing, kNothing, kNothing};
  return what.state(pose_.q, k.first.col(a), k.second[static_cast<std::size_t>(a)].col(a));
}

double SampledPose::mixed(const Observable& what, Index a, Index b) const {
  const KinematicCoefficients& k = coefficients();
  if (!k.is_determined) return kNothing;
  // Both drivers going on together: o'' = o_aa + 2 o_ab + o_bb.
  const auto& k_a = k.second[static_cast<std::size_t>(a)];
  const auto& k_b = k.second[static_cast<std::size_t>(b)];
  const VectorXd first = k.first.col(a) + k.first.col(b);
  const VectorXd second = k_a.col(a) + 2 * k_a.col(b) + k_b.col(b);
  return (what.state(pose_.q, first, second).acceleration - along(what, a).acceleration -
          along(what, b).acceleration) /
         2;
}

bool SampledPose::runs_away(const Observable& what) const {
  // A dead point is known to about 1e-8 of the mechanism's length; what its free direction moves by
  // less stands.
  constexpr double kStands = 1e-5;
  const double length = phi_.length();
  const VectorXd size = own_sizes(phi_);
  const VectorXd free = size.asDiagonal() * shortest_direction(jacobian() * size.asDiagonal());
  const double moved = what.state(pose_.q, free, VectorXd::Zero(free.size())).velocity /
                       (what.is_angle ? 1 : length);
  return std::abs(moved) > kStands;
}

}  // namespace moivre
