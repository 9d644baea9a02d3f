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
// An arm that misses a special geometry by 1e-3 has closures whose half-angle tangents are +-i
// within 1e-6. They are counted, and not followed: they become real only next to singular postures,
// where starts_at() at the pose itself has them.
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
  std::uint64_t far =
      0;  ///< further closures, with angles so far from real that double knows none of their digits
  bool complete =
      false;  ///< every path decided, every root put right, all different, the pose's own values among them
  std::uint64_t rejected = 0;
  Cut cut;
  SolveResult solved;  ///< paths, times, failures; its solutions are taken out
};

RegularPose find_regular_pose(const Arm& arm, const Tracker& tracker, const SolveOptions& options,
                              const std::atomic<bool>& stop);

/// Joint values near the real closures of any pose, from its own equations; what is singular there
/// is so in them.
struct StartsAtPose {
  std::vector<Eigen::VectorXd> values;
  bool complete = false;
};
StartsAtPose starts_at(const Arm& arm, const Eigen::Isometry3d& pose, const Tracker& tracker,
                       const SolveOptions& options, const std::atomic<bool>& stop);

}  // namespace moivre
