// SPDX-License-Identifier: MIT
// How is a robot written as a mechanism file? Links become bodies and joints stay joints, in a file
// that a person can read and edit.
//
// Frames: when all joints are at zero, every body's frame is parallel to the root's, with its
// origin at the link's. So each axis has the same components in both bodies, angles are those of
// the robot, and a fixed joint is a plain weld.
// The root link is the ground. A mimic joint and its leader each get a driver, since the mechanism
// file has no spatial gears to couple them. In names, characters other than letters, digits, _ and
// - become _.
// Numbers have twelve decimals. Quarter turns are exact where the angle means them within 1e-9
// (urdf/placement.h).
//
// A side file (mechanism/additions.h) adds points, joints that close loops, and drivers. Its points
// and axes are in the frames of the links. Its angles are 0 where two links stand to each other as
// with all joints at zero. Its drivers come first, those of held joints behind them. A pose of the
// tip in the root's frame is held by a weld to the ground.
// Not supported: links that the robot lacks.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "moivre/expression/source.h"
#include "moivre/urdf/choice.h"
#include "moivre/urdf/robot.h"

namespace moivre {

/// What becomes of a robot on its way to a mechanism.
struct RobotChanges {
  std::optional<Source> loops;            ///< the side file
  std::vector<HeldJoint> held;            ///< get drivers that stand
  std::optional<std::string> tip;         ///< default: the leaf, where there is one alone
  std::optional<Eigen::Isometry3d> pose;  ///< of the tip
};

/// `file` is named in the heading. Throws ParseError with the faults of the side file, and
/// std::invalid_argument where the robot has one link alone, or where links and joints of the
/// changes are not there.
std::string mechanism_text(const Robot& robot, const std::string& file,
                           const RobotChanges& changes = {});

}  // namespace moivre
