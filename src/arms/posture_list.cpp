// SPDX-License-Identifier: MIT
// Newton's method from a start, sets through what it finds, limits and letters.
#include "posture_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <tuple>
#include <utility>

#include "least_motion.h"
#include "moivre/factorization/svd.h"
#include "moivre/mechanism/closure_id.h"
#include "near_curves.h"
#include "self_motion.h"
#include "set_place.h"

namespace moivre {
namespace {

/// Of the smallest singular value.
constexpr double kStandsAlone = 1e-6;
/// Postures that are nearer to a set are of it: they are known to half the digits where sets meet.
constexpr double kOnSet = 1e-4;
/// A set that reaches farther than this, radians, is looked for where the accuracy may move a joint
/// so far.
constexpr double kReachesFar = 0.05;
/// Joints that reach every pose.
constexpr std::size_t kFullArm = 6;
/// Closures and sets from which further ones are looked for.
constexpr std::size_t kMostFollowed = 64;

/// By how much a tip that stands may seem to move.
constexpr double kRounding = 1e-12;

/// By how much the tip may miss the pose, as its digits and those of the file leave it open.
double by_digits(const PostureList& list) { return list.accuracy + list.arm.rounding; }

/// What the pose's digits leave open, and then the file's, too: nothing but rounding where all
/// digits are typed.
struct Accuracies {
  std::array<double, 2> all{};
  std::size_t count = 0;

