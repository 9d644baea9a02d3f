// SPDX-License-Identifier: MIT
// A regular pose with all its closures, once for the arm; the way from there to every pose asked;
// what is found there.
#include "moivre/arms/arm_closures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <numbers>
#include <span>

#include "approach.h"
#include "formula_ends.h"
#include "moivre/arms/rules.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/numeric/threads.h"
#include "pose_family.h"
#include "posture_list.h"
#include "random_values.h"
#include "regular_pose.h"
#include "self_motion.h"
#include "set_place.h"
#include "six_joints.h"

namespace moivre {
namespace {

constexpr std::size_t kSixJoints = 6;
/// Searches from random postures: where sets are, and as a witness of a pose alone. Of a list every
/// kWitnessed-th pose has one.
constexpr std::uint64_t kForSets = 40, kAsWitness = 4, kWitnessed = 8;
/// Poses from which on a family pays, and those that are followed together, a thread.
constexpr std::size_t kWorthAFamily = 8, kTogether = 128;

/// An arm of six joints that stands for the arm, and its closures at a regular pose.
struct Beginning {
  SixJoints six;
  RegularPose regular;
};

struct PreparedArm {
  const Arm& arm;
  std::uint64_t seed = 0;
  SolveOptions options;
  std::vector<Beginning> beginnings;  ///< one; more where joints are held that move on curved sets
  std::optional<GroupFormula>
      formula;  ///< of a list: of an arm with one beginning, tried at its regular pose
  bool is_always_moving = false;
  bool is_complete = false;
};

PreparedArm prepare(const Arm& arm, const Tracker& tracker, const SolveOptions& options,
                    const std::atomic<bool>& stop) {
  constexpr std::uint64_t kBehindOthers = 900, kCurvedTries = 4;
  constexpr double kRounding = 1e-9, kDigits = 10;
  PreparedArm prepared{arm, options.seed, options, {}, std::nullopt, false, true};
  prepared.options.threads = 1;
  prepared.options.progress = nullptr;
  const auto idle =
      idle_in_every_posture(arm, options.seed, std::max(kRounding, kDigits * arm.rounding));
  prepared.is_always_moving = !idle.empty();
  // A plane of joint space has a posture for any value of a joint that is held; a curved set may
  // have none.
  std::uint64_t tries = 1;
  if (prepared.is_always_moving) {
    const Eigen::VectorXd any = random_joint_values(arm, options.seed, kBehindOthers);
    const auto set = trace_set(arm, forward_kinematics(arm, any), any,
                               std::max(kReach, kDigits * arm.rounding), options.seed);
    if (!set || set->motion.relations.empty()) tries = kCurvedTries;
  }
  for (std::uint64_t k = 0; k < tries && !stop; ++k) {
    const Eigen::VectorXd held = random_joint_values(arm, options.seed, kBehindOthers + 1 + k);
    Beginning beginning{six_joints(arm, idle, held, options.seed), {}};
    beginning.regular = find_regular_pose(beginning.six.arm, tracker, options, stop);
    prepared.is_complete = prepared.is_complete && beginning.regular.complete;
    prepared.beginnings.push_back(std::move(beginning));
  }
  prepared.is_complete = prepared.is_complete && !stop;
  return prepared;
}

/// All closures of the regular pose on their way to this one; ways differ until nothing speaks
/// against what they lead to.
std::vector<ApproachEnd> approach_all(const Beginning& beginning, const Eigen::Isometry3d& pose,
                                      std::uint64_t seed, bool& is_consistent) {
  constexpr std::uint64_t kWays = 4, kBehindOthers = 5000;
  constexpr double kContraction = 0.1, kMoreCareful = 0.25;
  std::vector<ApproachEnd> ends;
  double contraction = kContraction;
  is_consistent = false;
  for (std::uint64_t k = 0; k < kWays && !is_consistent; ++k) {
    const double unit = random_unit(seed, RandomStream::arm, kBehindOthers + k);
    const TipWay way = tip_way(beginning.regular.pose, pose, (k % 2 == 0 ? 1 : -1) * (0.5 + unit));
    ends.clear();
    for (const RegularRoot& root : beginning.regular.roots) {
      ends.push_back(approach(beginning.six.arm, way, root.values, contraction));
    }
    // A conjugate may be one of those that are not followed.
    is_consistent = are_different(beginning.six.arm, ends) &&
                    (beginning.regular.far > 0 || have_conjugates(beginning.six.arm, ends));
    contraction *= kMoreCareful;
  }
  return ends;
}

/// Joints that were added have no names, and are counted.
std::string names_of(const Arm& arm, const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t k : joints) {
    if (!arm.joints[k].name.empty()) names.push_back(arm.joints[k].name);
  }
  const std::size_t added = joints.size() - names.size();
  if (added > 0) names.push_back(counted(added, "added joint"));
  return joined(names, ", ");
}

double imaginary_size(const Arm& arm, const JointVector<Complex>& values) {
  double largest = 0;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
    largest = std::max(largest, std::abs(values[k].imag()) / (is_slide ? arm.length : 1));
  }
  return largest;
}

