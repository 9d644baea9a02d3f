// SPDX-License-Identifier: MIT
// Interpolation, correction, velocity and acceleration.
#include "pose_between.h"

#include <cmath>

#include "moivre/kinematics/own_units.h"
#include "moivre/kinematics/state.h"
#include "moivre/numeric/quintic.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

bool has_velocity(const BranchSample& sample) {
  return sample.is_determined && sample.velocity.size() > 0;
}

/// Hermite's quintic; linear where a sample has no velocity, and beside a dead point, where the
/// branch turns back, as a square root.
VectorXd interpolated(const BranchSample& before, const BranchSample& after, double time) {
  const double h = after.time - before.time;
  const double s = (time - before.time) / h;
  if (!after.is_determined) return after.q + std::sqrt(1 - s) * (before.q - after.q);
  if (!before.is_determined) return before.q + std::sqrt(s) * (after.q - before.q);
  if (!has_velocity(before) || !has_velocity(after)) return (1 - s) * before.q + s * after.q;
  const QuinticWeights<double> w = quintic_weights(time - before.time, h);
  return w.a * before.q + w.slope_a * before.velocity + w.bend_a * before.acceleration +
         w.b * after.q + w.slope_b * after.velocity + w.bend_b * after.acceleration;
}

}  // namespace

BranchSample pose_between(const Phi& phi, const BranchSample& before, const BranchSample& after,
                          double time) {
  constexpr int kMostSteps = 5;
  // Newton's method leaves the square of its last step.
  constexpr double kSettled = 1e-7;
  BranchSample sample;
  sample.time = time;
  sample.q = interpolated(before, after, time);
  sample.is_determined = false;
  const VectorXd unit = own_sizes(phi);
  const auto size_of_step = [&](const VectorXd& step) {
    return step.cwiseQuotient(unit).lpNorm<Eigen::Infinity>();
  };
  const double most = size_of_step(after.q - before.q) + kSettled;
  for (int step = 0; step < kMostSteps; ++step) {
    const Factorization factors = factorization_of(phi, phi.jacobian(sample.q, time));
    const VectorXd correction = factors.solve(-phi.value(sample.q, time));
    const double size = size_of_step(correction);
    if (!(size <= most)) return sample;
    sample.q += correction;
    if (size > kSettled) continue;
    const MotionState state = motion_state(phi, sample.q, time);
    sample.velocity = state.velocity;
    sample.acceleration = state.acceleration;
    sample.is_determined = state.is_determined;
    return sample;
  }
  return sample;
}

}  // namespace moivre
