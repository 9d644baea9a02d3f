// SPDX-License-Identifier: MIT
// Both places over one denominator.
#include "turned_places.h"

namespace moivre {

RationalPlace place_of(const MovingPose& pose) {
  return {scaled(real_constant(2), product(pose.g, conjugate(pose.q))), dot(pose.q, pose.q)};
}

RationalPlace direction_of(const MovingPose& pose) {
  const Quaternion<Polynomial> k = to_moving(ExactPose{{0, 0, 0, 1}, {}}).q;
  return {product(product(pose.q, k), conjugate(pose.q)), dot(pose.q, pose.q)};
}

void add_turn_equation(SpatialFrame& frame, const std::string& name, const MovingPose& turn,
                       const RationalPlace& from, const RationalPlace& to) {
  const Quaternion<Polynomial> w = scaled(to.denominator, from.numerator);
  const Quaternion<Polynomial> b = scaled(from.denominator, to.numerator);
  const Polynomial& c = turn.q[0];
  const Polynomial& s = turn.q[3];
  const Polynomial x = c * (w[1] - b[1]) - s * (w[2] + b[2]);
  const Polynomial y = c * (w[2] - b[2]) + s * (w[1] + b[1]);
  // Numbers in 64ths alone make nothing of round lengths by chance: a posture had any first turn.
  Rational share = frame.random_number();
  for (int k = 0; k < 2; ++k) share *= frame.random_number();
  frame.add_equation(name + ": turn",
                     real_constant(share) * x + real_constant(frame.random_number()) * y);
}

}  // namespace moivre
