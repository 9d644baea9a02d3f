// SPDX-License-Identifier: MIT
// Which joint values does a formula propose, where three neighbouring joints make a group? Up to
// eight, complex ones too.
//
//   J_1 D J_2 D J_3 D_0 J_a D_1 J_b D_2 J_c D_3 = 1:  the loop of arm and pose from the group's
//   first joint on, axes along z
// A wrist (its axes meet) leaves one point w where it is, parallel axes one plane. So J_a D_1 J_b
// D_2 J_c takes v = D_3 w to p = D_0^-1 w. What J_a cannot change, the height along its axis and
// the distance from a point of it (of a plane: slope and offset), is, with Z a turn about z by the
// joint's value and y = D_2 Z_c v,
//   e_i . Z_b y = f_i,  i = 1, 2,  y and f_i linear in (1, cos, sin) of c, e_i of the axes a and b
//                                  alone, across z.
//   e_1, e_2 dependent (the axes meet or are parallel)  without Z_b y: a quadratic for c; then one
//   for b
//   otherwise                                            |E^-1 f| = |y|: a quartic for c; b is
//   given
// Then a, and the group: its middle joint by a quadratic, the others by what is left. Backwards the
// loop has the same form; the way with e_1, e_2 dependent is taken, if there is one.
// The geometry is the one that the file's digits stand for. Nothing is decided here: what is
// proposed must be put right on the arm as typed, and counted. Where a divisor is 0 numbers are not
// finite, or fewer.
// Not supported: slides.
// Sources: [Pieper68].
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "cut.h"

namespace moivre {

/// From behind a joint to the next one, both axes along z; lengths relative to the arm's.
struct JointLink {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
};

/// A point, or the plane v . x = offset.
struct PointOrPlane {
  Eigen::Vector3d v;
  double offset = 0;
};

struct GroupFormula {
  std::array<JointLink, 6> before;  ///< each joint; the first from the base
  JointLink tip;                    ///< behind the last joint
  double length = 1;                ///< the arm's
  std::size_t first = 0;            ///< of the group
  bool is_wrist = true;
  PointOrPlane kept_before,
      kept_behind;  ///< what the group leaves, before its first joint and behind its last one
  bool is_backwards = false;
};

struct ProposedClosures {
  static constexpr std::size_t kMost = 16;
  std::array<Eigen::Matrix<double, 6, 1>, kMost> real;
  std::array<Eigen::Matrix<Complex, 6, 1>, kMost> pairs;  ///< one of two conjugate ones
  std::size_t reals = 0, pair_count = 0;
};

/// nullopt where the cut is at no group of three turns, or a joint outside is a slide.
std::optional<GroupFormula> group_formula(const Arm& arm, const Cut& cut);

ProposedClosures proposed_closures(const GroupFormula& formula, const Eigen::Isometry3d& pose);

}  // namespace moivre
