// SPDX-License-Identifier: MIT
// The English of a search for closures.
#include "closure_sentences.h"

#include <cstdio>
#include <numbers>

#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/mechanism/joint_type.h"

namespace moivre {
namespace {

template <int digits>
std::string told(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

std::string told_length(double x, const std::string& unit) {
  return unit.empty() ? told<2>(x) : told<2>(x) + " " + unit;
}

std::string paths_in_doubt(std::size_t paths) {
  return counted(paths, "path") + " that were in doubt";
}

std::string paths_of(std::uint64_t solves) {
  return "following the paths of " + counted(solves, "solve");
}

}  // namespace

std::string closure_message(ClosureVerdict verdict) {
  switch (verdict) {
    case ClosureVerdict::interrupted:
      return "interrupted: what is finished is reported";
    case ClosureVerdict::image_lost:
      return "a closure's mirror image is missing: a path was lost";
    case ClosureVerdict::roots_lost:
      return "a closure was found that is none of the roots: roots were lost";
    case ClosureVerdict::not_confirmed:
      return "Newton-Raphson does not confirm a real root";
    case ClosureVerdict::paths_failed:
      return "some paths failed";
    case ClosureVerdict::moves_without_driver:
      return "moves: the closures form a set of positive dimension; there is no driver that holds "
             "it";
    case ClosureVerdict::moves_with_drivers_held:
      return "moves: the closures form a set of positive dimension though the drivers stand";
    case ClosureVerdict::moves_as_rounded:
      return "undecided: with the drivers' angles rounded the closures form a set, and it may be "
             "the rounding's: at other angles they form none";
    case ClosureVerdict::partly_complex:
      return "cannot be assembled: a part of it closes in complex numbers only";
    case ClosureVerdict::no_closure:
      return "cannot be assembled: there is no closure, not even a complex one";
    case ClosureVerdict::decided:
      return "every path was decided";
  }
  return {};
}

std::string undecided_set_message(bool has_isolated, bool is_drawn_alone, int starts) {
  const std::string what = has_isolated ? "besides the isolated closures others may form a set"
                                        : "no closure is isolated";
  const std::string known =
      is_drawn_alone
          ? "the drawn pose closes and nothing was seen to move from it; there may be others"
          : "there may be none";
  return "undecided: " + what + ", and Newton-Raphson came to no pose that moves from " +
         std::to_string(starts) + " starts; " + known + ": give a guess, or drivers";
}

std::string undecided_closures_message(std::uint64_t closures) {
  return "undecided: " + counted(closures, "closure") +
         " may be real, complex or one, as the file's numbers are rounded";
}

std::string complex_closures_message(std::uint64_t closures) {
  return "cannot be assembled: every closure is complex (" + std::to_string(closures) + ")";
}

std::string fitted_closures_message(std::uint64_t closures, double fit, const std::string& unit) {
  return "every path was decided; " + counted(closures, "closure closes", "closures close") +
         " within fit = " + told_length(fit, unit) + " only: least squares, no exact closure";
}

std::string nearest_pose_clause(double misfit, const std::string& misses_most,
                                const std::string& unit, std::optional<double> fit) {
  const std::string text =
      "; the nearest pose misses by " + told_length(misfit, unit) + " at " + misses_most;
  if (!fit) return text;
  return text + ", as rounded lengths do: fit = " + told<1>(*fit) + " in the file, or --fit " +
         told<1>(*fit) + ", takes it";
}

std::string near_poses_clause(std::size_t poses, double most, const std::string& unit, double fit) {
  const bool is_one = poses == 1;
  return "; " + counted(poses, "more pose misses", "more poses miss") + " by " +
         told_length(most, unit) + (is_one ? "" : " at most") + ", as rounded lengths do: --fit " +
         told<1>(fit) + (is_one ? " takes it" : " takes them");
}

std::string play_clause(const std::string& closure, double play) {
  return "; within fit closure " + closure + " can move: poses that hang together with it reach " +
         told<1>(play) + " from it, in radians or lengths of the pose";
}

std::string why_blocks_are_solved_in_order() {
  return "each group of bodies is solved on its own, once a branch of the groups before it";
}

std::string why_blocks_have_counts() { return "each group of bodies has counts of its own"; }

std::string start_from_general_member(std::size_t poses, const std::string& mechanism_class) {
  return "the " + std::to_string(poses) + " poses of " + mechanism_class + " in general position";
}

std::string group_of_bodies(const std::vector<std::string>& bodies) {
  const std::string names = bodies.empty() ? "" : " " + joined(bodies, ", ");
  if (bodies.size() == 1) return "single" + names;
  if (bodies.size() == 2) return "dyad" + names;
  return "group of " + std::to_string(bodies.size()) + names;
}

std::string group_with_equations_combined(const std::string& group) {
  return group + ", equations combined";
}

LeftOut closures_beyond_limits_left_out(std::uint64_t closures, const Joint& joint) {
  return {counted(closures, "closure"),
          "outside the limits of " + to_string(joint.type) + " " + joint.name};
}

LeftOut complex_sets_left_out() {
  return {"closures that form sets of positive dimension",
          "parts of them close in complex numbers only"};
}

LeftOut combined_closures_left_out(std::uint64_t most) {
  return {"some combinations of the sub-chains' closures",
          "beyond " + std::to_string(most) +
              " they are not all listed: sub_chains has the closures of each sub-chain; closures "
              "and solutions list each of these once, with the first closure of the others, and "
              "closures the one that was drawn"};
}

LeftOut excluded_roots_left_out(std::uint64_t roots, const std::string& reason) {
  return {counted(roots, "root that is no pose", "roots that are no poses"), reason};
}

LeftOut spare_equations_left_out(std::size_t spare, std::size_t equations) {
  return {std::to_string(spare) + " of " + counted(equations, "equation"),
          "there are more than unknowns; every root is checked on all of them"};
}

LeftOut lone_equations_left_out(std::size_t equations) {
  if (equations == 1) return {"1 linear equation solved alone", "it has a single unknown left"};
  return {std::to_string(equations) + " linear equations solved one by one",
          "each has a single unknown left"};
}

LeftOut blocks_above_rejected_left_out(std::uint64_t roots) {
  return {"what is above " + counted(roots, "root") + " of a part",
          "they are not real, and an equation of the others fails there"};
}

LeftOut shared_paths_left_out(std::uint64_t solves) {
  return {paths_of(solves), "above roots with the same values they are those of another one"};
}

LeftOut paths_of_formulas_left_out(std::uint64_t solves) {
  return {paths_of(solves),
          "what comes down to one quadratic equation, or to linear ones, is solved by formula"};
}

LeftOut doubtful_paths_left_out_by_contradiction(std::size_t paths) {
  return {paths_in_doubt(paths), "constraints contradict each other: they lead to no closure"};
}

LeftOut doubtful_paths_left_out_by_bound(std::size_t paths, std::uint64_t poses,
                                         const std::string& mechanism_class) {
  return {paths_in_doubt(paths), counted(poses, "pose") + " are proved, and " + mechanism_class +
                                     " has no more: they lead to no other"};
}

std::string held_at_angle(double angle, const std::string& unit, const std::string& body) {
  const double in_unit = unit == "deg" ? angle * 180 / std::numbers::pi : angle;
  return "held at " + told<8>(in_unit) + " " + unit + " to " + body;
}

std::string held_in_one_turn() {
  return "shown in one pose of its turn about the line of its two joints";
}

}  // namespace moivre
