// SPDX-License-Identifier: MIT
// How is a robot written as a mechanism file? Links become bodies and joints stay joints, in a file that a person can read and edit.
//
// Frames: when all joints are at zero, every body's frame is parallel to the root's, with its origin at the link's. So each axis has
// the same components in both bodies, angles are those of the robot, and a fixed joint is a plain weld.
// The root link is the ground. A mimic joint and its leader each get a driver, since the mechanism file has no spatial gears to couple
// them. In names, characters other than letters, digits, _ and - become _.
// Numbers have twelve decimals. Quarter turns are exact where the angle means them within 1e-9 (urdf/placement.h).
#pragma once

#include <string>

#include "moivre/urdf/robot.h"

namespace moivre {

/// `file` is named in the heading. Throws std::invalid_argument where the robot has one link alone.
std::string mechanism_text(const Robot& robot, const std::string& file);

}  // namespace moivre
