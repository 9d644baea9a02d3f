// SPDX-License-Identifier: MIT
// Which bodies of a spatial mechanism does nothing move apart, and what ties these groups? Drivers
// stand.
//
// A weld, a driven revolute or prismatic joint and a cylindrical one that is driven both ways join
// two bodies to one group; a cylindrical joint that is driven one way is a prismatic or a revolute
// one. What is left are ties between groups, each with an exact frame in both (z the joint's axis):
//   pose of group j in group i  ~  at_i M conj(at_j),   M by the tie's place and turn:
//   turns about the axis  1 + t k        slides along it  1 + eps s k / 2
// A tie is what is left of a joint (mechanism/joint_type.h), or one of:
//   a rod      at a distance, turning freely
//   a cone     at a point, two turns about axes that keep their angle (universal: 90 deg)
//   a meeting  anywhere, turning freely, but so that the z axes, as lines, meet
// A screw that is not driven ties an angle to a length, which no polynomial says: refused.
// Links that say no more than a distance or an angle are replaced by it, and placed by their points
// afterwards:
//   a group held by two spherical joints alone    a rod; its spin is free and moves nothing else
//   a group held by three spherical joints alone  three rods
//   a group held by two revolute joints whose axes meet, in a mechanism of several loops    a cone
//   a strut, a group held by a universal joint and another joint at a point, in a mechanism of
//   several loops:
//     spherical                                   a rod
//     universal, with axes of the strut that are parallel and across its length    a rod, and two
//     lines that meet
//   a leg, two groups between three revolute joints whose axes are parallel, in a mechanism of
//   several loops    a planar joint
//   a four-bar, four groups in a plane that holds the lines of its two outer revolute joints, in a
//   mechanism of several loops    two rods, between points of these lines, and two lines that meet
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "exact_pose.h"
#include "moivre/formulation/pose_reading.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/mechanism.h"

namespace moivre {

struct Tie {
  JointPlace place = JointPlace::at_point;
  JointTurn turn = JointTurn::about_axis;
  bool is_reversed = false;  ///< the line or plane is fixed in group j
  std::string name;
  std::size_t i = 0, j = 0;  ///< groups
  ExactPose at_i, at_j;
  Rational square = 0;        ///< rod: the length's
  Rational half_tangent = 1;  ///< cone: tan of half the angle of its axes
};

/// Freedoms that a tie leaves.
std::size_t freedom(const Tie& tie);

/// Of these, turns.
std::size_t turn_freedom(const Tie& tie);

bool is_rod(const Tie& tie);
bool is_meeting(const Tie& tie);
/// Whether it holds one number alone: an equation, no motion for a tree.
bool is_loose(const Tie& tie);

/// The same tie seen from the other end.
Tie reversed(const Tie& tie);

/// A driven coordinate of a point: `axis` 0, 1, 2 of `point` of `group` is `value`.
struct DrivenPoint {
  std::string name;
  std::size_t group = 0;
  ExactPose point;
  std::size_t axis = 0;
  Rational value;
};

/// Its ties are seen from the groups it joins.
struct Strut {
  Tie cross;  ///< universal
  Tie ball;   ///< the other, of which the point counts
};

/// Its outer ties are seen from the groups it joins, the middle one from the first link.
struct PlanarLeg {
  Tie first, middle, last;
};

/// A bar and a foot, joined by two links: a parallelogram, say. All ties are seen from the groups
/// that are nearer to those it joins.
struct FourBarLeg {
  struct Link {
    Tie root;    ///< from the bar
    Tie tip;     ///< from the foot
    Tie corner;  ///< the point of its far hinge on the line of the foot's, from the group there
  };
  Tie bar, foot;
  std::array<Link, 2> links;
};

struct RigidGroups {
  std::vector<std::string> names;                ///< of each group: its first body; 0 the ground
  std::vector<std::vector<std::string>> bodies;  ///< of each group
  std::vector<std::size_t> group_of;             ///< each body
  std::vector<ExactPose> in_group;               ///< each body's frame in its group's
  std::vector<Tie> ties;
  std::vector<DrivenPoint> driven_points;
  /// No joint's frame was rounded, and no turn: what is made of them alone is what was typed.
  bool has_exact_frames = true;
  std::vector<bool> is_left_out;              ///< of each group: a link that became a tie
  std::vector<PoseReading::Placement> links;  ///< of these, but for struts, legs and four-bars
  std::vector<Strut> struts;
  std::vector<PlanarLeg> legs;
  std::vector<FourBarLeg> four_bars;
  std::vector<std::string> contradictions;  ///< as in Formulation
  std::vector<std::pair<std::string, std::string>> left_out;
};

/// Throws std::invalid_argument where a screw is not driven.
RigidGroups rigid_groups(const Mechanism& mechanism, double t);

/// Replaces links between spherical joints by rods.
void leave_out_rods(RigidGroups& groups);
// Axes are parallel, across or meet to `rounding`, in radians or relative to the link's size.
/// Replaces links of `among` by cones.
void leave_out_cones(RigidGroups& groups, const std::vector<std::size_t>& among, double rounding);
/// Replaces struts of `among` by rods and meetings.
void leave_out_struts(RigidGroups& groups, const std::vector<std::size_t>& among, double rounding);
/// Replaces four-bars whose bar or foot is one of `among` by rods and meetings.
void leave_out_four_bars(RigidGroups& groups, const std::vector<std::size_t>& among,
                         double rounding);
/// Replaces legs that begin with a link of `among` by planar joints.
void leave_out_legs(RigidGroups& groups, const std::vector<std::size_t>& among, double rounding);

}  // namespace moivre
