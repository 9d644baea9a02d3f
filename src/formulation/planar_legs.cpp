// SPDX-License-Identifier: MIT
// The leg's far end, once through its links and once through what it joins.
#include "planar_legs.h"

#include "turned_places.h"

namespace moivre {

void add_postures(SpatialFrame& frame, const RigidGroups& groups, const PlanarLeg& leg,
                  const MovingPose& k_in_i) {
  const auto& [first, middle, last] = leg;
  const Polynomial t2 = frame.add_turn("t_" + middle.name, groups.bodies[middle.j]);
  const MovingPose bent = turn_of(t2, frame.random_number());
  const MovingPose before = to_moving(conjugate(first.at_j) * middle.at_i) * bent *
                            to_moving(conjugate(middle.at_j) * last.at_j);
  const MovingPose there = to_moving(conjugate(first.at_i)) * k_in_i * to_moving(last.at_i);
  frame.add_equation(middle.name + ": distance",
                     dot(before.g, before.g) * dot(there.q, there.q) -
                         dot(there.g, there.g) * dot(before.q, before.q));

  const Polynomial t1 = frame.add_turn("t_" + first.name, groups.bodies[first.j]);
  const MovingPose turn = turn_of(t1, frame.random_number());
  add_turn_equation(frame, first.name, turn, place_of(before), place_of(there));
  frame.place(first.j, first.i, to_moving(first.at_i) * turn * to_moving(conjugate(first.at_j)));
  frame.place(middle.j, middle.i,
              to_moving(middle.at_i) * bent * to_moving(conjugate(middle.at_j)));
}

}  // namespace moivre
