// SPDX-License-Identifier: MIT
// Which postures do the ends of paths tell of?
//
//   regular    a closure, or none: complex, or one of the joints that were added is not at 0
//   singular   closures meet there, or a set is there: explained by what is listed, once all
//              regular ends and what searches have found are entered
// Counts of `result` grow with what is read.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "formula_ends.h"
#include "posture_list.h"
#include "prepared_arm.h"

namespace moivre {

/// Where a path ended, in the arm's own joints.
struct PlaceOfEnd {
  Eigen::VectorXd values;  ///< the real part
  Eigen::VectorXd imaginary;
};

/// A path that ended where closures meet, or where a set is.
struct SingularEnd : PlaceOfEnd {
  double imaginary_size = 0;  ///< of all joints, radians or lengths relative to the arm's
  double added = 0;           ///< of the joints that were added
  double to_go = 0;           ///< how far it is from what the path leads to
};

/// Of the paths of one beginning.
struct PathsSeen {
  std::map<std::size_t, std::uint64_t> paths_to;  ///< by closure
  std::vector<SingularEnd> singular;
  /// The arm as typed has a closure more here than the paths lead to: the conjugate of this one.
  std::vector<PlaceOfEnd> unpaired;
  /// Between two closures that are nearly real: the pose is held within its accuracy there.
  std::vector<Eigen::VectorXd> between_pairs;
};

/// Enters the closures of regular ends into the list. Singular ends, and places between two
/// closures that are nearly real, are kept for when all is entered.
/// False where a regular end is no posture.
bool read_ends(const ArmBeginning& beginning, const std::vector<ApproachEnd>& ends,
               PostureList& list, ArmResult& result, PathsSeen& seen);

/// Enters what the formula found, where nothing but its real closures may hold the pose; otherwise
/// nothing, and false.
bool read_found(const ArmBeginning& beginning, const FoundClosures& found, PostureList& list,
                ArmResult& result);

/// Whether the end is at a set or a closure that is listed, or at one that is found next to it, or
/// at a singular one that is not real or not the arm's own.
bool is_explained(const SingularEnd& end, PostureList& list, PathsSeen& seen, ArmResult& result);

/// Whether the end is on the continuation of a reported set into complex numbers: paths slide along
/// it, as slowly as rounding lets them be followed, and an arm as typed may have more closures
/// there than the geometry that its digits stand for. Of a plane the relations tell, but for one
/// that seems to hold the pose and ends; of other sets a way back to real postures (complex_set.h),
/// at whose end sets are looked for once more. All real closures on it are listed: those of a curve
/// by signs, those of a surface by Newton's method from places that are nowhere far.
bool is_on_continuation(const PlaceOfEnd& end, PostureList& list);

/// Whether a posture is of a reported set that a coarse pose leaves open: it is near to the set, or
/// the pose is held all the way from there, within its accuracy.
bool is_of_open_set(const PostureList& list, const Eigen::VectorXd& values);

/// Whether a place that holds the pose within its accuracy is of a set or a closure that is listed:
/// near to it, or the pose is held half way, too.
bool is_listed(const PostureList& list, const Eigen::VectorXd& place);

}  // namespace moivre
