// SPDX-License-Identifier: MIT
// Which closures does an arm of six joints have at a pose that is nothing special? All, complex
// ones too, by homotopy continuation.
//
// The loop of the pose is cut, its equations are solved
// (docs/decisions/0021-inverse-kinematics.md), and every root is put right by Newton's method on
// the product of transforms, as typed: the equations may be those of the special geometry that the
// file's digits stand for, and are a way to find.
// The pose is that of random joint values, which must be among its closures. Where double does not
// decide its paths another one is drawn, which costs less than digits; they are taken after that.
// An arm that misses a special geometry by 1e-3, as calibration finds them, has closures whose
// half-angle tangents are +-i within 1e-6. They are counted, and not followed: where they become
// real, next to singular postures, solve_at() has them.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "approach.h"
#include "cut.h"
#include "moivre/arms/arm_closures.h"

namespace moivre {

struct RegularRoot {
  JointVector<Complex> values;
  std::uint64_t path = 0;
};

struct RegularPose {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::vector<RegularRoot> roots;
  /// Further closures, with angles so far from real that double knows none of their digits.
  std::uint64_t far = 0;
  /// Every path decided, every root put right, all different, the pose's own values among them.
  bool complete = false;
  std::uint64_t rejected = 0;
  Cut cut;
  SolveResult solved;  ///< paths, times, failures; its solutions are taken out
};

RegularPose find_regular_pose(const Arm& arm, const Tracker& tracker, const SolveOptions& options,
                              const std::atomic<bool>& stop);

/// The same of any pose, by its own equations.
struct SolvedPose {
  std::vector<ApproachEnd> closures;  ///< put right on the arm: regular, all different
  std::uint64_t far = 0;
  std::uint64_t rejected = 0;  ///< roots that are no closures
  bool are_right = false;      ///< every closure that was found is in `closures` or `far`, once
  bool complete = false;       ///< every path was decided
  std::vector<Eigen::VectorXd> nearly_real;  ///< starts; what is singular at the pose is so in them
};
SolvedPose solve_at(const Arm& arm, const Eigen::Isometry3d& pose, const Tracker& tracker,
                    const SolveOptions& options, const std::atomic<bool>& stop);

}  // namespace moivre
