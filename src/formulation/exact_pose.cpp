// SPDX-License-Identifier: MIT
// Quaternions from doubles, cleaned of the last bits.
#include "exact_pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "moivre/formulation/exact.h"
#include "moivre/mechanism/pose.h"
#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

// Square roots leave the last two bits of a ratio to chance; without them a quarter turn is one
// exactly.
constexpr int kBits = 50;

using ExactVector = std::array<Rational, 3>;

ExactVector crossed(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::optional<Integer> exact_root(const Integer& square) {
  const Integer root = sqrt(square);
  return root * root == square ? std::optional(root) : std::nullopt;
}

/// Of length 1; nothing where its length is no fraction.
std::optional<ExactVector> normalized(const ExactVector& a) {
  const Rational square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  const auto above = exact_root(numerator(square));
  const auto below = exact_root(denominator(square));
  if (!above || !below || *above == 0) return std::nullopt;
  const Rational scale = ratio(*below, *above);
  return ExactVector{scale * a[0], scale * a[1], scale * a[2]};
}

/// The turn that takes the unit vectors to these, orthonormal and right-handed ones: a column of
/// q q^T, that of the largest entry.
ExactPose turn_to(const ExactVector& x, const ExactVector& y, const ExactVector& z) {
  const Rational one(1);
  const std::array<Quaternion<Rational>, 4> columns{
      {{one + x[0] + y[1] + z[2], y[2] - z[1], z[0] - x[2], x[1] - y[0]},
       {y[2] - z[1], one + x[0] - y[1] - z[2], y[0] + x[1], z[0] + x[2]},
       {z[0] - x[2], y[0] + x[1], one - x[0] + y[1] - z[2], z[1] + y[2]},
       {x[1] - y[0], z[0] + x[2], z[1] + y[2], one - x[0] - y[1] + z[2]}}};
  std::size_t largest = 0;
  for (std::size_t k = 1; k < columns.size(); ++k) {
    if (columns[largest][largest] < columns[k][k]) largest = k;
  }
  ExactPose turn;
  for (std::size_t k = 0; k < turn.q.size(); ++k) {
    turn.q[k] = columns[largest][k] / columns[largest][largest];
  }
  return turn;
}

std::optional<ExactPose> exact_frame_of(const Eigen::Vector3d& axis) {
  const auto z =
      normalized({typed_decimal(axis.x()), typed_decimal(axis.y()), typed_decimal(axis.z())});
  if (!z) return std::nullopt;
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  ExactVector least{};
  least[static_cast<std::size_t>(smallest)] = 1;
  const auto x = normalized(crossed(least, *z));
  if (!x) return std::nullopt;
  return turn_to(*x, crossed(*z, *x), *z);
}

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

bool has_exact_frame(const Eigen::Vector3d& axis) { return exact_frame_of(axis).has_value(); }

ExactPose frame_of(const Eigen::Vector3d& axis) {
  if (const auto exact = exact_frame_of(axis)) return *exact;
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