  const double* begin() const { return all.data(); }
  const double* end() const { return all.data() + count; }
};
Accuracies left_open(const PostureList& list) {
  Accuracies accuracies;
  const auto add = [&](double accuracy) { accuracies.all[accuracies.count++] = accuracy; };
  if (list.accuracy > kReach) add(list.accuracy);
  if (list.arm.rounding > 0) add(by_digits(list));
  return accuracies;
}

/// What rounding moves a closure by, along a direction of this singular value: forward kinematics
/// is wrong by some units of the last bit for each joint, and where k closures meet Newton's step
/// is a k-th of the way to them.
double reach_of_rounding(const ArmClosure& closure, double sigma) {
  constexpr double kLastDigits = 2.5e-15, kMeet = 4;
  return kMeet * (kLastDigits + closure.residual) / std::max(sigma, 1e-300);
}

constexpr double kMovedAtMost = 1e-2;

double moved_by_rounding(const ArmClosure& closure, double sigma) {
  constexpr double kLeast = 1e-9;
  return std::clamp(reach_of_rounding(closure, sigma), kLeast, kMovedAtMost);
}

/// Whether Newton's method has come to the last digits, or what is left moves the posture little.
bool is_at_rest(const ArmClosure& closure) {
  constexpr double kAtRest = 2e-14;
  return closure.residual <= kAtRest ||
         reach_of_rounding(closure, closure.smallest_singular_value) <= kMovedAtMost;
}

/// Whether `to` may be the closure `from` but for rounding, which moves it along some directions by
/// more than along others.
bool is_moved_by_rounding(const PostureList& list, const ArmClosure& from, const ArmClosure& to) {
  const double margin = moved_by_rounding(to, to.smallest_singular_value);
  const Svd stretch =
      svd(linearized(list.arm, list.pose, from.values).screws, SingularVectors::full);
  const Eigen::VectorXd along =
      stretch.V.transpose() * way_between(list.arm, from.values, to.values);
  for (Eigen::Index k = 0; k < along.size(); ++k) {
    const double sigma = k < stretch.sigma.size() ? stretch.sigma[k] : 0;
    if (std::abs(along[k]) > moved_by_rounding(from, sigma) + margin) return false;
  }
  return true;
}

ArmClosure closure_of(const PostureList& list, const Polished& polished) {
  const Arm& arm = list.arm;
  ArmClosure closure;
  closure.values = polished.values;
  closure.residual = polished.residual;
  closure.newton_iterations = polished.iterations;
  closure.smallest_singular_value = polished.smallest_singular_value;
  closure.singular = polished.smallest_singular_value <= kRounding;
  closure.weakest = weakest_motion(arm, polished);
  closure.moved_by_digits = arm.rounding / std::max(polished.smallest_singular_value, 1e-300);
  closure.within_digits = polished.residual > list.accuracy;
  reduce_turns(arm, closure.values);
  closure.in_limits = closure.values;
  closure.beyond = place_in_limits(arm, closure.in_limits);
  return closure;
}

/// As distance() tells, from the first joint on that tells.
bool are_near(const Arm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b, double within) {
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    if (!(std::abs(joint_way(arm, a, b, k)) <= within)) return false;
  }
  return true;
}

std::optional<std::size_t> listed(const PostureList& list, const ArmClosure& closure) {
  constexpr double kClearlyOne = 1e-9;
  for (std::size_t k = 0; k < list.closures.size(); ++k) {
    const ArmClosure& other = list.closures[k];
    const bool is_worse = closure.smallest_singular_value < other.smallest_singular_value;
    const auto& [worse, better] = is_worse ? std::tie(closure, other) : std::tie(other, closure);
    const double within = moved_by_rounding(closure, closure.smallest_singular_value) +
                          moved_by_rounding(other, other.smallest_singular_value);
    if (!are_near(list.arm, closure.values, other.values, within)) continue;
    const double away = distance(list.arm, closure.values, other.values);
    if (away <= kClearlyOne || is_moved_by_rounding(list, worse, better)) return k;
  }
  return std::nullopt;
}

bool is_any(const SelfMotion&) { return true; }

/// As rounding tells.
bool stands_exactly(const SelfMotion& set) { return set.misfit <= kRounding && !has_ends(set); }

/// As well as any pose is known.
bool stands_whole(const SelfMotion& set) { return set.misfit <= kReach && !has_ends(set); }

/// Or, as rounding tells, a curve that ends: it has closures.
bool has_an_exact_part(const SelfMotion& set) {
  return stands_whole(set) || (set.misfit <= kRounding && has_ends(set));
}

std::optional<std::size_t> set_of(const PostureList& list, const Eigen::VectorXd& values,
                                  bool (*is_meant)(const SelfMotion&)) {
  for (std::size_t k = 0; k < list.moves.size(); ++k) {
    if (is_meant(list.moves[k]) && is_on(list.arm, list.moves[k], values, kOnSet)) return k;
  }
  return std::nullopt;
}

/// Whether double tells a posture from those along the joints' weakest motion: they miss the pose
/// by clearly more. Where the digits leave a set open one closure more leads to others.
bool stands_alone(const PostureList& list, const SelfMotion& set, const Polished& posture) {
  constexpr double kAway = 1e-2, kClearlyMore = 2;
  const double missed =
      set.misfit <= kReach ? std::max(kLeastError, kClearlyMore * posture.residual) : kLeastError;
  const SetPlace place = place_at(list.arm, list.pose, posture.values);
  const Eigen::VectorXd way = posture.least_moving;
  return !moved(list.arm, list.pose, place, way, kAway, missed) &&
         !moved(list.arm, list.pose, place, -way, kAway, missed);
}

/// The closures that are on a set within the digits.
void enter_near(PostureList& list, TracedSet&& traced) {
  if (list.has_all_closures) return;
  const bool followed_digits = std::exchange(list.follows_digits, false);
  const auto starts = closures_near(list.arm, list.pose, std::move(traced));
  for (const Eigen::VectorXd& start : starts) enter(list, start, false);
  list.follows_digits = followed_digits;
}

/// Adds a set, with the closures near it where it is one of the digits only. Its number where it is
/// exact, or where one is that it was taken for.
std::optional<std::size_t> add(PostureList& list, TracedSet&& traced, bool is_within_digits) {
  const bool is_there = stands_exactly(traced.motion);
  traced.motion.within_digits = is_within_digits;
  // Where sets meet the posture may not be known well enough to be seen on one that is there.
  if (const auto same = set_of(list, traced.motion.values, stands_whole)) return same;
  // An exact plane is recognized by its relations.
  const bool is_plane = is_there && !traced.motion.relations.empty();
  if (!traced.is_whole && !is_plane) list.are_sets_whole = false;
  list.moves.push_back(traced.motion);
  if (is_there) return list.moves.size() - 1;
  enter_near(list, std::move(traced));
  return std::nullopt;
}

/// The one that is reported, is as clear, and goes there; or the end.
std::vector<SelfMotion>::iterator told_as(PostureList& list, const SelfMotion& set) {
  return std::find_if(list.moves.begin(), list.moves.end(), [&](const SelfMotion& told) {
    if (told.dimension < set.dimension || told.misfit > kAsClear * set.misfit) return false;
    const auto is_there = [&](const Eigen::VectorXd& values) {
      return is_on(list.arm, told, values, kBesideSet);
    };
    // A loop's first and last samples are neighbours.
    return is_there(set.values) && is_there(set.samples.front()) && is_there(set.samples.back()) &&
           is_there(set.samples[set.samples.size() / 2]);
  });
}

/// One that the accuracy of the pose leaves open, or the digits beyond that.
std::optional<std::size_t> add_open(PostureList& list, TracedSet&& traced) {
  SelfMotion& set = traced.motion;
  const bool is_within_digits = set.misfit > list.accuracy;
  const auto told = told_as(list, set);
  if (told == list.moves.end()) return add(list, std::move(traced), is_within_digits);
  const bool is_flatter = told->relations.empty() && !set.relations.empty();
  if (is_flatter && told->dimension == set.dimension) {
    set.within_digits = is_within_digits;
    *told = std::move(set);
  }
  return std::nullopt;
}

SetSought sought(const PostureList& list, double accuracy) {
  return {accuracy, list.seed, !list.has_all_closures};
}

/// The set through a place that is open within the accuracy.
std::optional<TracedSet> set_through(const PostureList& list, const Eigen::VectorXd& from,
                                     double accuracy) {
  return trace_set(list.arm, list.pose, from, sought(list, accuracy), list.moves);
}

/// As rounding tells; of a piece that ends, the set that it is a piece of, where that holds the
/// pose within its accuracy.
std::optional<TracedSet> trace_exactly(const PostureList& list, const Eigen::VectorXd& from) {
  auto traced = trace_set(list.arm, list.pose, from, sought(list, kRounding));
  if (!traced || !has_ends(traced->motion)) return traced;
  auto whole = trace_set(list.arm, list.pose, from, sought(list, list.accuracy));
  return whole && !has_ends(whole->motion) ? whole : traced;
}

/// Adds the set through the posture, its number where it is one of the pose and the file as typed.
std::optional<std::size_t> add_set(PostureList& list, const ArmClosure& closure) {
  const double sigma = closure.smallest_singular_value;
  const Accuracies accuracies = left_open(list);
  if (sigma <= kStandsAlone && !set_of(list, closure.values, has_an_exact_part)) {
    auto traced = trace_exactly(list, closure.values);
    // What is told and has led here is found again from here.
    const bool is_told = traced && told_as(list, traced->motion) != list.moves.end();
    if (is_told && (!list.follows_digits || !has_ends(traced->motion))) return std::nullopt;
    if (traced) {
      const bool is_within_digits = accuracies.count > 0 && has_ends(traced->motion);
      return add(list, std::move(*traced), is_within_digits);
    }
  }
  for (const double accuracy : accuracies) {
    if (!list.follows_digits || sigma > accuracy / kReachesFar) continue;
    if (set_of(list, closure.values, is_any)) return std::nullopt;
    list.followed.push_back({closure.values, accuracy});
    auto traced = set_through(list, closure.values, accuracy);
    if (!traced) continue;
    return add_open(list, std::move(*traced));
  }
  return std::nullopt;
}

/// Newton's method ends beside the closures of a set that is there within the digits only: it goes
/// along that set in steps that are too long.
/// Followed, the set shows where they are.
void follow_digits(PostureList& list, const Polished& place) {
  for (const double accuracy : left_open(list)) {
    if (!list.follows_digits || place.residual > accuracy) continue;
    if (set_of(list, place.values, is_any)) return;
    auto traced = set_through(list, place.values, accuracy);
    if (!traced || set_of(list, traced->motion.values, is_any)) continue;
    add_open(list, std::move(*traced));
    return;
  }
}

/// Along which the tip can move so little that the accuracy leaves them open.
int weak_directions(const Screws<double>& screws, double accuracy) {
  return still_count(screws, accuracy / kReachesFar);
}

/// A curve that ends within much less than the accuracy.
bool is_piece(const SelfMotion& set, double accuracy) {
  constexpr double kMuchLess = 0.1;
  return has_ends(set) && set.misfit <= kMuchLess * accuracy;
}

/// The largest of the sets through the posture that are reported to be open within the accuracy.
/// What is but a piece is none.
int dimension_told(const PostureList& list, const Eigen::VectorXd& values, double accuracy) {
  int largest = 0;
  for (const SelfMotion& set : list.moves) {
    const bool is_more =
        set.misfit <= accuracy && !is_piece(set, accuracy) && set.dimension > largest;
    if (is_more && is_on(list.arm, set, values, kOnSet)) largest = set.dimension;
  }
  return largest;
}

/// The sets through the posture, where as many directions are open as `weak`, but for what was
/// followed already.
std::vector<TracedSet> sets_through(const PostureList& list, const Eigen::VectorXd& values,
                                    int weak, double accuracy) {
  if (weak > 1)
    return trace_branches(list.arm, list.pose, values, weak, sought(list, accuracy), list.moves);
  std::vector<TracedSet> sets;
  const bool is_known =
      std::any_of(list.followed.begin(), list.followed.end(), [&](const FollowedFrom& followed) {
        return followed.accuracy == accuracy && followed.values == values;
      });
  if (is_known) return sets;
  auto traced = set_through(list, values, accuracy);
  if (traced) sets.push_back(std::move(*traced));
  return sets;
}

/// A piece may go on within the accuracy, and close: whether that is reported must not depend on
/// where a way along it began.
void follow_pieces(PostureList& list, double accuracy) {
  for (std::size_t k = 0; k < std::min(kMostFollowed, list.moves.size()); ++k) {
    if (!is_piece(list.moves[k], accuracy)) continue;
    const std::vector<Eigen::VectorXd>& samples = list.moves[k].samples;
    const Eigen::VectorXd middle = samples[samples.size() / 2];
    const bool is_told =
        std::any_of(list.moves.begin(), list.moves.end(), [&](const SelfMotion& told) {
          return told.closes && told.misfit <= accuracy &&
                 is_on(list.arm, told, middle, kBesideSet);
        });
    if (is_told) continue;
    auto whole = set_through(list, middle, accuracy);
    if (whole && whole->motion.closes) add_open(list, std::move(*whole));
  }
}

/// Other curves as the pose and the file have them, next to those that are reported.
void follow_near_curves(PostureList& list) {
  for (std::size_t k = 0; k < std::min(kMostFollowed, list.moves.size()); ++k) {
    if (list.moves[k].dimension != 1 || !stands_whole(list.moves[k])) continue;
    for (const Eigen::VectorXd& start :
         near_curves(list.arm, list.pose, list.moves[k].samples, list.accuracy)) {
      enter(list, start, false);
    }
  }
}

}  // namespace

