// SPDX-License-Identifier: MIT
// Quaternions from doubles, cleaned of the last bits.
#include "exact_pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "moivre/formulation/exact.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

// Square roots leave the last two bits of a ratio to chance; without them a quarter turn is one
// exactly.
constexpr int kBits = 50;

}  // namespace

Rational without_noise(double x) {
  return Rational(std::ldexp(std::nearbyint(std::ldexp(x, kBits)), -kBits));
}

ExactPose shift_to(const Eigen::Vector3d& point) {
  const Rational half(1, 2);
  return {{1, 0, 0, 0},
          {0, half * typed_decimal(point.x()), half * typed_decimal(point.y()),
           half * typed_decimal(point.z())}};
}

ExactPose turn_about_z(double angle_rad) {
  const double cosine = std::cos(angle_rad / 2);
  const double sine = std::sin(angle_rad / 2);
  if (std::abs(sine) <= std::abs(cosine)) return {{1, 0, 0, without_noise(sine / cosine)}, {}};
  return {{without_noise(cosine / sine), 0, 0, 1}, {}};
}

ExactPose frame_of(const Eigen::Vector3d& axis) {
  const Eigen::Quaterniond turn(joint_frame(axis));
  return turn_by({turn.w(), turn.x(), turn.y(), turn.z()});
}

ExactPose turn_by(const Quaternion<double>& q) {
  const double largest = *std::max_element(
      q.begin(), q.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  ExactPose turn;
  for (std::size_t k = 0; k < q.size(); ++k) turn.q[k] = without_noise(q[k] / largest);
  return turn;
}

ExactPose tilt(const Rational& half_tangent) { return {{1, half_tangent, 0, 0}, {}}; }

ExactPose across(std::size_t k) {
  return k == 0 ? ExactPose{{1, 0, 1, 0}, {}} : conjugate(tilt(1));
}

Rational norm(const ExactPose& pose) { return dot(pose.q, pose.q); }

DualQuaternion<double> to_double(const ExactPose& pose) {
  return mapped(pose, [](const Rational& part) { return to_double(part); });
}

}  // namespace moivre
