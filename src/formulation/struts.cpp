// SPDX-License-Identifier: MIT
// Points in the frame of a universal joint, as numerators over |q|^2.
#include "struts.h"

#include <algorithm>

namespace moivre {
namespace {

/// Where a frame's origin is: 2 g conj(q) / |q|^2, its first number 0.
struct Place {
  Quaternion<Polynomial> numerator;
  Polynomial denominator;
};

Place place_of(const MovingPose& pose) {
  return {scaled(real_constant(2), product(pose.g, conjugate(pose.q))), dot(pose.q, pose.q)};
}

}  // namespace

void add_postures(SpatialFrame& frame, const RigidGroups& groups, const Strut& strut,
                  const MovingPose& k_in_i) {
  const Tie& cross = strut.cross;
  const std::vector<std::string>& owners = groups.bodies[cross.j];
  const Rational fixed_1 = frame.random_number();
  const Rational fixed_2 = frame.random_number();
  const Polynomial t2 = frame.add_turn("t2_" + cross.name, owners);
  const MovingPose second = to_moving(tilt(cross.half_tangent)) * turn_of(t2, fixed_2);
  const Place before = place_of(second * to_moving(conjugate(cross.at_j) * strut.ball.at_j));
  const Place there =
      place_of(to_moving(conjugate(cross.at_i)) * k_in_i * to_moving(strut.ball.at_i));
  const Quaternion<Polynomial> w = scaled(there.denominator, before.numerator);
  const Quaternion<Polynomial> b = scaled(before.denominator, there.numerator);
  frame.add_equation(cross.name + ": height", w[3] - b[3]);

  const Polynomial t1 = frame.add_turn("t1_" + cross.name, owners);
  const MovingPose first = turn_of(t1, fixed_1);
  const Polynomial& c = first.q[0];
  const Polynomial& s = first.q[3];
  const Polynomial x = c * (w[1] - b[1]) - s * (w[2] + b[2]);
  const Polynomial y = c * (w[2] - b[2]) + s * (w[1] + b[1]);
  frame.add_equation(cross.name + ": turn", real_constant(frame.random_number()) * x +
                                                real_constant(frame.random_number()) * y);
  frame.place(cross.j, cross.i,
              to_moving(cross.at_i) * first * second * to_moving(conjugate(cross.at_j)));
}

Polynomial meeting_equation(SpatialFrame& frame, const Tie& tie, const MovingPose& j_in_i) {
  const MovingPose moved = to_moving(conjugate(tie.at_i)) * j_in_i * to_moving(tie.at_j);
  const Quaternion<Polynomial> k = to_moving(ExactPose{{0, 0, 0, 1}, {}}).q;
  const Polynomial moment = sum(product(product(moved.q, k), conjugate(moved.g)),
                                product(product(moved.g, k), conjugate(moved.q)))[3];
  double turn = 0;
  for (const Polynomial& p : moved.q) turn = std::max(turn, largest_coefficient(p));
  return frame.without_rounding(moment, turn * turn * frame.length());
}

}  // namespace moivre
