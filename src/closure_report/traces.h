// SPDX-License-Identifier: MIT
// Along which poses does a branch go, and which points are worth a curve?
#pragma once

#include <string>
#include <vector>

#include "figures.h"
#include "moivre/closures/motion.h"

namespace moivre {

/// A pose of a branch; an event has no velocity.
struct TracedPose {
  double time = 0;
  const Eigen::VectorXd* q = nullptr;
  const BranchSample* sample = nullptr;
};

/// The event where the branch begins, its samples, the event where it ends.
std::vector<TracedPose> traced_poses(const MotionBranch& branch, const MotionResult& result);

/// Poses of all branches, in their order.
std::vector<Eigen::VectorXd> all_poses(const MotionResult& result);

/// A point that moves: its name, "coupler.P", and where it is.
struct MovingPoint {
  std::string name;
  PointOf point;
};

/// One a site that moves, points without a joint first.
std::vector<MovingPoint> moving_points(const Mechanism& mechanism);

/// The points whose curves say most: those without a joint; else those of bodies that no joint holds to the ground; else all.
std::vector<MovingPoint> traced_points(const Mechanism& mechanism);

/// Where the branch takes the point, as it is seen.
std::vector<Complex> curve(const Mechanism& mechanism, const MovingPoint& point,
                           const MotionBranch& branch, const MotionResult& result);

}  // namespace moivre
