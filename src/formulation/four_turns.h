// SPDX-License-Identifier: MIT
// Which equations has a loop of four turns and two slides? Those of the turns, from which the
// slides follow linearly.
//
// Begun with a slide: S_1 T_1 T_2 T_3 T_4 ~ w, with S_2 somewhere among the turns. Let c be the
// four coordinates of the dyad T_1 T_2 (loop_equations.h), d those of T_3 T_4. Turns alone,
// quaternions q:
//   q(T_3 T_4) = conj(q(T_1 T_2)) q(w)       d is linear in c
//   c_0 c_3 = c_1 c_2,  d_0 d_3 = d_1 d_2    two quadrics in P^3: the curve of a spherical four-bar
// Shifts, beside q(w), as vectors:  v_0(c) + s_1 N(c) a_1 + s_2 v_2(c) = 0,  N = |q(T_1 T_2)|^2,
//                                   a_1 constant. So
//   det [v_0 a_1 v_2] = 0                    quartic in c; quadratic where no turn stands between
//                                            the slides
// 16 paths, and 8 closures [RaghavanRoth93]; at the other 8 roots N = 0, which is no turn. Slides
// never go to infinity, since they are no unknowns of it.
// Not where T_1 and T_2, or T_3 and T_4, are parallel whichever slide comes first.
#pragma once

#include <optional>

#include "joint_loop.h"

namespace moivre {

/// The loop begun with the slide that leaves the dyads farthest from parallel; nullopt where it has
/// not four turns and two slides, or none does.
std::optional<JointLoop> begun_with_slide(const JointLoop& loop);

/// Of a loop that begins so. Its slides have o = 0.
void add_four_turns(SpatialFrame& frame, const JointLoop& begun);

}  // namespace moivre
