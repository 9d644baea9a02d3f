// SPDX-License-Identifier: MIT
// Rational parts brought to one denominator; rotations as products of elementary ones.
#include "typed_displacement.h"

#include <algorithm>
#include <cmath>

#include "moivre/urdf/placement.h"

namespace moivre {
namespace {

/// Sines and cosines are kept to so many bits, more than their doubles have for any angle that is
/// not tiny.
constexpr std::size_t kTurnBits = 60;

Integer fixed_point(double x) { return {std::llround(std::ldexp(x, static_cast<int>(kTurnBits)))}; }

using RationalDisplacement = DualQuaternion<Rational>;

ExactDisplacement without_fractions(const RationalDisplacement& g) {
  return reduced(whole(g, common_denominator({g})));
}

/// cos and sin of half of k quarter turns, up to a positive factor.
ExactDisplacement quarters(int k, std::size_t axis) {
  constexpr std::array<std::array<int, 2>, 8> kHalves{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  const auto& half = kHalves[static_cast<std::size_t>(((k % 8) + 8) % 8)];
  ExactDisplacement turn;
  turn[0] = half[0];
  turn[1 + axis] = half[1];
  return turn;
}

ExactDisplacement elementary_turn(const Rational& angle, std::size_t axis) {
  if (const auto k = quarter_turns(angle)) return quarters(*k, axis);
  ExactDisplacement turn;
  turn[0] = fixed_point(std::cos(to_double(angle) / 2));
  turn[1 + axis] = fixed_point(std::sin(to_double(angle) / 2));
  return turn;
}

/// Any four numbers are a turn: products of turns are cut to kTurnBits. What is equal, or zero,
/// stays so.
ExactDisplacement cut_short(const ExactDisplacement& turn) {
  const ExactDisplacement result = reduced(turn);
  std::size_t bits = 0;
  for (const Integer& part : result.q) bits = std::max(bits, bit_length(part));
  if (bits <= kTurnBits) return result;
  const Integer unit = Integer(1) << static_cast<unsigned>(bits - kTurnBits);
  return reduced(mapped(result, [&](const Integer& part) { return Integer(part / unit); }));
}

ExactDisplacement translation(const Rational& x, const Rational& y, const Rational& z) {
  const Rational half(1, 2);
  return without_fractions({{1, 0, 0, 0}, {0, half * x, half * y, half * z}});
}

}  // namespace

ExactDisplacement in_unit(ExactDisplacement g, int exponent) {
  const auto shift = static_cast<unsigned>(std::abs(exponent));
  for (Integer& part : exponent > 0 ? g.q : g.g) part <<= shift;
  return reduced(g);
}

ExactDisplacement exact_origin(const ExactVector& xyz, const ExactVector& rpy) {
  const ExactDisplacement turn =
      elementary_turn(rpy[2], 2) * elementary_turn(rpy[1], 1) * elementary_turn(rpy[0], 0);
  return reduced(translation(xyz[0], xyz[1], xyz[2]) * cut_short(turn));
}

ExactDisplacement exact_turn(const ExactVector& axis, double angle) {
  const Rational c(std::cos(angle / 2));
  const Rational s(std::sin(angle / 2) / to_vector(axis).stableNorm());
  return without_fractions({{c, s * axis[0], s * axis[1], s * axis[2]}, {}});
}

ExactDisplacement exact_slide(const ExactVector& axis, double distance) {
  const Rational s(distance / to_vector(axis).stableNorm());
  return translation(s * axis[0], s * axis[1], s * axis[2]);
}

ExactDisplacement exact_pose(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  const RationalDisplacement turn{
      {Rational(q.w()), Rational(q.x()), Rational(q.y()), Rational(q.z())}, {}};
  const Eigen::Vector3d t = pose.translation();
  return reduced(translation(Rational(t.x()), Rational(t.y()), Rational(t.z())) *
                 without_fractions(turn));
}

ExactDisplacement exact_step(const ExactVector& axis, bool is_slide) {
  RationalDisplacement step;
  std::copy(axis.begin(), axis.end(), (is_slide ? step.g : step.q).begin() + 1);
  return without_fractions(step);
}

double exact_length(const ExactDisplacement& step, bool is_slide) {
  const auto part = [&](std::size_t k) {
    return to_double(ratio((is_slide ? step.g : step.q)[k]));
  };
  return Eigen::Vector3d(part(1), part(2), part(3)).stableNorm() * (is_slide ? 2 : 1);
}

}  // namespace moivre
