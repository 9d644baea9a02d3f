// SPDX-License-Identifier: MIT
// How do many poses of one arm share their work? What is alike in all is solved once, for random coefficients, and followed to each pose.
//
// Behind a cut that leaves the pose outside, only the pose moves the equations' coefficients. They are the member c of a family whose
// parameters are all coefficients (family/coefficients.h): multilinear, and as many paths as a pose solved from nothing takes, but
// no start system, no exact arithmetic and no endgame for each. Coefficients are those of unit displacements, in double; the
// last digits are those of Newton's method on the product of transforms, as always.
// A pose is answered only where all its paths end at regular roots, all different, and these mean as many closures as the arm has
// at random joint values. Any other is the ordinary way's to solve.
// Not supported: arms of fewer than six joints, neighbours whose axes all meet or are parallel, nearly.
#pragma once

#include "cut.h"
#include "moivre/arms/arm_closures.h"
#include "moivre/family/members.h"

namespace moivre {

struct PoseFamily {
  Loop loop;  ///< its first joint without tool and pose
  Cut cut;
  std::vector<RealDisplacement> forms;  ///< the cut's, or random combinations of them, of norm 1
  RealDisplacement tool = RealDisplacement::identity();
  std::vector<std::vector<std::size_t>> terms;  ///< of each equation: monomials, bit k for t_k+1
  Family family;
  std::uint64_t closures = 0;  ///< complex ones, of a pose that is nothing special
};

/// nullopt where the arm is not supported, or its family could not be learned completely. `closures` is left to the caller.
std::optional<PoseFamily> learn_pose_family(const Arm& arm, const Tracker& tracker,
                                            const SolveOptions& options,
                                            const std::atomic<bool>& stop);

/// The loop that the pose closes, rounded.
Loop loop_at(const PoseFamily& poses, const Eigen::Isometry3d& pose);

/// The member that the loop is.
Point member_of(const PoseFamily& poses, const Loop& loop);

}  // namespace moivre
