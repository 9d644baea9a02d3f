// SPDX-License-Identifier: MIT
// The loop of an arm and a pose, exact and rounded.
#include "loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact_motion.h"
#include "moivre/numeric/random.h"
#include "typed_displacement.h"

namespace moivre {
namespace {

/// Whole numbers up to this make the random angle from which a joint's turn is counted.
constexpr int kFinest = 1 << 10;

/// Counts the turn from a random angle: before J(x) = before J(zero) J(x - zero).
void shift_zero(LoopJoint& joint, std::uint64_t seed, std::size_t number) {
  const double at = random_unit(seed, RandomStream::arm, number);
  const auto c = static_cast<int>(std::lround(kFinest * std::cos(std::numbers::pi * at)));
  const auto s = static_cast<int>(std::lround(kFinest * std::sin(std::numbers::pi * at)));
  auto& [before, one, step] = joint.exact;
  ExactDisplacement turn = Integer(s) * step;
  turn.q[0] += c * one;
  before = reduced(before * turn);
  joint.zero = 2 * std::atan2(s * joint.exact_length, c);
}

}  // namespace

RealDisplacement unit(const RealDisplacement& g) { return 1 / column(g).norm() * g; }

Loop open_loop(const Arm& arm, std::uint64_t seed) {
  Loop loop;
  loop.unit_exponent = std::ilogb(arm.length);
  for (const ArmJoint& joint : arm.joints) {
    LoopJoint& added = loop.joints.emplace_back();
    auto& [before, one, step] = added.exact;
    before = in_unit(*joint.exact_before, loop.unit_exponent);
    one <<= static_cast<unsigned>(std::max(0, std::ilogb(joint.exact_length)));
    step = *joint.step;
    added.is_slide = joint.is_slide;
    added.exact_length = joint.exact_length / to_double(ratio(one));
    if (!joint.is_slide) shift_zero(added, seed, loop.joints.size() - 1);
    added.rounded.before = unit(rounded(before));
    added.rounded.step =
        mapped(step, [&](const Integer& part) { return to_double(ratio(part, added.exact.one)); });
  }
  return loop;
}

Loop make_loop(const Arm& arm, const Eigen::Isometry3d& pose, std::uint64_t seed) {
  Loop loop = open_loop(arm, seed);
  const ExactDisplacement back =
      in_unit(reduced(*arm.exact_tool * conjugate(exact_pose(pose))), loop.unit_exponent);
  LoopJoint& first = loop.joints.front();
  first.exact.before = reduced(back * first.exact.before);
  first.rounded.before = unit(rounded(first.exact.before));
  return loop;
}

ComplexDisplacement joint_displacement(const LoopJoint& joint, const Tangent& at) {
  ComplexDisplacement result = mapped(joint.rounded.step, [&](double part) { return at.s * part; });
  result.q[0] += at.c;
  return result;
}

Tangent unit(const LoopJoint& joint, const Tangent& at) {
  const double size = std::sqrt(std::norm(at.c) + std::norm(joint.exact_length * at.s));
  return {at.c / size, at.s / size};
}

double distance_from_null(const LoopJoint& joint, const Tangent& at) {
  const Complex s = joint.exact_length * at.s;
  return joint.is_slide ? std::abs(at.c) : std::abs(at.c * at.c + s * s);
}

double imaginary_part(const LoopJoint& joint, const Tangent& at) {
  return std::abs(std::imag(joint.exact_length * at.s * std::conj(at.c)));
}

double joint_value(const Loop& loop, std::size_t joint, const Tangent& at) {
  const LoopJoint& own = loop.joints[joint];
  const double product = std::real(own.exact_length * at.s * std::conj(at.c));
  if (own.is_slide) return std::ldexp(product / std::norm(at.c), loop.unit_exponent);
  const double angle = 2 * std::atan2(product, std::norm(at.c)) + own.zero;
  return std::remainder(angle, 2 * std::numbers::pi);
}

Complex complex_joint_value(const Loop& loop, std::size_t joint, const Tangent& at) {
  const LoopJoint& own = loop.joints[joint];
  const Complex s = own.exact_length * at.s;
  if (own.is_slide) return std::ldexp(1.0, loop.unit_exponent) * (s / at.c);
  const Complex i(0, 1);
  const Complex angle = -i * std::log((at.c + i * s) / (at.c - i * s)) + own.zero;
  return {std::remainder(angle.real(), 2 * std::numbers::pi), angle.imag()};
}

}  // namespace moivre
