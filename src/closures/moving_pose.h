// SPDX-License-Identifier: MIT
// Is there a pose from which the mechanism moves though its drivers stand? Newton-Raphson's poses,
// each with its local dimension.
//
// Newton-Raphson starts at the file's guess, then at random poses from `seed`. No pose found proves
// nothing.
#pragma once

#include <optional>

#include "moivre/closures/closures.h"

namespace moivre {

/// Least squares from a random pose assembles a linkage more often than not; what so many starts
/// miss is left undecided.
inline constexpr std::uint64_t kMovingStarts = 32;

/// How the pose moves with the drivers held; nullopt: not at all.
std::optional<Moves> moves_at(const Phi& phi, const Eigen::VectorXd& q, double t,
                              std::uint64_t seed);

/// Pose number `start` of many: angles anywhere, lengths within the mechanism's size, or the
/// guess's, of the guess; `share` of that at most.
Eigen::VectorXd random_pose(const Phi& phi, const Eigen::VectorXd& guess, std::uint64_t seed,
                            std::uint64_t start, double share = 1);

std::optional<Moves> moving_pose(const Mechanism& mechanism, const Phi& phi, double t,
                                 std::uint64_t seed);

}  // namespace moivre
