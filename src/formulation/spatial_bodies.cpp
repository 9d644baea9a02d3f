// SPDX-License-Identifier: MIT
// Groups, links left out, parts, and each part by the form that suits it.
#include "spatial_bodies.h"

#include <algorithm>

#include "moivre/mechanism/phi.h"
#include "serial_loop.h"
#include "six_rods.h"

namespace moivre {
namespace {

/// Groups that hang together without the ground, in the order of their first group.
std::vector<Part> parts_of(const RigidGroups& groups) {
  std::vector<Part> parts;
  std::vector<bool> is_taken = groups.is_left_out;
  is_taken[0] = true;
  for (std::size_t first = 1; first < groups.names.size(); ++first) {
    if (is_taken[first]) continue;
    Part part{{first}, {}};
    is_taken[first] = true;
    for (std::size_t k = 0; k < part.groups.size(); ++k) {
      for (const Tie& tie : groups.ties) {
        if (tie.i != part.groups[k] && tie.j != part.groups[k]) continue;
        const std::size_t other = tie.i == part.groups[k] ? tie.j : tie.i;
        if (is_taken[other]) continue;
        is_taken[other] = true;
        part.groups.push_back(other);
      }
    }
    for (std::size_t k = 0; k < groups.ties.size(); ++k) {
      const auto has = [&](std::size_t group) {
        return std::find(part.groups.begin(), part.groups.end(), group) != part.groups.end();
      };
      if (has(groups.ties[k].i) || has(groups.ties[k].j)) part.ties.push_back(k);
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

void leave_out_from_tree(RigidGroups& groups, const std::vector<std::size_t>& among,
                         double rounding) {
  leave_out_cones(groups, among, rounding);
  leave_out_struts(groups, among, rounding);
  leave_out_four_bars(groups, among, rounding);
  leave_out_legs(groups, among, rounding);
}

/// Whether these groups have more equations than unknowns.
bool are_overdetermined(const RigidGroups& groups, const std::vector<std::size_t>& among,
                        double length) {
  SpatialFrame frame(length);
  for (const Part& part : parts_of(groups)) {
    const bool is_among = std::find(among.begin(), among.end(), part.groups.front()) != among.end();
    if (is_among && !loop_of(groups, part)) add_tree(frame, groups, part);
  }
  const System& f = frame.result().system;
  return f.polynomials.size() > f.variables.size();
}

/// Links that are so by the file's numbers, or where equations are spare but for rounding: then
/// there is no closure but where these numbers agree, and it is found beside one of the links as
/// meant. How far the farthest may be from the file's.
double leave_out_links(RigidGroups& groups, double length) {
  constexpr double kExactly = 1e-11;
  // Of axes and points typed with two digits.
  constexpr double kRounded = 3e-2;
  double within = 0;
  const std::size_t before = groups.left_out.size();
  leave_out_rods(groups);
  for (const Part& part : parts_of(groups)) {
    if (loop_of(groups, part)) continue;
    leave_out_from_tree(groups, part.groups, kExactly);
    RigidGroups meant = groups;
    leave_out_from_tree(meant, part.groups, kRounded);
    const std::size_t exact = groups.left_out.size();
    if (meant.left_out.size() == exact || !are_overdetermined(meant, part.groups, length)) continue;
    for (std::size_t k = exact; k < meant.left_out.size(); ++k) {
      meant.left_out[k].second += ", but for rounding";
    }
    groups = std::move(meant);
    within = kRounded;
  }
  // What stands for a link is placed by rounded numbers.
  if (groups.left_out.size() > before) groups.has_exact_frames = false;
  return within;
}

/// Whether all joints' frames are what was typed: fractions, or points that are not turned.
bool has_exact_frames(const RigidGroups& groups) {
  if (groups.has_exact_frames) return true;
  const auto is_shift = [](const ExactPose& pose) { return pose.q == ExactPose::identity().q; };
  return std::all_of(groups.ties.begin(), groups.ties.end(),
                     [&](const Tie& tie) { return is_shift(tie.at_i) && is_shift(tie.at_j); });
}

/// Ties whose both ends are the ground hold or do not, whatever moves.
void add_ground_ties(SpatialFrame& frame, const RigidGroups& groups) {
  const MovingPose rest = to_moving(ExactPose::identity());
  for (const Tie& tie : groups.ties) {
    if (tie.i != 0 || tie.j != 0) continue;
    if (is_rod(tie)) {
      const double size = frame.length() * frame.length();
      frame.add_equation(tie.name, frame.without_rounding(rod_equation(frame, tie, rest), size));
    } else {
      add_closing(frame, tie, rest);
    }
  }
}

/// A body on six rods has 40 poses in general, and so none has more that are isolated
/// [RongaVust95]. What else it is tied by comes behind these and is checked.
std::optional<Formulation::Theorem> theorem_of(const RigidGroups& groups,
                                               const std::vector<Part>& parts, double length) {
  constexpr std::size_t kRods = 6;
  constexpr std::uint64_t kMostPoses = 40;
  if (parts.size() != 1 || parts.front().groups.size() != 1) return std::nullopt;
  const auto& ties = parts.front().ties;
  const auto is_to_ground = [&](std::size_t k, bool (*is_kind)(const Tie&)) {
    const Tie& tie = groups.ties[k];
    return is_kind(tie) && (tie.i == 0) != (tie.j == 0);
  };
  const bool is_platform = ties.size() >= kRods && groups.driven_points.empty() &&
                           std::all_of(ties.begin(), ties.begin() + kRods,
                                       [&](std::size_t k) { return is_to_ground(k, is_rod); }) &&
                           std::all_of(ties.begin() + kRods, ties.end(),
                                       [&](std::size_t k) { return is_to_ground(k, is_loose); });
  if (!is_platform) return std::nullopt;
  return Formulation::Theorem{
      "a body on six rods", ExactPose::size(), kMostPoses,
      [groups, part = parts.front(), length] { return general_six_rods(groups, part, length); }};
}

void read_poses(const RigidGroups& groups, PoseReading& poses) {
  poses.groups = groups.names.size();
  poses.placements.insert(poses.placements.end(), groups.links.begin(), groups.links.end());
  for (std::size_t body = 1; body < groups.group_of.size(); ++body) {
    poses.bodies.push_back({groups.group_of[body], to_double(groups.in_group[body])});
  }
}

}  // namespace

Formulation spatial_bodies(const Mechanism& mechanism, double t) {
  RigidGroups groups = rigid_groups(mechanism, t);
  const double length = largest_length(mechanism);
  const double meant_within = leave_out_links(groups, length);
  SpatialFrame frame(length, has_exact_frames(groups));
  add_ground_ties(frame, groups);
  const std::vector<Part> parts = parts_of(groups);
  for (const Part& part : parts) {
    if (const auto loop = loop_of(groups, part)) {
      add_loop(frame, groups, *loop);
    } else {
      add_tree(frame, groups, part);
    }
  }
  frame.add_checks();
  Formulation formulation = std::move(frame.result());
  formulation.has_rounded_frames = !has_exact_frames(groups);
  formulation.meant_within = meant_within;
  formulation.theorem = theorem_of(groups, parts, frame.length());
  read_poses(groups, formulation.poses);
  formulation.contradictions.insert(formulation.contradictions.end(), groups.contradictions.begin(),
                                    groups.contradictions.end());
  formulation.left_out = groups.left_out;
  return formulation;
}

}  // namespace moivre
