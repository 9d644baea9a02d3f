// SPDX-License-Identifier: MIT
// What of an arm can be drawn? A mechanism of points and axes: a body a link, a joint where its
// symbol is to stand.
//
// Joint k's symbol stands at its origin. Where neighbours' origins are in one place all but the
// last are slid along their own axes, and so is the middle joint of a wrist: that changes no
// motion, and the links between them are then seen, as is a wrist that has flipped.
// Points are named 1, 2, ... by joint; the tip has its link's name.
#pragma once

#include "moivre/arms/arm.h"
#include "moivre/closure_report/drawing.h"

namespace moivre {

struct Skeleton {
  Mechanism mechanism;
  std::vector<ShownFrame> frames;  ///< the base's and the tip's
};

Skeleton make_skeleton(const Arm& arm);

/// q of the skeleton's bodies.
Eigen::VectorXd skeleton_pose(const Skeleton& skeleton, const Arm& arm,
                              const Eigen::VectorXd& values);

/// From where the poses differ most, as an eye on the usual height sees them.
Eye best_eye(const Skeleton& skeleton, const std::vector<Eigen::VectorXd>& poses);

}  // namespace moivre
