// SPDX-License-Identifier: MIT
// What do drivers say of a spatial joint at a time? Its angle, its slide, both or nothing; a
// screw's angle tells its slide.
#pragma once

#include <optional>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

struct DrivenJoint {
  std::optional<double> angle;  ///< rad, whole turns included
  std::optional<double> slide;
};

/// `joint` is the joint's number.
DrivenJoint driven_joint(const Mechanism& mechanism, std::size_t joint, double t);

}  // namespace moivre
