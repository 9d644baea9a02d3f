// SPDX-License-Identifier: MIT
// The plane of a four-bar, its foot in it, and its links one by one.
#include "four_bars.h"

#include <cmath>

#include "moivre/formulation/exact.h"
#include "turned_places.h"

namespace moivre {
namespace {

/// The frame whose z axis is the normal, which is across that of `line`: both fixed in one group.
MovingPose across_line(const ExactPose& line, const ExactPose& normal, bool is_opposite) {
  const DualQuaternion<double> between = to_double(conjugate(line) * normal);
  const Quaternion<double> k{0, 0, 0, 1};
  const Quaternion<double> along = product(product(between.q, k), conjugate(between.q));
  const double sign = is_opposite ? -1 : 1;
  return to_moving(turn_about_z(std::atan2(sign * along[2], sign * along[1])) * across(0));
}

bool are_opposite(const ExactPose& one, const ExactPose& other) {
  const Quaternion<double> q = to_double(conjugate(one) * other).q;
  return q[0] * q[0] + q[3] * q[3] < q[1] * q[1] + q[2] * q[2];
}

}  // namespace

void add_postures(SpatialFrame& frame, const RigidGroups& groups, const FourBarLeg& four_bar,
                  const MovingPose& k_in_i) {
  const auto& [bar, foot, links] = four_bar;
  const MovingPose end = to_moving(conjugate(bar.at_i)) * k_in_i * to_moving(foot.at_i);
  const FourBarLeg::Link& link = links.front();

  const Polynomial t1 = frame.add_turn("t_" + bar.name, groups.bodies[bar.j]);
  const MovingPose first = turn_of(t1, frame.random_number());
  const MovingPose normal = first * across_line(bar.at_j, link.root.at_i, false);
  const Rational length = frame.random_number() * typed_decimal(frame.length());
  const Quaternion<Polynomial> in_plane =
      sum(scaled(real_constant(frame.random_number()), place_of(end).numerator),
          scaled(real_constant(length), direction_of(end).numerator));
  frame.add_equation(bar.name + ": across", dot(direction_of(normal).numerator, in_plane));

  const Polynomial t2 = frame.add_turn("t_" + foot.name, groups.bodies[foot.j]);
  const MovingPose second = turn_of(t2, frame.random_number());
  const bool is_opposite = are_opposite(link.root.at_j, link.tip.at_j);
  add_turn_equation(frame, foot.name, second,
                    direction_of(across_line(foot.at_j, link.tip.at_i, is_opposite)),
                    direction_of(conjugate(end) * normal));

  const MovingPose bar_in_i = to_moving(bar.at_i) * first * to_moving(conjugate(bar.at_j));
  const MovingPose foot_in_k = to_moving(foot.at_i) * second * to_moving(conjugate(foot.at_j));
  const MovingPose k_in_bar = conjugate(bar_in_i) * k_in_i;
  frame.place(bar.j, bar.i, bar_in_i);
  frame.place(foot.j, foot.i, foot_in_k);
  for (const auto& [root, tip, corner] : links) {
    const Polynomial t = frame.add_turn("t_" + root.name, groups.bodies[root.j]);
    const MovingPose turn = turn_of(t, frame.random_number());
    add_turn_equation(
        frame, root.name, turn, place_of(to_moving(conjugate(root.at_j) * corner.at_j)),
        place_of(to_moving(conjugate(root.at_i)) * k_in_bar * to_moving(corner.at_i)));
    frame.place(root.j, root.i, to_moving(root.at_i) * turn * to_moving(conjugate(root.at_j)));
  }
}

}  // namespace moivre
