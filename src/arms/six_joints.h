// SPDX-License-Identifier: MIT
// Which arm of six joints stands for one that has fewer, or whose joints can always move while the
// tip stands?
//
// Its equations are as many as its unknowns, and its closures at almost every pose are simple.
//   fewer than six     joints are added behind the last one, about random axes through one point of
//                      its axis: a wrist, which is cut out of the loop. Closures of the arm are
//                      those where the added joints stand at 0; what they stand at otherwise is by
//                      how much the pose is missed. Where the arm turns the tip as the wrist does,
//                      and leaves other motions out, the axes are anywhere
//   always moving      (the screws have a smaller rank at every posture) joints that are not needed
//                      are held
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/arms/arm.h"

namespace moivre {

struct SixJoints {
  Arm arm;                        ///< six joints
  std::vector<std::size_t> own;   ///< the joints of the original arm that come first in it
  std::vector<std::size_t> held;  ///< those that are held
  Eigen::VectorXd held_values;    ///< of the original arm; 0 of joints that are not held
};

/// Joints that can be held so that the rest, as many as the screws' rank, are all needed. Ranks are
/// of random postures; what is smaller than `tolerance` relative to the arm's motions is 0.
std::vector<std::size_t> idle_in_every_posture(const Arm& arm, std::uint64_t seed,
                                               double tolerance);

SixJoints six_joints(const Arm& arm, const std::vector<std::size_t>& held,
                     const Eigen::VectorXd& held_values, std::uint64_t seed);

/// Values of the original arm.
Eigen::VectorXd own_values(const SixJoints& six, const Eigen::VectorXd& values);

}  // namespace moivre
