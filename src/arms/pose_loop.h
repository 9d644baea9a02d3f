// SPDX-License-Identifier: MIT
// What do the loops of all poses of an arm have in common? All but the first joint's constant
// displacement, where tool and pose are taken into it; and where they are cut, if the pose is
// outside.
#pragma once

#include "cut.h"

namespace moivre {

struct PoseLoop {
  Loop open;  ///< its first joint without tool and pose
  Cut cut;
  RealDisplacement tool = RealDisplacement::identity();
};

/// Of an arm of six joints.
PoseLoop pose_loop(const Arm& arm, std::uint64_t seed);

/// The loop that the pose closes, rounded.
Loop loop_at(const PoseLoop& poses, const Eigen::Isometry3d& pose);

}  // namespace moivre
