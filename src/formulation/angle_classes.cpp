// SPDX-License-Identifier: MIT
// Union-find over bodies with the angle between a body and its parent; smaller numbers are roots.
#include "angle_classes.h"

#include <complex>

namespace moivre {
namespace {

// Angles are doubles of the file, turned to radians and added along a chain: they differ by far
// less when they agree.
constexpr double kSameAngle = 1e-11;

}  // namespace

AngleClasses::AngleClasses(std::size_t nodes) {
  for (std::size_t node = 0; node < nodes; ++node) up_.push_back({node, {}});
}

SharedAngle AngleClasses::find(std::size_t node) const {
  SharedAngle angle = up_[node];
  while (up_[angle.root].root != angle.root) {
    const SharedAngle& step = up_[angle.root];
    angle = {step.root, angle.factor * step.factor};
  }
  return angle;
}

AngleClasses::Verdict AngleClasses::join(std::size_t i, std::size_t j, const EnclosedUnit& factor) {
  const SharedAngle a = find(i);
  const SharedAngle b = find(j);
  // t_j = factor * t_i, so that t_root(b) = t_j / b = factor * a / b * t_root(a).
  const EnclosedUnit between = factor * a.factor * conjugate(b.factor);
  if (a.root == b.root) {
    const bool agrees = std::abs(to_complex(between.value - Coefficient{1, 0})) <= kSameAngle;
    return agrees ? Verdict::repeated : Verdict::contradiction;
  }
  if (a.root < b.root) {
    up_[b.root] = {a.root, between};
  } else {
    up_[a.root] = {b.root, conjugate(between)};
  }
  return Verdict::joined;
}

}  // namespace moivre
