// SPDX-License-Identifier: MIT
// Interpolation, correction, velocity and acceleration.
#include "pose_between.h"

#include <algorithm>
#include <cmath>

#include "moivre/kinematics/own_units.h"
#include "moivre/kinematics/state.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

bool has_velocity(const BranchSample& sample) {
  return sample.is_determined && sample.velocity.size() > 0;
}

/// Hermite's quintic; linear where a sample has no velocity, and beside a dead point, where the branch turns back, as a square root.
VectorXd interpolated(const BranchSample& before, const BranchSample& after, double time) {
  const double h = after.time - before.time;
  const double s = (time - before.time) / h;
  if (!after.is_determined) return after.q + std::sqrt(1 - s) * (before.q - after.q);
  if (!before.is_determined) return before.q + std::sqrt(s) * (after.q - before.q);
  const VectorXd line = (1 - s) * before.q + s * after.q;
  if (!has_velocity(before) || !has_velocity(after)) return line;
  // By q, q' and q'' at both ends; u counts from the other end.
  const double u = 1 - s;
  const VectorXd way = after.q - before.q;
  const VectorXd at_before = h * before.velocity - way;
  const VectorXd at_after = way - h * after.velocity;
  const double bend = h * h / 2;
  // The cubic, and what its second derivatives miss.
  const VectorXd cubic = line + s * u * (u * at_before + s * at_after);
  const VectorXd missed_before = bend * before.acceleration - (at_after - 2 * at_before);
  const VectorXd missed_after = bend * after.acceleration - (at_before - 2 * at_after);
  return cubic + s * s * u * u * (u * missed_before + s * missed_after);
}

/// The largest entry, lengths beside the mechanism's.
double size_of(const VectorXd& step, const Phi& phi) {
  double size = 0;
  for (std::size_t k = 0; k < phi.coordinates().size(); ++k) {
    const bool is_length = phi.coordinates()[k].kind == CoordinateKind::length;
    const double entry = std::abs(step[static_cast<Eigen::Index>(k)]);
    size = std::max(size, is_length ? entry / phi.length() : entry);
  }
  return size;
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
  const double most = size_of(after.q - before.q, phi) + kSettled;
  for (int step = 0; step < kMostSteps; ++step) {
    const Factorization factors = factorization_of(phi, phi.jacobian(sample.q, time));
    const VectorXd correction = factors.solve(-phi.value(sample.q, time));
    const double size = size_of(correction, phi);
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
