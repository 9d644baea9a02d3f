// SPDX-License-Identifier: MIT
// Which joints have a length of their own? Private to the module.
#pragma once

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// What Joint::length holds of the others says nothing of the mechanism's size.
inline bool reads_length(JointType type) {
  return type == JointType::rod || type == JointType::actuator;
}

}  // namespace moivre
