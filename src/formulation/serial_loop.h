// SPDX-License-Identifier: MIT
// Which polynomials close one loop of turns and slides? Half angles of four joints, four equations:
// 24 paths for six axes.
//
// The loop:  E_1 E_2 ... E_k ~ G,   E_i = (1 + t_i A_i),  A_i the joint's axis as it stands before
//                                   anything turns, A_i^2 = -1
// (a slide: A_i = eps d / 2, A_i^2 = 0).
// Two joints in a row are a dyad: all its poses lie in the 3-space spanned by 1, A, B, AB, on the
// quadric c00 c11 = c01 c10 of its coordinates c_ij [HustyPfurnerSchroecker07]. So for six joints
//     E_1 E_2 E_3 E_4 = G conj(E_6) conj(E_5)   in W, the 3-space of joints 5 and 6:   n_k . (E_1
//                                               E_2 E_3 E_4) = 0,  k = 1..4,
// four equations in t_1 ... t_4, linear in each: 4! = 24 paths, 16 of which are closures of a
// general arm; at the other eight tangents are +-i, where the product is zero. t_5 and t_6 follow
// linearly. Any six consecutive joints of the loop, from any of them and either way round, can be
// 1..6: the rule takes those whose W lies farthest from Study's quadric, where it would say too
// little.
// Where joints 4, 5, 6 are parallel or meet in a point (a spherical wrist), their product stays in
// one 3-space V. With the dyad D of joints 2 and 3, whose coordinates c are then the unknowns, as
// many equations as unknowns say it:
//     n_k . (E_1 D) = 0,  k = 1..4:  4 paths,   then   conj(E_4) v in the 3-space of 5 and 6:  2
//                                               paths each.
// Where every two neighbours are parallel or meet, each W lies in Study's quadric, and D's 3-space
// too. Then the same is said with E_1 E_2 E_3 for E_1 D, one equation too many, or, without three
// such joints, with the quadric of joints 5 and 6 beside the four of W:
// these loops have no certificates.
// Loops of three to five joints are stated alike; they hold more equations than unknowns, unless
// all axes meet or are parallel.
// Two slides are no dyad, since A B = 0. Loops of slides alone are linear.
// Symbols: E, A, G, D dual quaternions (dual_quaternion.h); n_k, 8 numbers each, orthogonal to W.
#pragma once

#include <optional>
#include <vector>

#include "spatial_tree.h"

namespace moivre {

/// The ties of a part in their order round the loop, each seen from where one comes; nothing where
/// the part is no single loop of hinges through the ground with three to six freedoms.
std::optional<std::vector<Tie>> loop_of(const RigidGroups& groups, const Part& part);

void add_loop(SpatialFrame& frame, const RigidGroups& groups, const std::vector<Tie>& loop);

}  // namespace moivre
