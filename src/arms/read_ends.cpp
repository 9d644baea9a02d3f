// SPDX-License-Identifier: MIT
// From regular ends to closures, from singular ones to what explains them.
#include "read_ends.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "complex_set.h"
#include "random_values.h"
#include "self_motion.h"
#include "set_place.h"

namespace moivre {
namespace {

double imaginary_size(const Arm& arm, const JointVector<Complex>& values) {
  double largest = 0;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
    largest = std::max(largest, std::abs(values[k].imag()) / (is_slide ? arm.length : 1));
  }
  return largest;
}

/// How far the turns that were added are from 0, where they stand at a closure of the arm.
double added_size(const ArmBeginning& beginning, const ApproachEnd& end) {
  double largest = 0;
  for (std::size_t k = beginning.six.own.size(); k < beginning.six.arm.joints.size(); ++k) {
    const Complex angle = end.values[static_cast<Eigen::Index>(k)];
    const double within_turn = std::remainder(angle.real(), 2 * std::numbers::pi);
    largest = std::max(largest, std::hypot(within_turn, angle.imag()));
  }
  return largest;
}

PlaceOfEnd place_of(const SixJoints& six, const ApproachEnd& end) {
  const Eigen::VectorXd start = own_values(six, end.values.real());
  const Eigen::VectorXd sum = end.values.real() + end.values.imag();
  return {start, own_values(six, sum) - start};
}

/// Paths stop before they are there, where three and more meet.
constexpr double kNear = 0.03;

/// The nearest closure that the path may have come to. One path alone comes to a simple closure,
/// however near to singular it is; with joints that were added to an arm's own several may, and
/// also to one that is singular with these joints only.
std::optional<std::size_t> closure_of(const SingularEnd& end, const PostureList& list,
                                      const PathsSeen& seen) {
  constexpr double kSingular = 1e-3;
  const bool has_all_joints = list.arm.joints.size() >= kSixJoints;
  std::optional<std::size_t> nearest;
  double least = kNear;
  for (std::size_t k = 0; k < list.closures.size(); ++k) {
    const ArmClosure& closure = list.closures[k];
    if (has_all_joints && closure.smallest_singular_value > kSingular) continue;
    const double away = distance(list.arm, closure.values, end.values);
    const bool has_room = !has_all_joints || !is_simple(closure) || !seen.paths_to.contains(k);
    if (!has_room || away > least) continue;
    least = away;
    nearest = k;
  }
  return nearest;
}

/// On a set that is there within digits only the arm as typed has closures. Along a curve signs
/// tell where (near_closures.h); on a surface they were sought from places that are apart, and that
/// says nothing of what lies between.
bool is_searched(const SelfMotion& set) {
  return set.dimension == 1 && (set.misfit > kReach || has_ends(set));
}

bool is_at_set(const SingularEnd& end, const PostureList& list,
               const std::function<bool(const SelfMotion&)>& is_meant) {
  return std::any_of(list.moves.begin(), list.moves.end(), [&](const SelfMotion& set) {
    return is_meant(set) && is_on(list.arm, set, end.values, kNear);
  });
}

/// Whether the end is at a set or a closure that is listed.
bool is_at_listed(const SingularEnd& end, PostureList& list, PathsSeen& seen, ArmResult& result) {
  if (is_at_set(end, list, is_exact)) return true;
  const auto at = closure_of(end, list, seen);
  if (!at) return is_at_set(end, list, is_searched);
  ArmClosure& closure = list.closures[*at];
  closure.multiplicity = std::max(closure.multiplicity, ++seen.paths_to[*at]);
  closure.singular = !is_simple(closure);
  ++result.counts.complex;
  return true;
}

/// The pose is held on the way from what is listed to a place.
bool hold_between(const PostureList& list, const Eigen::VectorXd& values,
                  const Eigen::VectorXd& place) {
  constexpr double kShortWay = 0.3;
  const double away = distance(list.arm, values, place);
  if (away <= kNear) return true;
  const Eigen::VectorXd way = way_between(list.arm, values, place);
  const SetPlace from = place_at(list.arm, list.pose, values);
  const auto half_way = place_between(list.arm, list.pose, from, way, list.accuracy);
  if (!half_way || away <= kShortWay) return half_way.has_value();
  return hold_between(list, values, half_way->values) &&
         hold_between(list, half_way->values, place);
}

}  // namespace

