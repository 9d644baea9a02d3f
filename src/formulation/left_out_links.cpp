// SPDX-License-Identifier: MIT
// Which links say no more than a distance or an angle? They become rods, cones and meetings of
// lines.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "moivre/formulation/exact.h"
#include "rigid_groups.h"

namespace moivre {
namespace {

using Eigen::Vector3d;

/// Origin and z axis of a frame.
struct Axis {
  Vector3d at;
  Vector3d along;
};

Axis axis_of(const ExactPose& frame) {
  const DualQuaternion<double> pose = to_double(frame);
  const Quaternion<double> shift = shift_of(pose);
  const Eigen::Quaterniond turn(pose.q[0], pose.q[1], pose.q[2], pose.q[3]);
  return {{shift[1], shift[2], shift[3]}, turn.normalized() * Vector3d::UnitZ()};
}

Rational distance_squared(const ExactPose& a, const ExactPose& b) {
  const ExactPose apart = conjugate(a) * b;
  Rational square = 4 * dot(apart.g, apart.g);
  square /= dot(apart.q, apart.q);
  return square;
}

/// The ties of a group, each seen from the other group.
std::vector<Tie> ties_towards(const RigidGroups& groups, std::size_t group) {
  std::vector<Tie> found;
  for (const Tie& tie : groups.ties) {
    if (tie.i == group && tie.j == group) continue;
    if (tie.j == group) found.push_back(tie);
    if (tie.i == group) found.push_back(reversed(tie));
  }
  return found;
}

bool is_driven(const RigidGroups& groups, std::size_t group) {
  return std::any_of(groups.driven_points.begin(), groups.driven_points.end(),
                     [&](const DrivenPoint& point) { return point.group == group; });
}

void remove_ties(RigidGroups& groups, std::size_t group) {
  auto& ties = groups.ties;
  ties.erase(std::remove_if(ties.begin(), ties.end(),
                            [&](const Tie& tie) { return tie.i == group || tie.j == group; }),
             ties.end());
  groups.is_left_out[group] = true;
}

Tie rod_between(const Tie& a, const Tie& b, const std::string& name) {
  Tie rod;
  rod.place = JointPlace::at_distance;
  rod.turn = JointTurn::freely;
  rod.name = name;
  rod.i = a.i;
  rod.j = b.i;
  rod.at_i = a.at_i;
  rod.at_j = b.at_i;
  rod.square = distance_squared(a.at_j, b.at_j);
  return rod;
}

PoseReading::Placement by_points(std::size_t group, const std::vector<Tie>& ties) {
  PoseReading::Placement placement;
  placement.group = group;
  for (const Tie& tie : ties) {
    placement.points.push_back({axis_of(tie.at_j).at, tie.i, axis_of(tie.at_i).at});
  }
  return placement;
}

/// So many spherical joints, two or three, and nothing else.
void leave_out_link_of_balls(RigidGroups& groups, std::size_t group, std::size_t balls) {
  const std::vector<Tie> ties = ties_towards(groups, group);
  const bool are_spherical = std::all_of(ties.begin(), ties.end(), [](const Tie& tie) {
    return tie.place == JointPlace::at_point && tie.turn == JointTurn::freely;
  });
  if (!are_spherical || ties.size() != balls) return;
  for (std::size_t a = 0; a < ties.size(); ++a) {
    for (std::size_t b = a + 1; b < ties.size(); ++b) {
      if (ties[a].i == ties[b].i || distance_squared(ties[a].at_j, ties[b].at_j) == 0) return;
    }
  }
  groups.links.push_back(by_points(group, ties));
  remove_ties(groups, group);
  const std::string& name = groups.names[group];
  groups.ties.push_back(rod_between(ties[0], ties[1], name));
  if (ties.size() == 2) {
    groups.left_out.emplace_back(name, "between two spherical joints it is one distance");
    return;
  }
  groups.ties.push_back(rod_between(ties[1], ties[2], name));
  groups.ties.push_back(rod_between(ties[2], ties[0], name));
  groups.left_out.emplace_back(name, "between three spherical joints it is three distances");
}

bool is_hinge(const Tie& tie) {
  return tie.place == JointPlace::at_point && tie.turn == JointTurn::about_axis;
}

/// A shift along the frame's z axis.
ExactPose moved_along(const ExactPose& frame, double length) {
  return frame * ExactPose{{1, 0, 0, 0}, {0, 0, 0, Rational(length) * Rational(1, 2)}};
}

/// Two revolute joints whose axes meet: the point stays, and so does the angle.
void leave_out_cone(RigidGroups& groups, std::size_t group) {
  // Axes that miss each other by this part of the link's size are meant to meet.
  constexpr double kMeet = 1e-11;
  std::vector<Tie> ties = ties_towards(groups, group);
  if (ties.size() != 2 || ties[0].i == ties[1].i) return;
  if (!is_hinge(ties[0]) || !is_hinge(ties[1])) return;
  const Axis a = axis_of(ties[0].at_j);
  const Axis b = axis_of(ties[1].at_j);
  const Vector3d normal = a.along.cross(b.along);
  const Vector3d apart = b.at - a.at;
  const double size = std::max(apart.norm(), std::max(a.at.norm(), b.at.norm()));
  const double sine = normal.norm();
  if (sine <= kMeet || std::abs(apart.dot(normal)) > kMeet * sine * size) return;
  const double along_a = apart.cross(b.along).dot(normal) / (sine * sine);
  const double along_b = apart.cross(a.along).dot(normal) / (sine * sine);
  for (auto [tie, along] : {std::pair(&ties[0], along_a), std::pair(&ties[1], along_b)}) {
    tie->at_i = moved_along(tie->at_i, along);
    tie->at_j = moved_along(tie->at_j, along);
  }
  PoseReading::Placement placement = by_points(group, {ties[0]});
  for (const Tie& tie : ties) {
    const Axis here = axis_of(tie.at_j);
    const Axis there = axis_of(tie.at_i);
    placement.points.push_back({here.at + here.along, tie.i, there.at + there.along});
  }
  groups.links.push_back(std::move(placement));
  remove_ties(groups, group);
  Tie cone;
  cone.turn = JointTurn::about_two_axes;
  cone.name = groups.names[group];
  cone.i = ties[0].i;
  cone.j = ties[1].i;
  cone.at_i = ties[0].at_i;
  cone.at_j = ties[1].at_i;
  const double cosine = a.along.dot(b.along);
  cone.half_tangent = without_noise(std::sqrt((1 - cosine) / (1 + cosine)));
  groups.ties.push_back(std::move(cone));
  groups.left_out.emplace_back(groups.names[group], "its two axes meet: it is one angle");
}

/// Whether the far end of a strut lies on neither its second axis nor the first end.
bool is_armed(const Strut& strut) {
  // Nearer, the turn about the second axis moves the far end by less than half the digits tell.
  constexpr double kBeside = 1e-9;
  const Axis axis = axis_of(strut.cross.at_j);
  const Vector3d arm = axis_of(strut.ball.at_j).at - axis.at;
  return arm.cross(axis.along).norm() > kBeside * arm.norm();
}

/// Whether a strut's own axes are parallel to each other and across its length, and the axes of
/// both crosses perpendicular.
bool is_flat(const Strut& strut) {
  constexpr double kAcross = 1e-11;
  const Axis near = axis_of(strut.cross.at_j);
  const Axis far = axis_of(strut.ball.at_j);
  const Vector3d arm = far.at - near.at;
  return near.along.cross(far.along).norm() <= kAcross &&
         std::abs(arm.dot(near.along)) <= kAcross * arm.norm() && strut.cross.half_tangent == 1 &&
         strut.ball.half_tangent == 1;
}

Tie meeting_of(const Strut& strut, const std::string& name) {
  Tie meeting;
  meeting.place = JointPlace::anywhere;
  meeting.turn = JointTurn::freely;
  meeting.name = name;
  meeting.i = strut.cross.i;
  meeting.j = strut.ball.i;
  meeting.at_i = strut.cross.at_i;
  meeting.at_j = strut.ball.at_i;
  return meeting;
}

void leave_out_strut(RigidGroups& groups, std::size_t group) {
  std::vector<Tie> ties = ties_towards(groups, group);
  if (ties.size() != 2 || ties[0].i == ties[1].i) return;
  const auto is_cross = [](const Tie& tie) {
    return tie.place == JointPlace::at_point && tie.turn == JointTurn::about_two_axes;
  };
  const auto is_ball = [](const Tie& tie) {
    return tie.place == JointPlace::at_point && tie.turn == JointTurn::freely;
  };
  if (!is_cross(ties[0])) std::swap(ties[0], ties[1]);
  const Strut strut{ties[0], ties[1]};
  const bool has_ball = is_ball(strut.ball);
  if (!is_cross(strut.cross) || !is_armed(strut)) return;
  if (!has_ball && !(is_cross(strut.ball) && is_flat(strut))) return;
  const std::string& name = groups.names[group];
  remove_ties(groups, group);
  groups.struts.push_back(strut);
  groups.ties.push_back(rod_between(strut.cross, strut.ball, name));
  if (!has_ball) groups.ties.push_back(meeting_of(strut, name));
  groups.left_out.emplace_back(
      name, has_ball
                ? "between a universal and a spherical joint it is one distance, in two postures"
                : "between two universal joints it is one distance and two lines that meet, in two "
                  "postures");
}

/// Whether both axes of a link are parallel, and apart.
bool are_parallel_and_apart(const ExactPose& one, const ExactPose& other) {
  constexpr double kParallel = 1e-11;
  // Nearer, the link's turn moves its far hinge by less than half the digits tell.
  constexpr double kApart = 1e-9;
  const Axis a = axis_of(one);
  const Axis b = axis_of(other);
  const Vector3d arm = b.at - a.at;
  return a.along.cross(b.along).norm() <= kParallel &&
         arm.cross(a.along).norm() > kApart * std::max({arm.norm(), a.at.norm(), b.at.norm()});
}

void leave_out_leg(RigidGroups& groups, std::size_t group) {
  const auto is_link = [&](std::size_t link) {
    const std::vector<Tie> ties = ties_towards(groups, link);
    return link != 0 && !is_driven(groups, link) && ties.size() == 2 && is_hinge(ties[0]) &&
           is_hinge(ties[1]) && are_parallel_and_apart(ties[0].at_j, ties[1].at_j);
  };
  if (!is_link(group)) return;
  std::vector<Tie> ties = ties_towards(groups, group);
  if (!is_link(ties[1].i)) std::swap(ties[0], ties[1]);
  const std::size_t next = ties[1].i;
  if (!is_link(next)) return;
  const std::vector<Tie> of_next = ties_towards(groups, next);
  const Tie& last = of_next[0].i == group ? of_next[1] : of_next[0];
  const PlanarLeg leg{ties[0], reversed(ties[1]), last};
  if (leg.first.i == leg.last.i || leg.first.i == next || leg.last.i == group) return;
  remove_ties(groups, group);
  remove_ties(groups, next);
  Tie plane;
  plane.place = JointPlace::in_plane;
  plane.turn = JointTurn::about_axis;
  plane.name = groups.names[group];
  plane.i = leg.first.i;
  plane.j = leg.last.i;
  plane.at_i = leg.first.at_i;
  plane.at_j = leg.last.at_i * conjugate(conjugate(leg.first.at_j) * leg.middle.at_i *
                                         conjugate(leg.middle.at_j) * leg.last.at_j);
  groups.ties.push_back(std::move(plane));
  groups.left_out.emplace_back(
      groups.names[group] + " and " + groups.names[next],
      "between three parallel hinges they are one planar joint, in two postures");
  groups.legs.push_back(leg);
}

}  // namespace

// Rods first: three distances to a point of a link that a distance may replace would leave its turn
// about the other point free.
void leave_out_rods(RigidGroups& groups) {
  for (const std::size_t balls : {2U, 3U}) {
    for (std::size_t group = 1; group < groups.names.size(); ++group) {
      const bool may_go = !groups.is_left_out[group] && !is_driven(groups, group);
      if (may_go) leave_out_link_of_balls(groups, group, balls);
    }
  }
}

void leave_out_cones(RigidGroups& groups, const std::vector<std::size_t>& among) {
  for (const std::size_t group : among) {
    if (!groups.is_left_out[group] && !is_driven(groups, group)) leave_out_cone(groups, group);
  }
}

void leave_out_struts(RigidGroups& groups, const std::vector<std::size_t>& among) {
  for (const std::size_t group : among) {
    if (!groups.is_left_out[group] && !is_driven(groups, group)) leave_out_strut(groups, group);
  }
}

void leave_out_legs(RigidGroups& groups, const std::vector<std::size_t>& among) {
  for (const std::size_t group : among) {
    if (!groups.is_left_out[group]) leave_out_leg(groups, group);
  }
}

}  // namespace moivre
