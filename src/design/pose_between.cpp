// SPDX-License-Identifier: MIT
// Interpolation, correction, velocity and acceleration.
#include "pose_between.h"

#include "moivre/kinematics/state.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

bool has_velocity(const BranchSample& sample) {
  return sample.is_determined && sample.velocity.size() > 0;
}

/// Linear where a sample has no velocity.
VectorXd interpolated(const BranchSample& before, const BranchSample& after, double time) {
  const double h = after.time - before.time;
  const double s = (time - before.time) / h;
  const VectorXd line = (1 - s) * before.q + s * after.q;
  if (!has_velocity(before) || !has_velocity(after)) return line;
  const VectorXd way = after.q - before.q;
  return line +
         s * (1 - s) * ((1 - s) * (h * before.velocity - way) - s * (h * after.velocity - way));
}

}  // namespace

BranchSample pose_between(const Phi& phi, const BranchSample& before, const BranchSample& after,
                          double time) {
  constexpr int kMostSteps = 6;
  // Far above rounding, far below what an extreme value is told to.
  constexpr double kSettled = 1e-11;
  BranchSample sample;
  sample.time = time;
  sample.q = interpolated(before, after, time);
  sample.is_determined = false;
  const double length = phi.length();
  const double most = (after.q - before.q).lpNorm<Eigen::Infinity>() + kSettled * length;
  for (int step = 0; step < kMostSteps; ++step) {
    const VectorXd correction =
        Factorisation(phi.jacobian(sample.q, time)).solve(-phi.value(sample.q, time));
    const double size = correction.lpNorm<Eigen::Infinity>();
    if (!(size <= most)) return sample;
    sample.q += correction;
    if (size > kSettled * length) continue;
    const MotionState state = motion_state(phi, sample.q, time);
    sample.velocity = state.velocity;
    sample.acceleration = state.acceleration;
    sample.residual = residual_by_size(phi, sample.q, time);
    sample.is_determined = state.is_determined;
    return sample;
  }
  return sample;
}

}  // namespace moivre
