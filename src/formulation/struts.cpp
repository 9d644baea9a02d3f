// SPDX-License-Identifier: MIT
// Points and directions in the frame of a universal joint, as numerators over |q|^2.
#include "struts.h"

#include <algorithm>

#include "moivre/formulation/exact.h"
#include "turned_places.h"

namespace moivre {
namespace {

/// Of the group at the strut's other end, in the frame of the cross's first axis.
MovingPose end_of(const Strut& strut, const MovingPose& k_in_i) {
  return to_moving(conjugate(strut.cross.at_i)) * k_in_i * to_moving(strut.ball.at_i);
}

/// The other end before any turn, in the frame of the cross's second axis.
MovingPose start_of(const Strut& strut) {
  return to_moving(conjugate(strut.cross.at_j) * strut.ball.at_j);
}

/// Places the strut by two turns.
void place_strut(SpatialFrame& frame, const Tie& cross, const MovingPose& first,
                 const MovingPose& second) {
  frame.place(cross.j, cross.i,
              to_moving(cross.at_i) * first * second * to_moving(conjugate(cross.at_j)));
}

void add_postures_of_ball(SpatialFrame& frame, const std::vector<std::string>& owners,
                          const Strut& strut, const MovingPose& k_in_i) {
  const Tie& cross = strut.cross;
  const Rational fixed_1 = frame.random_number();
  const Rational fixed_2 = frame.random_number();
  const Polynomial t2 = frame.add_turn("t2_" + cross.name, owners);
  const MovingPose second = to_moving(tilt(cross.half_tangent)) * turn_of(t2, fixed_2);
  const RationalPlace before = place_of(second * start_of(strut));
  const RationalPlace there = place_of(end_of(strut, k_in_i));
  frame.add_equation(cross.name + ": height", there.denominator * before.numerator[3] -
                                                  before.denominator * there.numerator[3]);

  const Polynomial t1 = frame.add_turn("t1_" + cross.name, owners);
  const MovingPose first = turn_of(t1, fixed_1);
  add_turn_equation(frame, cross.name, first, before, there);
  place_strut(frame, cross, first, second);
}

void add_postures_of_crosses(SpatialFrame& frame, const std::vector<std::string>& owners,
                             const Strut& strut, const MovingPose& k_in_i) {
  const Tie& cross = strut.cross;
  const MovingPose tilted = to_moving(tilt(cross.half_tangent));
  const MovingPose end = end_of(strut, k_in_i);
  const Polynomial t1 = frame.add_turn("t1_" + cross.name, owners);
  const MovingPose first = turn_of(t1, frame.random_number()) * tilted;
  const Rational length = frame.random_number() * typed_decimal(frame.length());
  const Quaternion<Polynomial> in_plane =
      sum(scaled(real_constant(frame.random_number()), place_of(end).numerator),
          scaled(real_constant(length), direction_of(end).numerator));
  frame.add_equation(cross.name + ": across", dot(direction_of(first).numerator, in_plane));

  const Polynomial t2 = frame.add_turn("t2_" + cross.name, owners);
  const MovingPose second = turn_of(t2, frame.random_number());
  add_turn_equation(frame, cross.name, second, place_of(start_of(strut)),
                    place_of(conjugate(first) * end));
  place_strut(frame, cross, first, second);
}

}  // namespace

void add_postures(SpatialFrame& frame, const RigidGroups& groups, const Strut& strut,
                  const MovingPose& k_in_i) {
  const std::vector<std::string>& owners = groups.bodies[strut.cross.j];
  if (strut.ball.turn == JointTurn::freely) {
    add_postures_of_ball(frame, owners, strut, k_in_i);
  } else {
    add_postures_of_crosses(frame, owners, strut, k_in_i);
  }
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