bool is_exact(const SelfMotion& set) { return !set.within_digits && set.misfit <= kReach; }

bool is_simple(const ArmClosure& closure) {
  // Closures that meet are this near to each other, in their singular values, as rounding lets them
  // be known.
  constexpr double kRoundingOfMiss = 1e-15, kShare = 0.01;
  const double sigma = closure.smallest_singular_value;
  return closure.residual + kRoundingOfMiss < kShare * sigma * sigma;
}

double distance(const Arm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == 0 ? 0 : way_between(arm, a, b).cwiseAbs().maxCoeff();
}

void reduce_turns(const Arm& arm, Eigen::VectorXd& values) {
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    double& value = values[static_cast<Eigen::Index>(k)];
    if (!arm.joints[k].is_slide) value = reduced_turn(value);
  }
}

void name_closures(std::vector<ArmClosure>& closures) {
  constexpr double kGrid = 1e-6;
  std::sort(closures.begin(), closures.end(), [&](const ArmClosure& a, const ArmClosure& b) {
    for (Eigen::Index k = 0; k < a.values.size(); ++k) {
      const double first = std::round(a.values[k] / kGrid), other = std::round(b.values[k] / kGrid);
      if (first != other) return first > other;
    }
    return false;
  });
  for (std::size_t k = 0; k < closures.size(); ++k) closures[k].id = closure_id(k);
}

