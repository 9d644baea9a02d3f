// SPDX-License-Identifier: MIT
// Which postures hold the pose, of all that searches lead to? A list of closures that stand alone,
// and of sets on which joints move.
//
// A start becomes a posture by Newton's method (least squares, where the arm has fewer joints than
// six) on the product of transforms, as typed. It is entered if it misses the pose by no more than
// the pose is accurate; marked where only the digits of the file's numbers explain the rest.
// A posture whose smallest singular value is small is followed (self_motion.h): it may belong to a
// set. Postures of a set are not listed as closures, unless the digits of the pose or of the file
// are all that holds the set open.
#pragma once

#include <optional>

#include "moivre/arms/arm_closures.h"
#include "polish.h"

namespace moivre {

/// From a posture, within an accuracy.
struct FollowedFrom {
  Eigen::VectorXd values;
  double accuracy = 0;
};

struct PostureList {
  const Arm& arm;
  Eigen::Isometry3d pose;
  double accuracy = kReach;  ///< of the pose: radians, and lengths relative to the arm's
  std::uint64_t seed = 0;
  std::vector<ArmClosure> closures;
  std::vector<SelfMotion> moves;
  std::optional<NearestPosture> nearest;  ///< of all starts
  /// Places that hold the pose within its accuracy, but not to rounding as postures of six joints
  /// do: of a set that is not reported yet, or next to a closure.
  std::vector<Eigen::VectorXd> places;
  /// Sets that were looked for, whether there was one or not.
  std::vector<FollowedFrom> followed;
  /// Places where sets may cross, and curves were looked for.
  std::vector<Eigen::VectorXd> crossings;
  /// Not from closures that such a set has led to: they are on it, and a surface has a curve
  /// through each.
  bool follows_digits = true;
  /// Those that are entered from now on are all there are: none has to be looked for on sets.
  bool has_all_closures = false;
  /// What is reported of a set shows all of it.
  bool are_sets_whole = true;
};

struct PostureEntry {
  enum class Kind { none, closure, on_set } kind = Kind::none;
  std::size_t index = 0;  ///< of the closure or the set
  bool is_new = false;
  double moved = 0;  ///< from the start, radians or arm's lengths
};

/// Of the pose and the file as typed, not one that their digits leave open: there are no closures
/// on it.
bool is_exact(const SelfMotion& set);

/// It stands alone, whatever is asked: Newton's method converges to it, and one path leads there.
bool is_simple(const ArmClosure& closure);

/// `is_far`: the start is not near a closure, so that steps are damped.
PostureEntry enter(PostureList& list, const Eigen::VectorXd& start, bool is_far);
/// Where Newton's method led to already.
PostureEntry enter(PostureList& list, const Polished& polished);

/// Sets through closures where more directions are open within the digits than the reported sets go
/// along; within finer accuracies, too, where sets may cross. Where sets cross all are followed;
/// and what the digits leave open lets places drift aside from a set that is open within much
/// less, and hides it in a region. Before these, exact curves that come near to those that are
/// reported.
void follow_branches(PostureList& list);

/// Where a start leads to a place at which sets may cross, the tip moves so little along two
/// directions: all curves that pass there. Newton's method comes to one of them.
void follow_crossing(PostureList& list, const Eigen::VectorXd& start);

/// The place between two closures that are not real by so little that the pose is held within its
/// accuracy: a closure, where both meet.
void enter_meeting(PostureList& list, const Eigen::VectorXd& place);

/// Largest difference, turns modulo whole ones, slides relative to the arm's length.
double distance(const Arm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// Turns in (-pi, pi], a half turn from either side as pi.
void reduce_turns(const Arm& arm, Eigen::VectorXd& values);

/// Letters by values, larger first.
void name_closures(std::vector<ArmClosure>& closures);

}  // namespace moivre
