// SPDX-License-Identifier: MIT
// Which whole turns may a posture's joints have, and which posture is nearest to where an arm
// stands?
//
// A controller's joints turn farther than once: of 2 pi more or less the tip knows nothing. Joint
// values x (n), radians and metres.
// Distance: the largest difference of two joint values, slides relative to the arm's length.
// Edges: a joint without limits, and one that is beyond its limits whatever turns are added, keeps
// its value in all_turns().
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "moivre/arms/arm_closures.h"

namespace moivre {

inline constexpr std::size_t kMostChoicesOfTurns = 4096;

/// Every choice of whole turns with which the joints are between their limits, by the first joint's
/// value, then the second's.
/// Throws InvalidInput where there are more than kMostChoicesOfTurns.
std::vector<Eigen::VectorXd> all_turns(const Arm& arm, const Eigen::VectorXd& values);

/// Throws InvalidInput where some values of the joints have more choices than kMostChoicesOfTurns.
void require_few_turns(const Arm& arm);

/// With the whole turns, between the limits, that bring each joint nearest to where it stands.
Eigen::VectorXd nearest_turns(const Arm& arm, const Eigen::VectorXd& values,
                              const Eigen::VectorXd& stands);

/// Throws InvalidInput unless there is a finite value for each joint.
void require_standing(const Arm& arm, const Eigen::VectorXd& stands);

/// The closures in the order of is_nearer(), those of one distance as they were; `in_limits` with
/// the nearest turns.
void sort_by_distance(const Arm& arm, const Eigen::VectorXd& stands,
                      std::vector<ArmClosure>& closures);

/// Whole turns count.
double distance_from(const Arm& arm, const Eigen::VectorXd& values, const Eigen::VectorXd& stands);

/// Whether a's distance is less than b's, to nine decimals.
bool is_nearer(const Arm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b,
               const Eigen::VectorXd& stands);

}  // namespace moivre
