// SPDX-License-Identifier: MIT
// How do the joints move while the tip stands, within an accuracy? The set of postures through one
// of them, followed to its ends.
//
// At a posture the screws' smallest singular values tell candidates: joint velocities that move the
// tip least. Random steps along them, put right by Newton's method, come back to the set if there
// is one; it has as many dimensions as these places span.
// A set of dimension 1 is followed in steps of kStep to both sides until it closes or ends, in
// longer ones where it is straight and no closures are sought between its places. A larger one is
// covered: from each place to all sides, on to where none is yet, so that no posture of it is far
// from a sample.
// An exact set may be small: steps are then a tenth or a hundredth of that.
//   relations: r . q = constant on the whole set, for its joints that move, where it is a piece of
//   a plane in joint space
// Closures of the arm may lie on a set that is there only within the accuracy: between places of a
// curve (near_closures.h), anywhere on a surface.
#pragma once

#include <optional>
#include <vector>

#include "moivre/arms/arm_closures.h"
#include "set_place.h"

namespace moivre {

struct TracedSet {
  SelfMotion motion;
  SetPlaces curve;       ///< its places, where the dimension is 1
  double accuracy = 0;   ///< within which it was followed
  bool is_whole = true;  ///< it may be too large to be followed to all its ends
};

/// A curve of postures ends nowhere: one that does, where it misses the pose by more than rounding,
/// is there within the digits only.
bool has_ends(const SelfMotion& set);

/// A set is followed from closures that stand on it, again and again, and drifts aside by what the
/// accuracy leaves open: it is one that is reported if it is no nearer to the pose by this factor,
/// and no farther than this from that, radians and arm's lengths.
inline constexpr double kAsClear = 3, kBesideSet = 0.03;

struct SetSought {
  double accuracy = 0;  ///< radians, and lengths relative to the arm's
  std::uint64_t seed = 0;
  bool for_closures = true;  ///< closures_near() is asked of it
};

/// nullopt where the posture stands alone, or on a surface that is reported and as clear.
std::optional<TracedSet> trace_set(const Arm& arm, const Eigen::Isometry3d& pose,
                                   const Eigen::VectorXd& from, const SetSought& sought,
                                   const std::vector<SelfMotion>& told = {});

/// Where Newton's method is begun for the closures that are on a set that is there within an
/// accuracy only.
std::vector<Eigen::VectorXd> closures_near(const Arm& arm, const Eigen::Isometry3d& pose,
                                           TracedSet&& traced);

/// Where sets cross that are open within the accuracy the tip can move little along `weak`
/// directions and more: the sets that go on along some of them, from a place that is clearly on
/// one.
std::vector<TracedSet> trace_branches(const Arm& arm, const Eigen::Isometry3d& pose,
                                      const Eigen::VectorXd& crossing, int weak,
                                      const SetSought& sought, const std::vector<SelfMotion>& told);

}  // namespace moivre
