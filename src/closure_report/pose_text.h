// SPDX-License-Identifier: MIT
// How are poses, drivers and counts told to people? A line a body (or unknown), angles in the
// file's unit.
#pragma once

#include <string>
#include <vector>

#include "moivre/closures/closures.h"

namespace moivre {

std::string pose_text(const Mechanism& mechanism, const Eigen::VectorXd& q);
/// `names`: coordinates(mechanism), for many poses of it.
std::string pose_text(const Mechanism& mechanism, const std::vector<Coordinate>& names,
                      const Eigen::VectorXd& q);

/// "warning: ..." a line for each of the mechanism's warnings.
std::string warnings_text(const Mechanism& mechanism);

/// "idle: roller ..." a line for each.
std::string idle_text(const std::vector<IdleJoint>& idle);

/// "57.3249 deg", "12.5 mm".
std::string coordinate_text(const Mechanism& mechanism, const Coordinate& coordinate, double value);

/// "crank = 40 deg, guide = 12 mm": the drivers at this time; empty without drivers.
std::string drivers_text(const Mechanism& mechanism, double time);

/// Of the drivers that move alone; of all where none does.
std::string moving_drivers_text(const Mechanism& mechanism, double time);

/// "8 complex closures, 4 real".
std::string counts_text(const ClosureCounts& counts);

/// "multiplicity 2", or "a cluster of 2 closures" where nothing says that they are one; empty of a
/// single closure.
std::string multiplicity_text(const Closure& closure);

/// ", 1 within fit", to follow it; empty where none is.
std::string fitted_text(const ClosureCounts& counts);

}  // namespace moivre
