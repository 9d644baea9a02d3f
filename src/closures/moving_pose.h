// SPDX-License-Identifier: MIT
// Is there a pose from which the mechanism moves though its drivers stand? Newton-Raphson's poses, each with its local dimension.
//
// Newton-Raphson starts at the file's guess, then at random poses from `seed`. No pose found proves nothing.
#pragma once

#include <optional>

#include "moivre/kinematics/local_dimension.h"
#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// Least squares from a random pose assembles a linkage more often than not; what so many starts miss is left undecided.
inline constexpr std::uint64_t kMovingStarts = 32;

struct MovingPose {
  Eigen::VectorXd q;
  LocalDimension moves;  ///< dimension > 0
};

std::optional<MovingPose> moving_pose(const Mechanism& mechanism, const Phi& phi, double t,
                                      std::uint64_t seed);

}  // namespace moivre
