// SPDX-License-Identifier: MIT
// Follow, read, search, explain.
#include "pose_closures.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "posture_list.h"
#include "random_values.h"
#include "read_ends.h"
#include "self_motion.h"

namespace moivre {
namespace {

/// Searches from random postures: where sets are, and where there is no posture: the nearest one is
/// reported.
constexpr std::uint64_t kForSets = 40, kForNearest = 4;

/// All closures of the regular pose on their way to this one; ways differ until nothing speaks
/// against what they lead to. Consistent: no two ways end at one closure, and none is lost.
std::vector<ApproachEnd> approach_all(const ArmBeginning& beginning, const Eigen::Isometry3d& pose,
                                      std::uint64_t seed, bool& is_consistent) {
  constexpr std::uint64_t kWays = 4, kBehindOthers = 5000;
  constexpr double kContraction = 0.1, kMoreCareful = 0.25;
  std::vector<ApproachEnd> ends;
  double contraction = kContraction;
  is_consistent = false;
  bool have_conjugates = false;
  for (std::uint64_t k = 0; k < kWays && !(is_consistent && have_conjugates); ++k) {
    const double unit = random_unit(seed, RandomStream::arm, kBehindOthers + k);
    const TipWay way = tip_way(beginning.regular.pose, pose, (k % 2 == 0 ? 1 : -1) * (0.5 + unit));
    ends.clear();
    for (const RegularRoot& root : beginning.regular.roots) {
      ends.push_back(approach(beginning.six.arm, way, root.values, contraction));
      ends.back().path = root.path;
    }
    is_consistent = are_different(beginning.six.arm, ends);
    // A conjugate may be one of those that are not followed.
    have_conjugates =
        beginning.regular.far > 0 || without_conjugate(beginning.six.arm, ends).empty();
    contraction *= kMoreCareful;
  }
  return ends;
}

/// Not only within digits.
bool can_move(const PostureList& list) {
  return std::any_of(list.moves.begin(), list.moves.end(), is_exact);
}

/// Searches from random postures: for sets, of which paths show few postures, and as a witness that
/// nothing is missing.
void search(PostureList& list, ArmResult& result, std::uint64_t count) {
  constexpr std::uint64_t kBehindOthers = 100;
  constexpr double kRegular = 1e-5;
  for (std::uint64_t k = 0; k < count; ++k) {
    const PostureEntry entry =
        enter(list, random_joint_values(list.arm, list.seed, kBehindOthers + k), true);
    if (entry.kind != PostureEntry::Kind::closure || !entry.is_new) continue;
    // Where closures meet paths may be read as one; a closure that stands clearly alone has a path
    // of its own. With fewer joints than six, places of a set are closures that the pose's accuracy
    // does not tell apart.
    const ArmClosure& closure = list.closures[entry.index];
    const bool is_alone = closure.smallest_singular_value > kRegular && !closure.within_digits;
    if (is_alone && !is_of_open_set(list, closure.values)) {
      result.complete = false;
      result.message = "a search from a random posture found a closure that no path led to";
    }
  }
}

std::string number_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", x);
  return text;
}

/// However the joints turn, all links in a row do not reach so far.
bool is_out_of_reach(const PostureList& list) {
  const double reach = list.arm.length * (1 + list.accuracy + list.arm.rounding);
  return !has_slides(list.arm) && list.pose.translation().norm() > reach;
}

std::string message_of(const Arm& arm, const PostureList& list, const ArmResult& result) {
  if (!result.complete) {
    return result.message.empty() ? "some paths are undecided: closures may be missing"
                                  : result.message;
  }
  if (can_move(list)) return "the joints can move while the tip stands";
  const auto is_by_pose = [](const SelfMotion& set) { return !set.within_digits; };
  if (std::any_of(list.moves.begin(), list.moves.end(), is_by_pose)) {
    return "within the accuracy of the pose the joints can move while the tip stands";
  }
  if (!list.moves.empty()) {
    return "within the digits of the file's numbers the joints can move while the tip stands";
  }
  if (!list.closures.empty()) return "every path was decided";
  std::string text = "the arm cannot hold this pose";
  if (is_out_of_reach(list)) {
    text += ", which is " + number_text(list.pose.translation().norm()) +
            " m from its base: all links in a row are " + number_text(arm.length) + " m long";
  }
  if (arm.joints.size() < 6) text += "; with fewer than six free joints only some can be held";
  if (list.nearest) {
    text += "; the nearest posture misses it by " + number_text(list.nearest->apart.position) +
            " m and " + number_text(list.nearest->apart.rotation) + " rad";
  }
  return text;
}

/// What is gathered while one pose is solved.
struct PoseSearch {
  const PreparedArm& prepared;
  PostureList list;
  ArmResult result;
  std::vector<PathsSeen> seen;  ///< by beginning
  bool are_found = false;       ///< the formula's closures, none of them near to others
};

PoseSearch begin_search(const PreparedArm& prepared, const TypedPose& at) {
  const Arm& arm = prepared.arm;
  ArmResult result = prepared.account;
  result.pose = at.pose;
  result.complete = prepared.is_complete;
  result.accuracy = std::max(kReach, at.accuracy * std::max(1.0, 1 / arm.length));
  PostureList list{arm, at.pose, result.accuracy, prepared.seed, {}, {}, {}, {}, {}, {}};
  return {prepared, std::move(list), std::move(result),
          std::vector<PathsSeen>(prepared.beginnings.size())};
}

/// What is far from real at the regular pose may be real at this one.
SolvedPose far_ones_too(const PoseSearch& pose, const ArmBeginning& beginning,
                        const Tracker& tracker, const std::atomic<bool>& stop) {
  if (beginning.regular.far == 0) return {};
  return solve_at(beginning.six.arm, pose.list.pose, tracker, pose.prepared.options, stop);
}

/// As many as at the regular pose, and with each its conjugate.
bool are_all(const ArmBeginning& beginning, const SolvedPose& at) {
  const RegularPose& regular = beginning.regular;
  return at.complete && at.are_right &&
         at.closures.size() + at.far == regular.roots.size() + regular.far &&
         without_conjugate(beginning.six.arm, at.closures).empty();
}

/// Of ends that no paths led to.
std::vector<ApproachEnd> with_paths(const ArmBeginning& beginning, std::vector<ApproachEnd> ends) {
  for (std::size_t k = 0; k < ends.size(); ++k) ends[k].path = beginning.regular.roots[k].path;
  return ends;
}

/// The paths of one beginning, or what is known of their ends.
void enter_ends(PoseSearch& pose, std::size_t k, const KnownOfPose& known, const Tracker& tracker,
                const std::atomic<bool>& stop) {
  const ArmBeginning& beginning = pose.prepared.beginnings[k];
  PostureList& list = pose.list;
  ArmResult& result = pose.result;
  const SolvedPose at = far_ones_too(pose, beginning, tracker, stop);
  const bool is_solved = are_all(beginning, at);
  bool is_consistent = known.is_any() || is_solved;
  const auto ends = known.by_formula ? with_paths(beginning, ends_of(*known.by_formula))
                    : known.is_any() ? with_paths(beginning, known.by_family)
                    : is_solved      ? at.closures
                                     : approach_all(beginning, list.pose, list.seed, is_consistent);
  const bool are_read = read_ends(beginning, ends, list, result, pose.seen[k]);
  result.complete = result.complete && is_consistent && are_read;
  if (beginning.regular.far == 0) return;
  for (const Eigen::VectorXd& start : at.nearly_real) {
    enter(list, own_values(beginning.six, start), false);
  }
  // Where they are not all, sets may be where the others have gone.
  result.complete = result.complete && at.complete && (is_solved || can_move(list));
  if (beginning.six.own.size() == kSixJoints) {
    result.counts.complex += is_solved ? at.far : beginning.regular.far;
  }
}

/// Where paths meet they stop before what they lead to, and may all be read as one of several.
/// The formula knows nothing of paths: what it proposes is another beginning. Of a double root
/// rounding makes two real ones, or a pair.
void enter_proposed(const ArmBeginning& beginning, PostureList& list) {
  if (!beginning.formula) return;
  const ProposedClosures proposed = proposed_closures(*beginning.formula, list.pose);
  const auto take = [&](const Eigen::VectorXd& six) {
    if (!six.allFinite()) return;
    const Eigen::VectorXd start = own_values(beginning.six, six);
    enter(list, start, false);
    follow_crossing(list, start);
  };
  for (std::size_t k = 0; k < proposed.reals; ++k) take(proposed.real[k]);
  for (std::size_t k = 0; k < proposed.pair_count; ++k) take(proposed.pairs[k].real());
}

/// Where paths ended, and where the formula leads.
void follow_crossings(PoseSearch& pose, std::size_t k) {
  const std::vector<SingularEnd>& ends = pose.seen[k].singular;
  if (!ends.empty()) enter_proposed(pose.prepared.beginnings[k], pose.list);
  for (const SingularEnd& end : ends) follow_crossing(pose.list, end.values);
}

bool has_none(const PostureList& list) { return list.closures.empty() && list.moves.empty(); }

/// How many searches from random postures this pose needs.
std::uint64_t searches_for(const PoseSearch& pose, std::uint64_t as_witness) {
  const bool are_singular =
      std::any_of(pose.seen.begin(), pose.seen.end(),
                  [](const PathsSeen& seen) { return !seen.singular.empty(); });
  // Where all closures are simple, sets are those that digits leave open, through one of them.
  const bool are_all_simple = pose.are_found || pose.list.has_all_closures;
  const bool may_be_sets = pose.prepared.is_always_moving || are_singular ||
                           (are_all_simple ? can_move(pose.list) : !pose.list.moves.empty());
  if (may_be_sets) return kForSets;
  return has_none(pose.list) ? kForNearest : as_witness;
}

/// What singular ends lead to, and places that hold the pose within its accuracy.
void explain(PoseSearch& pose) {
  PostureList& list = pose.list;
  ArmResult& result = pose.result;
  for (PathsSeen& seen : pose.seen) {
    for (const SingularEnd& end : seen.singular) {
      if (!is_explained(end, list, seen, result)) result.complete = false;
    }
  }
  for (const PathsSeen& seen : pose.seen) {
    for (const PlaceOfEnd& end : seen.unpaired) {
      if (!is_on_continuation(end, list)) result.complete = false;
    }
    for (const Eigen::VectorXd& place : seen.between_pairs) {
      if (!is_listed(list, place)) enter_meeting(list, place);
    }
  }
  for (const Eigen::VectorXd& place : list.places) {
    if (!is_listed(list, place)) result.complete = false;
  }
  if (!list.are_sets_whole) {
    result.complete = false;
    result.message = "a set on which the joints move is too large to be told whole";
  }
  // A posture within the digits would be reported: there may be one where Newton's method did not
  // come to an end.
  const bool may_be_held =
      list.nearest && list.nearest->misfit <= list.accuracy + list.arm.rounding;
  if (has_none(list) && may_be_held) result.complete = false;
  if (is_out_of_reach(list)) result.complete = true;
}

ArmResult finished(PoseSearch&& pose) {
  PostureList& list = pose.list;
  ArmResult& result = pose.result;
  name_closures(list.closures);
  result.counts.real = list.closures.size();
  result.counts.complex = std::max(result.counts.complex, result.counts.real);
  for (const ArmClosure& closure : list.closures) {
    if (!closure.beyond.empty()) ++result.counts.beyond_limits;
  }
  if (has_none(list) && list.nearest) {
    list.nearest->apart = misfit_of(list.arm, list.pose, list.nearest->values);
  }
  result.message = message_of(list.arm, list, result);
  if (has_none(list)) result.nearest = std::move(list.nearest);
  result.closures = std::move(list.closures);
  result.moves = std::move(list.moves);
  return std::move(result);
}

}  // namespace

ArmResult closures_at(const PreparedArm& prepared, const TypedPose& at, const KnownOfPose& known,
                      std::uint64_t as_witness, const Tracker& tracker,
                      const std::atomic<bool>& stop) {
  PoseSearch pose = begin_search(prepared, at);
  for (std::size_t k = 0; k < prepared.beginnings.size(); ++k) {
    const ArmBeginning& beginning = prepared.beginnings[k];
    const auto& found = known.by_formula;
    pose.list.has_all_closures = found && found->are_all;
    pose.are_found = found && read_found(beginning, *found, pose.list, pose.result);
    if (!pose.are_found) enter_ends(pose, k, known, tracker, stop);
  }
  follow_branches(pose.list);
  for (std::size_t k = 0; k < prepared.beginnings.size(); ++k) follow_crossings(pose, k);
  search(pose.list, pose.result, searches_for(pose, as_witness));
  explain(pose);
  return finished(std::move(pose));
}

}  // namespace moivre