/// How far the turns that were added are from 0, where they stand at a closure of the arm.
double added_size(const Beginning& beginning, const ApproachEnd& end) {
  double largest = 0;
  for (std::size_t k = beginning.six.own.size(); k < beginning.six.arm.joints.size(); ++k) {
    const Complex angle = end.values[static_cast<Eigen::Index>(k)];
    const double within_turn = std::remainder(angle.real(), 2 * std::numbers::pi);
    largest = std::max(largest, std::hypot(within_turn, angle.imag()));
  }
  return largest;
}

/// A path that ended where closures meet, or where a set is.
struct SingularEnd {
  Eigen::VectorXd values;  ///< of the arm, the real part
  double imaginary = 0;
  double added = 0;  ///< of the joints that were added
  double to_go = 0;  ///< how far it is from what the path leads to
};

/// What the paths of one beginning came to.
struct Arrivals {
  std::map<std::size_t, std::uint64_t> paths_to;  ///< by closure
  std::vector<SingularEnd> singular;
  /// Between two closures that are nearly real: the pose is held within its accuracy there.
  std::vector<Eigen::VectorXd> between_pairs;
};

/// Enters the closures of regular ends, and what singular ones lead to; these are explained when
/// all is entered.
/// False where a regular end is no posture.
bool read_ends(const Beginning& beginning, const std::vector<ApproachEnd>& ends, PostureList& list,
               ArmResult& result, Arrivals& arrivals) {
  constexpr double kNearlyReal = 0.1, kFarthest = 0.1, kMargin = 10;
  const SixJoints& six = beginning.six;
  const bool has_all_joints = six.own.size() == kSixJoints;
  const double accuracy = list.accuracy + list.arm.rounding;
  bool are_read = true;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const ApproachEnd& end = ends[k];
    if (end.kind == ApproachKind::infinite || end.kind == ApproachKind::lost) continue;
    const double imaginary = imaginary_size(six.arm, end.values);
    const Eigen::VectorXd start = own_values(six, end.values.real());
    if (end.kind == ApproachKind::singular) {
      enter(list, start, false);
      arrivals.singular.push_back({start, imaginary, added_size(beginning, end), end.to_go});
      continue;
    }
    const bool counts = added_size(beginning, end) <= kMargin * accuracy;
    const std::size_t places = list.places.size();
    const PostureEntry entry = imaginary > kNearlyReal ? PostureEntry{} : enter(list, start, false);
    if (entry.kind == PostureEntry::Kind::closure && entry.moved <= kFarthest) {
      ArmClosure& closure = list.closures[entry.index];
      // An end elsewhere may have led here before: that was no path of this closure.
      const std::uint64_t arrived = counts ? ++arrivals.paths_to[entry.index] : 0;
      if (arrived == 1 || entry.is_new) closure.path = beginning.regular.roots[k].path;
      closure.multiplicity = std::max(closure.multiplicity, arrived);
      closure.singular = closure.multiplicity > 1;
      if (counts || entry.is_new) ++result.counts.complex;
      continue;
    }
    if (entry.kind == PostureEntry::Kind::on_set) continue;
    if (counts) ++result.counts.complex;
    if (list.places.size() > places) arrivals.between_pairs.push_back(list.places.back());
    const bool is_real = imaginary <= 10 * end.accuracy + 1e-10;
    if (is_real && has_all_joints) are_read = false;
  }
  return are_read;
}

