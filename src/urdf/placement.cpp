// SPDX-License-Identifier: MIT
// Rotations of typed angles, and right angles among them.
#include "moivre/urdf/placement.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

/// Fewer decimals say little: 1.57 is as likely a choice as a right angle.
constexpr int kFewestDecimals = 4;
/// Digits of pi below; no double needs as many.
constexpr int kMostDecimals = 30;

/// pi/2 to 36 decimals.
const Rational& right_angle() {
  static const Rational value =
      ratio(Integer("1570796326794896619231321691639751442"), pow(Integer(10), 36U));
  return value;
}

}  // namespace

int decimals(const Rational& number) {
  Integer scale = 1;
  for (int k = 0; k < kMostDecimals; ++k) {
    if (scale % denominator(number) == 0) return k;
    scale *= 10;
  }
  return kMostDecimals;
}

namespace {

/// k where the angle is k pi/2 in its digits, `fewest` decimals at least.
std::optional<int> turns_in_digits(const Rational& angle, int fewest) {
  if (angle.is_zero()) return 0;
  const double turns = to_double(angle) / (std::numbers::pi / 2);
  constexpr double kMost = 1e6;
  if (std::abs(turns) > kMost) return std::nullopt;
  const auto nearest = static_cast<int>(std::lround(turns));
  const int typed = decimals(angle);
  if (nearest == 0 || typed < fewest) return std::nullopt;
  const Rational last_digit = ratio(Integer(1), pow(Integer(10), static_cast<unsigned>(typed)));
  if (abs(angle - Rational(nearest) * right_angle()) >= last_digit) return std::nullopt;
  return nearest;
}

}  // namespace

std::optional<int> quarter_turns(const Rational& angle) {
  return turns_in_digits(angle, kFewestDecimals);
}

std::optional<double> missed_right_angle(const Rational& angle) {
  constexpr int kTellingDecimals = 2;
  const auto turns = turns_in_digits(angle, kTellingDecimals);
  if (!turns) return std::nullopt;
  return std::abs(to_double(angle - Rational(*turns) * right_angle()));
}

Eigen::Vector3d to_vector(const ExactVector& v) {
  return {to_double(v[0]), to_double(v[1]), to_double(v[2])};
}

Eigen::Matrix3d rotation(const ExactVector& rpy) {
  const Eigen::Vector3d angles = to_vector(rpy);
  return (Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

}  // namespace moivre
