// SPDX-License-Identifier: MIT
// Along which poses does a branch go, and which points are worth a curve?
#pragma once

#include <string>
#include <vector>

#include "figures.h"
#include "moivre/motion/motion.h"

namespace moivre {

/// A pose of a branch; an event has no velocity.
struct TracedPose {
  double time = 0;
  Eigen::VectorXd q;  ///< of an event: angles brought near those of the sample beside it
  const BranchSample* sample = nullptr;
};

/// The event where the branch begins, its samples, the event where it ends; angles go on from where
/// shown_angles.h lets them begin.
std::vector<TracedPose> traced_poses(const Mechanism& mechanism, const MotionBranch& branch,
                                     const MotionResult& result);

/// Poses of all branches, in their order.
std::vector<Eigen::VectorXd> all_poses(const Mechanism& mechanism, const MotionResult& result);

/// A point that moves: its name, "coupler.P", and where it is.
struct MovingPoint {
  std::string name;
  PointOf point;
  bool is_jointed = false;
};

/// One a site that moves, points without a joint first.
std::vector<MovingPoint> moving_points(const Mechanism& mechanism);

/// The points whose curves say most: those without a joint; else those of bodies that no joint
/// holds to the ground; else all.
std::vector<MovingPoint> traced_points(const Mechanism& mechanism);

/// Where the branch takes the point, as it is seen.
std::vector<Complex> curve(const Mechanism& mechanism, const MovingPoint& point,
                           const MotionBranch& branch, const MotionResult& result);

}  // namespace moivre
