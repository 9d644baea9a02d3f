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

/// Where two lines meet, along each of them.
struct Crossing {
  double along_a, along_b;
};

/// Where they miss each other by no more than this part of the link's size.
std::optional<Crossing> crossing_of(const Axis& a, const Axis& b, double rounding) {
  const Vector3d normal = a.along.cross(b.along);
  const Vector3d apart = b.at - a.at;
  const double size = std::max(apart.norm(), std::max(a.at.norm(), b.at.norm()));
  const double sine = normal.norm();
  if (sine <= rounding || std::abs(apart.dot(normal)) > rounding * sine * size) return std::nullopt;
  return Crossing{apart.cross(b.along).dot(normal) / (sine * sine),
                  apart.cross(a.along).dot(normal) / (sine * sine)};
}

/// Two revolute joints whose axes meet: the point stays, and so does the angle.
void leave_out_cone(RigidGroups& groups, std::size_t group, double rounding) {
  std::vector<Tie> ties = ties_towards(groups, group);
  if (ties.size() != 2 || ties[0].i == ties[1].i) return;
  if (!is_hinge(ties[0]) || !is_hinge(ties[1])) return;
  const Axis a = axis_of(ties[0].at_j);
  const Axis b = axis_of(ties[1].at_j);
  const auto crossing = crossing_of(a, b, rounding);
  if (!crossing) return;
  for (auto [tie, along] :
       {std::pair(&ties[0], crossing->along_a), std::pair(&ties[1], crossing->along_b)}) {
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
bool is_flat(const Strut& strut, double rounding) {
  const Axis near = axis_of(strut.cross.at_j);
  const Axis far = axis_of(strut.ball.at_j);
  const Vector3d arm = far.at - near.at;
  return near.along.cross(far.along).norm() <= rounding &&
         std::abs(arm.dot(near.along)) <= rounding * arm.norm() && strut.cross.half_tangent == 1 &&
         strut.ball.half_tangent == 1;
}

/// The lines of the outer axes meet.
Tie meeting_of(const Tie& a, const Tie& b, const std::string& name) {
  Tie meeting;
  meeting.place = JointPlace::anywhere;
  meeting.turn = JointTurn::freely;
  meeting.name = name;
  meeting.i = a.i;
  meeting.j = b.i;
  meeting.at_i = a.at_i;
  meeting.at_j = b.at_i;
  return meeting;
}

void leave_out_strut(RigidGroups& groups, std::size_t group, double rounding) {
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
  if (!has_ball && !(is_cross(strut.ball) && is_flat(strut, rounding))) return;
  const std::string& name = groups.names[group];
  remove_ties(groups, group);
  groups.struts.push_back(strut);
  groups.ties.push_back(rod_between(strut.cross, strut.ball, name));
  if (!has_ball) groups.ties.push_back(meeting_of(strut.cross, strut.ball, name));
  groups.left_out.emplace_back(
      name, has_ball
                ? "between a universal and a spherical joint it is one distance, in two postures"
                : "between two universal joints it is one distance and two lines that meet, in two "
                  "postures");
}

/// Whether both axes of a link are parallel, and apart.
bool are_parallel_and_apart(const ExactPose& one, const ExactPose& other, double rounding) {
  // Nearer, the link's turn moves its far hinge by less than half the digits tell.
  constexpr double kApart = 1e-9;
  const Axis a = axis_of(one);
  const Axis b = axis_of(other);
  const Vector3d arm = b.at - a.at;
  return a.along.cross(b.along).norm() <= rounding &&
         arm.cross(a.along).norm() > kApart * std::max({arm.norm(), a.at.norm(), b.at.norm()});
}

/// Whether nothing but two parallel hinges holds a group.
bool is_flat_link(const RigidGroups& groups, std::size_t link, double rounding) {
  const std::vector<Tie> ties = ties_towards(groups, link);
  return link != 0 && !is_driven(groups, link) && ties.size() == 2 && is_hinge(ties[0]) &&
         is_hinge(ties[1]) && are_parallel_and_apart(ties[0].at_j, ties[1].at_j, rounding);
}

void leave_out_leg(RigidGroups& groups, std::size_t group, double rounding) {
  if (!is_flat_link(groups, group, rounding)) return;
  std::vector<Tie> ties = ties_towards(groups, group);
  if (!is_flat_link(groups, ties[1].i, rounding)) std::swap(ties[0], ties[1]);
  const std::size_t next = ties[1].i;
  if (!is_flat_link(groups, next, rounding)) return;
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

/// The three hinges of a bar or a foot: the outer one first.
std::optional<std::vector<Tie>> outer_tie_first(const RigidGroups& groups, std::size_t group,
                                                const std::array<std::size_t, 2>& links) {
  std::vector<Tie> ties = ties_towards(groups, group);
  if (ties.size() != 3 || !std::all_of(ties.begin(), ties.end(), is_hinge)) return std::nullopt;
  const auto is_of_link = [&](const Tie& tie) { return tie.i == links[0] || tie.i == links[1]; };
  std::stable_partition(ties.begin(), ties.end(), [&](const Tie& tie) { return !is_of_link(tie); });
  if (is_of_link(ties[0]) || ties[1].i == ties[2].i) return std::nullopt;
  return ties;
}

/// The four-bar whose bar is this group, and whose foot comes after it.
std::optional<FourBarLeg> four_bar_of(const RigidGroups& groups, std::size_t group,
                                      double rounding) {
  const std::vector<Tie> ties = ties_towards(groups, group);
  const auto other_end = [&](std::size_t link) {
    const std::vector<Tie> of_link = ties_towards(groups, link);
    return of_link[0].i == group ? of_link[1] : of_link[0];
  };
  for (std::size_t a = 0; a < ties.size(); ++a) {
    for (std::size_t b = a + 1; b < ties.size(); ++b) {
      const std::array links{ties[a].i, ties[b].i};
      if (!is_flat_link(groups, links[0], rounding) || !is_flat_link(groups, links[1], rounding))
        continue;
      const Tie tips[] = {other_end(links[0]), other_end(links[1])};
      const std::size_t foot = tips[0].i;
      if (tips[1].i != foot || foot == 0 || foot == group || is_driven(groups, foot)) continue;
      const auto of_bar = outer_tie_first(groups, group, links);
      const auto of_foot = outer_tie_first(groups, foot, links);
      if (!of_bar || !of_foot || of_bar->front().i == of_foot->front().i) continue;
      return FourBarLeg{of_bar->front(),
                        of_foot->front(),
                        {FourBarLeg::Link{reversed(ties[a]), tips[0], {}},
                         FourBarLeg::Link{reversed(ties[b]), tips[1], {}}}};
    }
  }
  return std::nullopt;
}

/// A ball joint where a link's hinge meets the line of the outer one, across it: from the group
/// that the outer one leads to, to the link.
std::optional<Tie> corner_of(const Tie& outer, const Tie& hinge, double rounding) {
  const Axis line = axis_of(outer.at_j);
  const Axis normal = axis_of(hinge.at_i);
  const auto crossing = crossing_of(line, normal, rounding);
  if (!crossing || std::abs(line.along.dot(normal.along)) > rounding) return std::nullopt;
  Tie ball = outer;
  ball.at_i = moved_along(outer.at_i, crossing->along_a);
  ball.at_j = moved_along(hinge.at_j, crossing->along_b);
  return ball;
}

/// Whether the far corner of a link lies in the plane that is normal to its hinges at the near one.
bool is_in_plane(const Tie& near, const Tie& far, double rounding) {
  const Axis normal = axis_of(near.at_j);
  const Vector3d arm = axis_of(far.at_j).at - normal.at;
  return std::abs(arm.dot(normal.along)) <= rounding * arm.norm();
}

/// Whether both links lay the foot's hinges the same way round.
bool are_laid_alike(const FourBarLeg& leg) {
  const auto along = [](const ExactPose& frame) { return axis_of(frame).along; };
  double product = 1;
  for (const auto& [root, tip, corner] : leg.links) {
    product *= along(root.at_j).dot(along(tip.at_j));
  }
  const auto& [left, right] = leg.links;
  product *= along(left.root.at_i).dot(along(right.root.at_i));
  product *= along(left.tip.at_i).dot(along(right.tip.at_i));
  return product > 0;
}

/// The rods of a four-bar whose plane holds the lines of both outer hinges; else none. Notes the
/// far corners.
std::vector<Tie> rods_of(const RigidGroups& groups, FourBarLeg& leg, double rounding) {
  const auto& [left, right] = leg.links;
  if (!are_parallel_and_apart(left.root.at_i, right.root.at_i, rounding) ||
      !are_parallel_and_apart(left.tip.at_i, right.tip.at_i, rounding) || !are_laid_alike(leg)) {
    return {};
  }
  std::vector<Tie> rods;
  for (auto& [root, tip, corner] : leg.links) {
    const auto near = corner_of(leg.bar, root, rounding);
    const auto far = corner_of(leg.foot, tip, rounding);
    if (!near || !far || !is_in_plane(*near, *far, rounding)) return {};
    rods.push_back(rod_between(*near, *far, groups.names[root.j]));
    corner = *far;
  }
  return rods;
}

/// Its meeting, where it is left out.
std::optional<Tie> leave_out_four_bar(RigidGroups& groups, std::size_t group, double rounding) {
  std::optional<FourBarLeg> leg = four_bar_of(groups, group, rounding);
  if (!leg) return std::nullopt;
  const std::vector<Tie> rods = rods_of(groups, *leg, rounding);
  if (rods.empty()) return std::nullopt;
  const auto& [left, right] = leg->links;
  for (const std::size_t link : {leg->bar.j, leg->foot.j, left.root.j, right.root.j}) {
    remove_ties(groups, link);
  }
  groups.ties.insert(groups.ties.end(), rods.begin(), rods.end());
  groups.left_out.emplace_back(groups.names[leg->bar.j] + " to " + groups.names[leg->foot.j],
                               "in the plane of the outer hinges a four-bar is two distances and "
                               "two lines that meet, in two postures");
  groups.four_bars.push_back(*leg);
  return meeting_of(leg->bar, leg->foot, groups.names[group]);
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

void leave_out_cones(RigidGroups& groups, const std::vector<std::size_t>& among, double rounding) {
  for (const std::size_t group : among) {
    if (groups.is_left_out[group] || is_driven(groups, group)) continue;
    leave_out_cone(groups, group, rounding);
  }
}

void leave_out_struts(RigidGroups& groups, const std::vector<std::size_t>& among, double rounding) {
  for (const std::size_t group : among) {
    if (groups.is_left_out[group] || is_driven(groups, group)) continue;
    leave_out_strut(groups, group, rounding);
  }
}

// Meetings come last: six rods say all of a body, and a theorem how many poses it has.
void leave_out_four_bars(RigidGroups& groups, const std::vector<std::size_t>& among,
                         double rounding) {
  std::vector<Tie> meetings;
  for (const std::size_t group : among) {
    if (groups.is_left_out[group] || is_driven(groups, group)) continue;
    if (const auto meeting = leave_out_four_bar(groups, group, rounding)) {
      meetings.push_back(*meeting);
    }
  }
  groups.ties.insert(groups.ties.end(), meetings.begin(), meetings.end());
}

void leave_out_legs(RigidGroups& groups, const std::vector<std::size_t>& among, double rounding) {
  for (const std::size_t group : among) {
    if (!groups.is_left_out[group]) leave_out_leg(groups, group, rounding);
  }
}

}  // namespace moivre