PostureEntry enter(PostureList& list, const Eigen::VectorXd& start, bool is_far) {
  const Polished polished = polish(list.arm, list.pose, start, is_far);
  PostureEntry entry = enter(list, polished);
  entry.moved = distance(list.arm, polished.values, start);
  return entry;
}

void follow_crossing(PostureList& list, const Eigen::VectorXd& start) {
  constexpr double kSameCrossing = 0.1;
  const Eigen::VectorXd values = polish(list.arm, list.pose, start).values;
  const bool is_known = std::any_of(
      list.crossings.begin(), list.crossings.end(),
      [&](const Eigen::VectorXd& one) { return are_near(list.arm, one, values, kSameCrossing); });
  if (is_known) return;
  const SetPlace place = place_at(list.arm, list.pose, values);
  for (const Eigen::VectorXd& near : near_curves(list.arm, list.pose, place, list.accuracy)) {
    enter(list, near, false);
  }
  list.crossings.push_back(values);
}

void enter_meeting(PostureList& list, const Eigen::VectorXd& place) {
  ArmClosure closure = closure_of(list, polish(list.arm, list.pose, place));
  closure.multiplicity = 2;
  closure.singular = true;
  list.closures.push_back(std::move(closure));
}

PostureEntry enter(PostureList& list, const Polished& polished) {
  if (!list.nearest || polished.residual < list.nearest->misfit) {
    list.nearest = {polished.values, polished.residual, {}};
    reduce_turns(list.arm, list.nearest->values);
  }
  PostureEntry entry;
  // Six joints can be put right to rounding: what is not is a place of a set that the accuracy or
  // the digits leave open.
  const bool has_six = list.arm.joints.size() >= kFullArm;
  if (!(polished.residual <= (has_six ? kRounding : by_digits(list)))) {
    const bool is_place = polished.residual <= list.accuracy && list.follows_digits;
    if (is_place) list.places.push_back(polished.values);
    if (has_six) follow_digits(list, polished);
    return entry;
  }
  ArmClosure closure = closure_of(list, polished);
  // Of a set that is there within the digits, a posture may be on an exact one as well.
  bool is_exact_one_sought = closure.smallest_singular_value <= kStandsAlone;
  const auto known = [&]() -> std::optional<PostureEntry> {
    if (const auto same = listed(list, closure)) {
      // Of the two the one that holds the pose as typed is reported.
      ArmClosure& told = list.closures[*same];
      if (told.within_digits && !closure.within_digits) {
        closure.multiplicity = told.multiplicity;
        closure.singular = told.singular;
        told = closure;
      }
      return PostureEntry{PostureEntry::Kind::closure, *same, false, 0};
    }
    // A closure may stand on a set that is there within the digits only; a place on the way to one,
    // and what double does not tell from other places of the set, is of that set.
    auto set = set_of(list, closure.values, stands_exactly);
    if (!set) set = set_of(list, closure.values, is_exact_one_sought ? has_an_exact_part : is_any);
    if (!set) return std::nullopt;
    const bool is_closure = !stands_exactly(list.moves[*set]) && !closure.within_digits &&
                            is_at_rest(closure) && stands_alone(list, list.moves[*set], polished);
    if (is_closure) return std::nullopt;
    return PostureEntry{PostureEntry::Kind::on_set, *set, false, 0};
  };
  if (const auto same = known()) return *same;
  const std::size_t sets = list.moves.size(), followed = list.followed.size();
  if (const auto set = add_set(list, closure)) return {PostureEntry::Kind::on_set, *set, true, 0};
  const bool may_be_known = std::exchange(is_exact_one_sought, false) || list.moves.size() > sets ||
                            list.followed.size() > followed;
  if (may_be_known) {
    if (const auto same = known()) return *same;
  }
  list.closures.push_back(std::move(closure));
  return {PostureEntry::Kind::closure, list.closures.size() - 1, true, 0};
}