/// Enters what the formula found, where nothing but its real closures may hold the pose; otherwise
/// nothing, and false.
/// Beside a pair with imaginary parts y whose Jacobian has a smallest singular value s the pose is
/// missed by y s / 2 at the least; where an added joint stands at x, by s x.
bool read_found(const Beginning& beginning, const FoundClosures& found, PostureList& list,
                ArmResult& result) {
  constexpr double kNearlyReal = 0.1, kClearly = 8, kMargin = 10;
  const SixJoints& six = beginning.six;
  const bool has_all_joints = six.own.size() == kSixJoints;
  const double accuracy = list.accuracy + list.arm.rounding;
  const double clear = kClearly * accuracy;
  const auto added_at = [&](const auto& values) {
    return values.tail(values.size() - std::ssize(six.own)).cwiseAbs().sum();
  };
  for (const ConjugatePair& pair : found.pairs) {
    if (pair.imaginary <= kNearlyReal && pair.imaginary * pair.stiffness <= clear) return false;
  }
  std::vector<const Polished*> own;
  for (const Polished& real : found.real) {
    const double added = has_all_joints ? 0 : added_at(real.values);
    if (added <= kMargin * accuracy) {
      own.push_back(&real);
    } else if (added * real.smallest_singular_value <= clear) {
      return false;
    }
  }
  if (own.empty()) return false;  // the nearest posture is told
  for (const Polished* const real : own) {
    const PostureEntry entry =
        has_all_joints ? enter(list, *real) : enter(list, own_values(six, real->values), false);
    if (entry.kind == PostureEntry::Kind::closure && entry.is_new) {
      list.closures[entry.index].path = beginning.regular.roots[entry.index].path;
    }
    if (entry.kind != PostureEntry::Kind::on_set) ++result.counts.complex;
  }
  for (const ConjugatePair& pair : found.pairs) {
    if (has_all_joints || added_at(pair.values) <= kMargin * accuracy) result.counts.complex += 2;
  }
  return true;
}

/// Paths stop before they are there, where three and more meet.
constexpr double kNear = 0.03;

/// The nearest closure that the path may have come to. One path alone comes to a simple closure,
/// however near to singular it is; with joints that were added to an arm's own several may.
std::optional<std::size_t> closure_of(const SingularEnd& end, const PostureList& list,
                                      const Arrivals& arrivals) {
  constexpr double kSingular = 1e-3;
  std::optional<std::size_t> nearest;
  double least = kNear;
  for (std::size_t k = 0; k < list.closures.size(); ++k) {
    const ArmClosure& closure = list.closures[k];
    if (closure.smallest_singular_value > kSingular) continue;
    const double away = distance(list.arm, closure.values, end.values);
    const bool has_room = list.arm.joints.size() < kSixJoints || !is_simple(closure) ||
                          !arrivals.paths_to.contains(k);
    if (!has_room || away > least) continue;
    least = away;
    nearest = k;
  }
  return nearest;
}

bool is_at_set(const SingularEnd& end, const PostureList& list, bool within_digits) {
  return std::any_of(list.moves.begin(), list.moves.end(), [&](const SelfMotion& set) {
    return set.within_digits == within_digits && is_on(list.arm, set, end.values, kNear);
  });
}