bool read_ends(const ArmBeginning& beginning, const std::vector<ApproachEnd>& ends,
               PostureList& list, ArmResult& result, PathsSeen& seen) {
  constexpr double kNearlyReal = 0.1, kFarthest = 0.1, kMargin = 10, kSameStart = 1e-6;
  const SixJoints& six = beginning.six;
  const bool has_all_joints = six.own.size() == kSixJoints;
  const double accuracy = list.accuracy + list.arm.rounding;
  // What a pose leaves open may be as large as a pair is far from real: of a straight wrist two
  // turns of opposite sense may be infinitely far from real, and their sum is.
  const bool is_coarse = list.accuracy > kReach;
  bool are_read = true;
  std::vector<Eigen::VectorXd> pairs;
  if (beginning.regular.far == 0) {
    for (const std::size_t k : without_conjugate(six.arm, ends)) {
      seen.unpaired.push_back(place_of(six, ends[k]));
      if (!has_all_joints) are_read = false;
    }
  }
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const ApproachEnd& end = ends[k];
    if (end.kind == ApproachKind::lost) continue;
    const double imaginary = imaginary_size(six.arm, end.values);
    const Eigen::VectorXd start = own_values(six, end.values.real());
    if (end.kind == ApproachKind::singular) {
      enter(list, start, false);
      seen.singular.push_back(
          {place_of(six, end), imaginary, added_size(beginning, end), end.to_go});
      continue;
    }
    const bool is_infinite = end.kind == ApproachKind::infinite;
    const bool is_nearly_real = is_coarse || imaginary <= kNearlyReal;
    // A posture within the digits alone is marked; what is not real is of the arm as typed.
    const double open = is_nearly_real ? accuracy : list.accuracy;
    const bool counts = !is_infinite && added_size(beginning, end) <= kMargin * open;
    const std::size_t places = list.places.size();
    const PostureEntry entry = is_nearly_real ? enter(list, start, false) : PostureEntry{};
    if (list.places.size() > places) seen.between_pairs.push_back(list.places.back());
    if (is_infinite) continue;
    // Of axes that meet but for the file's digits two may be in line: then there are closures to
    // which no path leads, near this pair. Its other one has the same real part.
    const bool is_begun = std::any_of(pairs.begin(), pairs.end(), [&](const Eigen::VectorXd& one) {
      return distance(list.arm, one, start) <= kSameStart;
    });
    if (!is_nearly_real && has_all_joints && !is_begun) {
      enter(list, start, false);
      pairs.push_back(start);
    }
    if (entry.kind == PostureEntry::Kind::closure && entry.moved <= kFarthest) {
      ArmClosure& closure = list.closures[entry.index];
      // An end elsewhere may have led here before: that was no path of this closure.
      const std::uint64_t arrived = counts ? ++seen.paths_to[entry.index] : 0;
      if (arrived == 1 || entry.is_new) closure.path = end.path;
      closure.multiplicity = std::max(closure.multiplicity, arrived);
      closure.singular = closure.singular || closure.multiplicity > 1;
      if (counts || entry.is_new) ++result.counts.complex;
      continue;
    }
    if (entry.kind == PostureEntry::Kind::on_set) continue;
    if (counts) ++result.counts.complex;
    const bool is_real = imaginary <= 10 * end.accuracy + 1e-10;
    if (is_real && has_all_joints) are_read = false;
  }
  return are_read;
}

// Beside a pair with imaginary parts y whose Jacobian has a smallest singular value s the pose is
// missed by y s / 2 at the least; where an added joint stands at x, by s x. A set that is open
// within the accuracy has closures on its continuation, real or not, at which the tip can move as
// little: it is looked for beside such pairs alone.
bool read_found(const ArmBeginning& beginning, const FoundClosures& found, PostureList& list,
                ArmResult& result) {
  constexpr double kClearly = 8, kMargin = 10, kMayReach = 0.01;
  const SixJoints& six = beginning.six;
  const bool has_all_joints = six.own.size() == kSixJoints;
  const double accuracy = list.accuracy + list.arm.rounding;
  const double clear = kClearly * accuracy;
  const auto added_at = [&](const auto& values) {
    return values.tail(values.size() - std::ssize(six.own)).cwiseAbs().sum();
  };
  for (const ConjugatePair& pair : found.pairs) {
    if (pair.imaginary * pair.stiffness <= clear) return false;
  }
  std::vector<const Polished*> own;
  own.reserve(found.real.size());
  for (const Polished& real : found.real) {
    const double added = has_all_joints ? 0 : added_at(real.values);
    if (added <= kMargin * accuracy) {
      own.push_back(&real);
    } else if (added * real.smallest_singular_value <= clear) {
      return false;
    }
  }
  if (own.empty()) return false;  // the nearest posture is reported
  list.closures.reserve(own.size());
  // As many closures are found as the regular pose has, and no path leads to them.
  auto regular = beginning.regular.roots.begin();
  for (const Polished* const real : own) {
    const PostureEntry entry =
        has_all_joints ? enter(list, *real) : enter(list, own_values(six, real->values), false);
    const std::uint64_t path = regular++->path;
    if (entry.kind == PostureEntry::Kind::closure && entry.is_new) {
      list.closures[entry.index].path = path;
    }
    if (entry.kind != PostureEntry::Kind::on_set) ++result.counts.complex;
  }
  for (const ConjugatePair& pair : found.pairs) {
    if (has_all_joints || added_at(pair.values) <= kMargin * list.accuracy) {
      result.counts.complex += 2;
    }
    const bool is_weak = pair.stiffness * kMayReach < accuracy;
    if (has_all_joints && is_weak) enter(list, own_values(six, pair.values.real()), false);
  }
  return true;
}