void follow_branches(PostureList& list) {
  follow_near_curves(list);
  constexpr double kFiner[] = {1, 0.1, 0.01};
  for (const double widest : left_open(list)) {
    for (std::size_t k = 0; k < std::min(kMostFollowed, list.closures.size()); ++k) {
      if (list.closures[k].smallest_singular_value > widest / kReachesFar) continue;
      const Eigen::VectorXd values = list.closures[k].values;
      const Screws<double> screws = linearized(list.arm, list.pose, values).screws;
      const bool is_crossing = weak_directions(screws, widest) > 1;
      for (const double fine : kFiner) {
        if (fine < 1 && !is_crossing) break;  // a piece of the one curve
        const double accuracy = fine * widest;
        const bool is_stiff = list.arm.joints.size() <= kFullArm &&
                              list.closures[k].smallest_singular_value > accuracy / kReachesFar;
        if (is_stiff) continue;
        const int weak = weak_directions(screws, accuracy);
        if (weak <= dimension_told(list, values, accuracy)) continue;
        for (TracedSet& set : sets_through(list, values, weak, accuracy)) {
          add_open(list, std::move(set));
        }
      }
    }
    for (auto fine = std::rbegin(kFiner); fine != std::rend(kFiner); ++fine) {
      follow_pieces(list, *fine * widest);
    }
  }
}

}  // namespace moivre
