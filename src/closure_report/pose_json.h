// SPDX-License-Identifier: MIT
// How is a pose written down in JSON? Coordinates by name, bodies, points; and what a mechanism's mobility is.
#pragma once

#include "moivre/kinematics/mobility.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/report/json.h"

namespace moivre {

/// {"crank.phi": 0.52, ...}.
Json coordinates_json(const Mechanism& mechanism, const Eigen::VectorXd& q);
/// {"crank": {"x":.., "y":.., "phi":..}}, {} for typed equations.
Json bodies_json(const Mechanism& mechanism, const Eigen::VectorXd& q);
/// {"crank.B": [x, y]} of every point of a moving body, {} for typed equations.
Json points_json(const Mechanism& mechanism, const Eigen::VectorXd& q);

Json to_json(const Eigen::VectorXd& v);
/// Row by row.
Json rows_json(const Eigen::MatrixXd& m);
/// {"length": "mm"}; null where the file names no unit.
Json units_json(const Mechanism& mechanism);

}  // namespace moivre
