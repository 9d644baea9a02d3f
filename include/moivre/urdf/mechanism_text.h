// SPDX-License-Identifier: MIT
// How is a robot typed as a mechanism file? Links become bodies, joints joints, for a person to read and to go on from.
//
// Frames: where all joints stand at zero every body's frame is parallel to the root's, its origin where the link's is. So each axis
// has the same components in both bodies, angles are those of the robot, and a fixed joint is a plain weld.
// The root link is the ground. A mimic joint and its leader each get a driver: the mechanism file has no gear in space, so
// only driven ones can be kept together. Names with other characters than letters, digits, _ and - get _ instead.
// Numbers have twelve decimals. Quarter turns are exact where the angle means them within 1e-9 (urdf/placement.h).
#pragma once

#include <string>

#include "moivre/urdf/robot.h"

namespace moivre {

/// `file` is named in the heading. Throws std::invalid_argument where the robot has one link alone.
std::string mechanism_text(const Robot& robot, const std::string& file);

}  // namespace moivre
