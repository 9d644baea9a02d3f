// SPDX-License-Identifier: MIT
// What is a type of joint? Where it lets a point be and how it lets a body turn: one row of a table
// for each.
//
// A joint ties point A of its first body to point B of its second. Its axis, a unit vector in
// either body's frame, is a line through A and a normal of a plane through A. Rows of Phi, in the
// plane and in space:
//   place          plane space                       turn              plane space
//   anywhere         0     0                         freely              0     0
//   off_line         0         slide = AB . axis     about_two_axes            1   universal: the
//                              axes stay perpendicular
//   at_any_distance  0     0   slide = |AB|          about_axis          0     2   the plane's
//                              normal, or the joint's axis
//   at_distance      1     1   |AB| = L              by_thread                 3   about the axis,
//                              by the slide
//   in_plane               1                         by_rack             1         by the slide
//   on_line          1     2   slide = AB . axis     geared              1
//   at_point         2     3   A = B                 by_cam              1         a slide or an
//                              angle, by the cam's angle
//                                                    not_at_all          1     3   but
//                                                    Joint::turn_rad
// Coordinates: the slide, and the angle of about_axis and by_thread. "The" coordinate is the slide
// where there is one.
// Equations: planar_constraints.cpp, spatial_constraints.cpp; unknowns and polynomials: the module
// formulation.
#pragma once

#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

enum class JointPlace {
  anywhere,
  off_line,
  at_any_distance,
  at_distance,
  in_plane,
  on_line,
  at_point
};

enum class JointTurn {
  freely,
  about_two_axes,
  about_axis,
  by_thread,
  by_rack,
  by_cam,
  geared,
  not_at_all
};

struct JointTraits {
  JointType type;
  const char* name;  ///< in mechanism files
  JointPlace place;
  JointTurn turn;
  bool is_planar;   ///< exists in planar mechanisms
  bool is_spatial;  ///< in spatial ones
};

/// Of every type, in the order of the enumeration.
const std::vector<JointTraits>& all_joint_types();

const JointTraits& traits(JointType type);

bool exists_in(Space space, const JointTraits& type);

/// Rows of Phi, as in the table above.
int row_count(JointPlace place, Space space);
int row_count(JointTurn turn, Space space);

/// Degrees of freedom of one body relative to the other. Throws std::logic_error where the space
/// has no such joint.
int freedoms(JointType type, Space space);

/// Whether it reads a line, along which the second point is measured.
bool has_line(JointType type);
/// Whether it ties motions of bodies that other joints hold in their places.
bool is_transmission(JointType type);
/// Whether it holds something while nothing drives it.
bool has_rows(JointType type, Space space);

bool has_slide(JointType type);
bool has_angle(JointType type);
/// Whether the joint's coordinate is an angle.
bool is_angular(JointType type);

/// Directions that the type reads in space: one in each of so many bodies.
int axis_count(JointType type);

}  // namespace moivre
