// SPDX-License-Identifier: MIT
// How do many poses of one arm share their work? What is alike in all is solved once, for random
// coefficients, and followed to each pose.
//
// Behind a cut that leaves the pose outside, only the pose moves the equations' coefficients. They
// are the member c of a family whose parameters are all coefficients (family/coefficients.h):
// multilinear, and as many paths as a pose solved from nothing takes, but no start system, no exact
// arithmetic and no endgame for each. Coefficients are those of unit displacements, in double; the
// last digits are those of Newton's method on the product of transforms, as always.
// Roots are read back, and put right on the arm itself: ends like those of approach.h, where they
// are as many closures as a regular pose has, all regular, all different, and their conjugates
// among them. Any other pose is approached by the tip's way.
// Not supported: neighbours whose axes all meet or are parallel, nearly.
#pragma once

#include <span>
#include <vector>

#include "approach.h"
#include "moivre/arms/arm_closures.h"
#include "moivre/family/members.h"
#include "pose_loop.h"

namespace moivre {

struct PoseFamily {
  PoseLoop loop;
  std::vector<RealDisplacement> forms;  ///< the cut's, or random combinations of them, of norm 1
  std::vector<std::vector<std::size_t>> terms;  ///< of each equation: monomials, bit k for t_k+1
  Family family;
};

/// Of an arm of six joints. nullopt where the arm is not supported, or its family could not be
/// learned completely.
std::optional<PoseFamily> learn_pose_family(const Arm& arm, const Tracker& tracker,
                                            const SolveOptions& options,
                                            const std::atomic<bool>& stop);

/// The closures of every pose, followed together by `threads`; empty where the family does not
/// answer.
std::vector<std::vector<ApproachEnd>> follow_poses(const PoseFamily& poses, const Arm& arm,
                                                   std::span<const TypedPose> wanted,
                                                   std::size_t closures, const Tracker& tracker,
                                                   const SolveOptions& options,
                                                   const std::atomic<bool>& stop);

}  // namespace moivre
