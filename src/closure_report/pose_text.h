// SPDX-License-Identifier: MIT
// How is a pose told to people? A line a body (or unknown), angles in the file's unit.
#pragma once

#include <string>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

std::string pose_text(const Mechanism& mechanism, const Eigen::VectorXd& q);

/// "57.3249 deg", "12.5 mm".
std::string coordinate_text(const Mechanism& mechanism, const Coordinate& coordinate, double value);

}  // namespace moivre