/// Whether the end is at a set or a closure that is listed. On a set that is there within the
/// digits only, the arm as typed has closures.
bool is_at_listed(const SingularEnd& end, PostureList& list, Arrivals& arrivals,
                  ArmResult& result) {
  if (is_at_set(end, list, false)) return true;
  const auto at = closure_of(end, list, arrivals);
  if (!at) return is_at_set(end, list, true);
  ArmClosure& closure = list.closures[*at];
  closure.multiplicity = std::max(closure.multiplicity, ++arrivals.paths_to[*at]);
  closure.singular = !is_simple(closure);
  ++result.counts.complex;
  return true;
}

/// Whether the end is at a set or a closure that is listed, or at one that is found next to it, or
/// at a singular one that is not real or not the arm's own.
bool is_explained(const SingularEnd& end, PostureList& list, Arrivals& arrivals,
                  ArmResult& result) {
  constexpr double kNotReal = 1e-2, kFarBefore = 0.1, kClearly = 4;
  constexpr std::uint64_t kBeside = 16, kBehindOthers = 20'000;
  const double clear = kClearly * end.to_go;
  // A path that stopped far before its end tells nothing of it, unless it was farther still from
  // what is real.
  const bool stopped_early = end.to_go > kFarBefore;
  if (!stopped_early && is_at_listed(end, list, arrivals, result)) return true;
  if (end.added > std::max(kNear, clear)) return true;
  if (end.imaginary > std::max(kNotReal, clear)) {
    ++result.counts.complex;
    return true;
  }
  if (stopped_early) return false;
  for (std::uint64_t k = 0; k < kBeside; ++k) {
    const Eigen::VectorXd way = random_joint_values(list.arm, list.seed, kBehindOthers + k);
    enter(list, end.values + kNear / std::numbers::pi * way, false);
  }
  return is_at_listed(end, list, arrivals, result);
}

bool hold_between(const PostureList& list, const ArmClosure& closure,
                  const Eigen::VectorXd& place) {
  const Eigen::VectorXd way = way_between(list.arm, closure.values, place);
  const SetPlace from = place_at(list.arm, list.pose, closure.values);
  return leads_to(list.arm, list.pose, from, way, list.accuracy);
}