namespace {

/// By the relations of a set, which are real: real and imaginary parts are along the plane.
bool is_on_plane(const PlaceOfEnd& end, const PostureList& list) {
  constexpr double kOnPlane = 1e-3;
  return std::any_of(list.moves.begin(), list.moves.end(), [&](const SelfMotion& set) {
    const bool is_told = is_exact(set) || set.misfit > kReach;
    if (set.relations.empty() || !is_told) return false;
    return is_on(list.arm, set, end.values, kOnPlane) &&
           is_on(list.arm, set, end.values + end.imaginary, kOnPlane);
  });
}

/// Whether the pose is held on the way to one of its samples.
bool leads_to(const PostureList& list, const SelfMotion& set, const Eigen::VectorXd& place) {
  return std::any_of(set.samples.begin(), set.samples.end(), [&](const Eigen::VectorXd& sample) {
    return hold_between(list, sample, place);
  });
}

/// Near to a set that is reported, or one leads there; that takes longer.
bool is_on_told(const PostureList& list, const Eigen::VectorXd& place) {
  return std::any_of(list.moves.begin(), list.moves.end(),
                     [&](const SelfMotion& set) { return is_on(list.arm, set, place, kNear); }) ||
         std::any_of(list.moves.begin(), list.moves.end(),
                     [&](const SelfMotion& set) { return leads_to(list, set, place); });
}

}  // namespace

bool is_on_continuation(const PlaceOfEnd& end, PostureList& list) {
  if (is_on_plane(end, list)) return true;
  JointVector<Complex> values(end.values.size());
  for (Eigen::Index k = 0; k < values.size(); ++k) values[k] = {end.values[k], end.imaginary[k]};
  const auto real = real_place_of(list.arm, list.pose, values, list.accuracy);
  if (!real) return false;
  enter(list, *real, false);
  return is_on_told(list, *real);
}

bool is_explained(const SingularEnd& end, PostureList& list, PathsSeen& seen, ArmResult& result) {
  constexpr double kNotReal = 1e-2, kFarBefore = 0.1, kClearly = 4, kMargin = 10;
  constexpr std::uint64_t kBeside = 16, kBehindOthers = 20'000;
  const double clear = kClearly * end.to_go;
  // A path that stopped far before its end tells nothing of it, unless it was farther still from
  // what is real.
  const bool stopped_early = end.to_go > kFarBefore;
  if (!stopped_early && is_at_listed(end, list, seen, result)) return true;
  if (end.added > std::max(kNear, clear)) return true;
  if (end.imaginary_size > std::max(kNotReal, clear)) {
    ++result.counts.complex;
    return true;
  }
  if (stopped_early) return is_on_continuation(end, list);
  for (std::uint64_t k = 0; k < kBeside; ++k) {
    const Eigen::VectorXd way = random_joint_values(list.arm, list.seed, kBehindOthers + k);
    enter(list, end.values + kNear / std::numbers::pi * way, false);
  }
  // Where an added joint clearly stands elsewhere, and nothing beside it holds the pose, there is
  // no closure of the arm.
  return is_at_listed(end, list, seen, result) || is_on_continuation(end, list) ||
         end.added > std::max(clear, kMargin * list.accuracy);
}

bool is_of_open_set(const PostureList& list, const Eigen::VectorXd& values) {
  if (list.accuracy <= kReach) return false;
  return std::any_of(list.moves.begin(), list.moves.end(), [&](const SelfMotion& set) {
    return set.misfit <= list.accuracy &&
           (is_on(list.arm, set, values, kNear) || leads_to(list, set, values));
  });
}

bool is_listed(const PostureList& list, const Eigen::VectorXd& place) {
  return is_on_told(list, place) ||
         std::any_of(list.closures.begin(), list.closures.end(), [&](const ArmClosure& closure) {
           return hold_between(list, closure.values, place);
         });
}

}  // namespace moivre
