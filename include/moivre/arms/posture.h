// SPDX-License-Identifier: MIT
// What is a posture of an arm called? Shoulder left or right, elbow up or down, wrist flipped or
// not, where the arm has these.
//
// Axes a_1 ... a_6 of turns, in the base's frame; the arm has these words where a_2 and a_3 are
// parallel, a_1 is not, and either
//   axes 4, 5, 6 meet in a point P (Puma, Kinova), the elbow's line then ends at P; or
//   a_4 is parallel to them, axes 5 and 6 meet in P (UR), and the line ends at axis 4.
// u: upwards, a_1 or its opposite, whichever is nearer to the base's z.
//   right     seen from axis 1 towards P, the plane of upper arm and forearm is on the right
//   up        the elbow, axis 3, is above the line from axis 2 to where the forearm ends
//   flipped   a_5 . (a_4 x a_6) < 0
// Any arm whose last three axes meet has the word for the wrist. A word is missing where rounding
// would decide it: elbow stretched or level with the line, wrist straight.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/arms/arm.h"

namespace moivre {

struct Posture {
  std::optional<bool> is_right;
  std::optional<bool> is_up;
  std::optional<bool> is_flipped;
};

Posture posture_of(const Arm& arm, const Eigen::VectorXd& values);

/// "shoulder right, elbow up, no flip"; empty where there is no word.
std::string to_string(const Posture& posture);

}  // namespace moivre