/// Whether a place that holds the pose within its accuracy is of a set or a closure that is listed:
/// near to it, or the pose is held half way, too.
bool is_listed(const PostureList& list, const Eigen::VectorXd& place) {
  constexpr double kLongestWay = 0.3;
  return std::any_of(list.moves.begin(), list.moves.end(),
                     [&](const SelfMotion& set) { return is_on(list.arm, set, place, kNear); }) ||
         std::any_of(list.closures.begin(), list.closures.end(), [&](const ArmClosure& closure) {
           const double away = distance(list.arm, closure.values, place);
           return away <= kNear || (away <= kLongestWay && hold_between(list, closure, place));
         });
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
    // of its own.
    const ArmClosure& closure = list.closures[entry.index];
    if (closure.smallest_singular_value > kRegular && !closure.within_digits) {
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

/// Not only within the digits.
bool can_move(const PostureList& list) {
  return std::any_of(list.moves.begin(), list.moves.end(),
                     [](const SelfMotion& set) { return !set.within_digits; });
}

std::string message_of(const Arm& arm, const PostureList& list, const ArmResult& result) {
  if (!result.complete) {
    return result.message.empty() ? "some paths are undecided: closures may be missing"
                                  : result.message;
  }
  if (can_move(list)) return "the joints can move while the tip stands";
  if (!list.moves.empty()) {
    return "within the digits of the file's numbers the joints can move while the tip stands";
  }
  if (!list.closures.empty()) return "every path was decided";
  std::string text = "the arm cannot hold this pose";
  if (arm.joints.size() < 6) text += "; with fewer than six free joints only some can be held";
  if (list.nearest)
    text += "; the nearest posture misses it by " + number_text(list.nearest->misfit);
  return text;
}

/// What was done instead of following paths in all joints.
LeftOut cut_told(const Arm& arm, const Cut& cut) {
  const std::string inside = names_of(arm, cut.inside);
  if (cut.kind == CutKind::two) {
    return {"unknowns of " + inside, "what two neighbours can do is given by linear equations"};
  }
  if (cut.kind == CutKind::two_in_quadric) {
    return {"unknowns of " + inside,
            "their axes meet or are parallel, or nearly: linear equations and a quadratic one"};
  }
  return {
      "paths of " + inside,
      "their axes meet in a point or are parallel: a group of motions, given by linear equations; "
      "its joints are then roots of a quadratic"};
}

/// The account of the solves at regular poses.
void take_account(const PreparedArm& prepared, const Tracker& tracker, ArmResult& result) {
  result.seed = prepared.seed;
  result.tracker = tracker.kind();
  result.tracker_options = tracker.options_in_force();
  for (const Beginning& beginning : prepared.beginnings) {
    const SolveResult& solved = beginning.regular.solved;
    result.start = solved.start;
    result.paths += solved.paths;
    result.failures.insert(result.failures.end(), solved.failures.begin(), solved.failures.end());
    result.work += solved.work;
    result.time_s.start += solved.time.start;
    result.time_s.track += solved.time.track;
    result.time_s.track_cpu += solved.time.track_cpu;
    result.time_s.refine += solved.time.refine;
    result.time_s.threads = solved.time.threads;
    result.counts.rejected += beginning.regular.rejected;
    const Arm& six = beginning.six.arm;
    result.stages.push_back({names_of(six, beginning.regular.cut.outside), 1, solved.paths});
  }
  if (prepared.beginnings.empty()) return;
  const Beginning& first = prepared.beginnings.front();
  result.left_out.push_back(cut_told(first.six.arm, first.regular.cut));
}

/// What is known of a pose's closures before anything is entered.
struct Known {
  std::vector<ApproachEnd> by_family;  ///< or none
  std::optional<FoundClosures> by_formula;

  bool is_any() const { return by_formula.has_value() || !by_family.empty(); }
};

/// Another pose of a list: nothing was solved for it, its closures came from the regular pose.
void tell_followed(const PreparedArm& prepared, const Known& known, ArmResult& result) {
  std::uint64_t roots = 0;
  for (const Beginning& beginning : prepared.beginnings) roots += beginning.regular.roots.size();
  result.start.kind = known.by_formula ? "formula" : known.is_any() ? "family" : "approach";
  result.start.why =
      known.by_formula
          ? "a formula for neighbours that meet or are parallel; as many as a regular pose has"
          : "the " + counted(roots, "closure") + " of a regular pose";
  result.start.paths = roots;
  result.paths = {};
  result.paths.tracked = result.paths.finite = roots;
  result.work = {};
  result.time_s = {};
}

/// A rotation that is rounded is the nearest one. Throws InvalidInput where it is no pose.
TypedPose workable(const TypedPose& pose, const std::string& name) {
  if (!(pose.accuracy >= 0) || !std::isfinite(pose.accuracy)) {
    throw InvalidInput("the accuracy of " + name + " is finite and not negative");
  }
  return {workable_pose(pose.pose, name), pose.accuracy};
}

/// Closures far from real may be real next to singular postures.
bool may_have_become_real(const Beginning& beginning, const std::vector<ApproachEnd>& ends,
                          const PostureList& list) {
  constexpr double kNearlySingular = 0.02;
  if (beginning.regular.far == 0) return false;
  if (list.closures.empty() || !have_conjugates(beginning.six.arm, ends)) return true;
  return std::any_of(list.closures.begin(), list.closures.end(), [](const ArmClosure& closure) {
    return closure.smallest_singular_value < kNearlySingular;
  });
}

/// `known`: of an arm with one beginning. `as_witness`: searches from random postures.
ArmResult closures_at(const PreparedArm& prepared, const TypedPose& at, const Known& known,
                      std::uint64_t as_witness, const Tracker& tracker,
                      const std::atomic<bool>& stop) {
  const Arm& arm = prepared.arm;
  ArmResult result;
  result.message.clear();
  result.pose = at.pose;
  result.complete = prepared.is_complete;
  result.accuracy = std::max(kReach, at.accuracy * std::max(1.0, 1 / arm.length));
  take_account(prepared, tracker, result);
  PostureList list{arm, at.pose, result.accuracy, prepared.seed, {}, {}, {}, {}};
  std::vector<Arrivals> arrivals(prepared.beginnings.size());
  bool are_singular = false, are_all_simple = false;
  for (std::size_t k = 0; k < arrivals.size(); ++k) {
    const Beginning& beginning = prepared.beginnings[k];
    are_all_simple = known.by_formula && read_found(beginning, *known.by_formula, list, result);
    if (are_all_simple) continue;
    bool is_consistent = known.is_any();
    const auto ends = known.by_formula ? ends_of(*known.by_formula)
                      : is_consistent
                          ? known.by_family
                          : approach_all(beginning, at.pose, prepared.seed, is_consistent);
    result.complete = result.complete && is_consistent;
    if (!read_ends(beginning, ends, list, result, arrivals[k])) result.complete = false;
    are_singular = are_singular || !arrivals[k].singular.empty();
    if (may_have_become_real(beginning, ends, list)) {
      const StartsAtPose starts =
          starts_at(beginning.six.arm, at.pose, tracker, prepared.options, stop);
      for (const Eigen::VectorXd& start : starts.values) {
        enter(list, own_values(beginning.six, start), false);
      }
      result.complete = result.complete && starts.complete;
    }
    result.counts.complex += beginning.six.own.size() == kSixJoints ? beginning.regular.far : 0;
  }
  // Where all closures are simple, sets are those that digits leave open, through one of them.
  const bool may_be_sets = prepared.is_always_moving || are_singular ||
                           (are_all_simple ? can_move(list) : !list.moves.empty());
  // Where there is no posture the nearest one is told.
  const bool has_none = list.closures.empty() && list.moves.empty();
  search(list, result, may_be_sets ? kForSets : has_none ? kAsWitness : as_witness);
  for (Arrivals& of_beginning : arrivals) {
    for (const SingularEnd& end : of_beginning.singular) {
      if (!is_explained(end, list, of_beginning, result)) result.complete = false;
    }
  }
  for (const Arrivals& of_beginning : arrivals) {
    for (const Eigen::VectorXd& place : of_beginning.between_pairs) {
      if (!is_listed(list, place)) enter_meeting(list, place);
    }
  }
  for (const Eigen::VectorXd& place : list.places) {
    if (!is_listed(list, place)) result.complete = false;
  }
  // A posture within the digits would be told: there may be one where Newton's method did not come
  // to an end.
  const bool may_be_held = list.nearest && list.nearest->misfit <= list.accuracy + arm.rounding;
  if (list.closures.empty() && list.moves.empty() && may_be_held) result.complete = false;
  name_closures(list.closures);
  result.counts.real = list.closures.size();
  result.counts.complex = std::max(result.counts.complex, result.counts.real);
  for (const ArmClosure& closure : list.closures) {
    if (!closure.beyond.empty()) ++result.counts.beyond_limits;
  }
  result.message = message_of(arm, list, result);
  if (list.closures.empty() && list.moves.empty()) result.nearest = std::move(list.nearest);
  result.closures = std::move(list.closures);
  result.moves = std::move(list.moves);
  return result;
}

/// An arm whose poses are many: prepared once, with a family where that pays.
struct PreparedList {
  PreparedArm prepared;
  std::optional<PoseFamily> family;
  double share = 0;  ///< seconds that each pose has of it
};

/// Where it finds all closures of the regular pose.
std::optional<GroupFormula> formula_of(const Beginning& beginning) {
  const RegularPose& regular = beginning.regular;
  auto formula = group_formula(beginning.six.arm, regular.cut);
  if (!formula) return std::nullopt;
  const auto found =
      closures_by_formula(*formula, beginning.six.arm, regular.pose, regular.roots.size());
  return found ? formula : std::nullopt;
}

PreparedList prepare_list(const Arm& arm, std::size_t poses, const Tracker& tracker,
                          const SolveOptions& options, const std::atomic<bool>& stop) {
  const Stopwatch watch;
  PreparedList list{prepare(arm, tracker, options, stop), std::nullopt, 0};
  const PreparedArm& prepared = list.prepared;
  const bool has_one_count = options.start == StartKind::automatic && !prepared.is_always_moving &&
                             prepared.is_complete && prepared.beginnings.front().regular.far == 0;
  if (has_one_count) list.prepared.formula = formula_of(prepared.beginnings.front());
  if (has_one_count && !prepared.formula && poses >= kWorthAFamily) {
    const Arm& six = prepared.beginnings.front().six.arm;
    list.family = learn_pose_family(six, tracker, prepared.options, stop);
  }
  list.share = watch.total() / static_cast<double>(std::max<std::size_t>(1, poses));
  return list;
}

/// Solves poses in blocks, on all threads, and hands on what was begun in the order of the poses.
class PoseList {
 public:
  PoseList(PreparedList list, const std::vector<TypedPose>& poses, const Tracker& tracker,
           const SolveOptions& options, const std::atomic<bool>& stop)
      : list_(std::move(list)), poses_(poses), tracker_(tracker), options_(options), stop_(stop) {
    progress_.total = poses.size();
  }

  std::size_t threads() const {
    return std::max<std::size_t>(
        1, std::min(poses_.size(), static_cast<std::size_t>(thread_count(options_.threads))));
  }

  void solve(std::size_t begin, std::size_t count,
             const std::function<void(ArmResult&& result)>& take) {
    const auto followed = follow(begin, count);
    std::vector<std::optional<ArmResult>> results(count);
    std::atomic<std::size_t> next = 0;
    on_threads(static_cast<int>(std::min(count, threads())), [&] {
      for (std::size_t k = next++; k < count && !stop_ && !has_thrown_; k = next++) {
        results[k] = solve_one(begin + k, Known{followed[k], by_formula(begin + k)});
        tell();
      }
    });
    for (std::optional<ArmResult>& result : results) {
      if (result) take(std::move(*result));
    }
  }

 private:
  /// The ends of the block's poses by the family; empty where it does not answer.
  std::vector<std::vector<ApproachEnd>> follow(std::size_t begin, std::size_t count) const {
    if (!list_.family) return std::vector<std::vector<ApproachEnd>>(count);
    const Beginning& beginning = list_.prepared.beginnings.front();
    SolveOptions together = list_.prepared.options;
    together.threads = static_cast<int>(threads());
    return follow_poses(*list_.family, beginning.six.arm, std::span(poses_).subspan(begin, count),
                        beginning.regular.roots.size(), tracker_, together, stop_);
  }

  std::optional<FoundClosures> by_formula(std::size_t pose) const {
    const PreparedArm& prepared = list_.prepared;
    if (!prepared.formula) return std::nullopt;
    const Beginning& beginning = prepared.beginnings.front();
    return closures_by_formula(*prepared.formula, beginning.six.arm, poses_[pose].pose,
                               beginning.regular.roots.size());
  }

  ArmResult solve_one(std::size_t pose, const Known& known) const {
    const Stopwatch watch;
    ArmResult result = closures_at(list_.prepared, poses_[pose], known,
                                   pose % kWitnessed == 0 ? 1 : 0, tracker_, stop_);
    if (pose > 0 || known.is_any()) tell_followed(list_.prepared, known, result);
    result.time_s.total = watch.total() + list_.share;
    return result;
  }

  void tell() {
    const std::lock_guard lock(telling_);
    progress_.finite = ++progress_.done;
    if (!options_.progress || has_thrown_) return;
    try {
      options_.progress(progress_);
    } catch (...) {
      has_thrown_ = true;
      throw;
    }
  }

  PreparedList list_;
  const std::vector<TypedPose>& poses_;
  const Tracker& tracker_;
  const SolveOptions& options_;
  const std::atomic<bool>& stop_;
  std::mutex telling_;
  Progress progress_;
  std::atomic<bool> has_thrown_{false};  // the callback: no other pose begins
};

}  // namespace

ArmResult find_arm_closures(const Arm& arm, const TypedPose& given, const Tracker& tracker,
                            const SolveOptions& options, const std::atomic<bool>& stop) {
  require_unbroken(arm);
  require_unbroken(validate(options));
  const TypedPose pose = workable(given, "the pose");
  const Stopwatch watch;
  const PreparedArm prepared = prepare(arm, tracker, options, stop);
  ArmResult result = closures_at(prepared, pose, Known{}, kAsWitness, tracker, stop);
  result.time_s.total = watch.total();
  return result;
}

ArmResult find_arm_closures(const Arm& arm, const Eigen::Isometry3d& pose, const Tracker& tracker,
                            const SolveOptions& options, const std::atomic<bool>& stop) {
  return find_arm_closures(arm, TypedPose{pose}, tracker, options, stop);
}

void for_each_pose(const Arm& arm, const std::vector<TypedPose>& given, const Tracker& tracker,
                   const std::function<void(ArmResult&& result)>& take, const SolveOptions& options,
                   const std::atomic<bool>& stop) {
  require_unbroken(arm);
  require_unbroken(validate(options));
  std::vector<TypedPose> poses;
  poses.reserve(given.size());
  for (std::size_t k = 0; k < given.size(); ++k) {
    poses.push_back(workable(given[k], "pose " + std::to_string(k)));
  }
  PoseList list(prepare_list(arm, poses.size(), tracker, options, stop), poses, tracker, options,
                stop);
  const std::size_t block = kTogether * list.threads();
  for (std::size_t begin = 0; begin < poses.size() && !stop; begin += block) {
    list.solve(begin, std::min(block, poses.size() - begin), take);
  }
}

namespace {

std::vector<TypedPose> as_they_stand(const std::vector<Eigen::Isometry3d>& poses) {
  std::vector<TypedPose> typed;
  typed.reserve(poses.size());
  for (const Eigen::Isometry3d& pose : poses) typed.push_back({pose});
  return typed;
}

}  // namespace

void for_each_pose(const Arm& arm, const std::vector<Eigen::Isometry3d>& poses,
                   const Tracker& tracker, const std::function<void(ArmResult&& result)>& take,
                   const SolveOptions& options, const std::atomic<bool>& stop) {
  for_each_pose(arm, as_they_stand(poses), tracker, take, options, stop);
}

std::vector<ArmResult> find_arm_closures(const Arm& arm, const std::vector<TypedPose>& poses,
                                         const Tracker& tracker, const SolveOptions& options,
                                         const std::atomic<bool>& stop) {
  std::vector<ArmResult> begun;
  begun.reserve(poses.size());
  for_each_pose(
      arm, poses, tracker, [&](ArmResult&& result) { begun.push_back(std::move(result)); }, options,
      stop);
  return begun;
}

std::vector<ArmResult> find_arm_closures(const Arm& arm,
                                         const std::vector<Eigen::Isometry3d>& poses,
                                         const Tracker& tracker, const SolveOptions& options,
                                         const std::atomic<bool>& stop) {
  return find_arm_closures(arm, as_they_stand(poses), tracker, options, stop);
}

}  // namespace moivre
