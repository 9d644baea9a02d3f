// SPDX-License-Identifier: MIT
// How is a pose written down in JSON? Coordinates by name, bodies, points; and what a mechanism's mobility is.
#pragma once

#include "moivre/closures/closures.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/report/json.h"

namespace moivre {

/// {"crank.phi": 0.52, ...}.
Json coordinates_json(const Mechanism& mechanism, const Eigen::VectorXd& q);
/// {"crank": {"x":.., "y":.., "phi":..}}, {} for typed equations.
Json bodies_json(const Mechanism& mechanism, const Eigen::VectorXd& q);
/// {"crank.B": [x, y]} of every point of a moving body, {} for typed equations.
Json points_json(const Mechanism& mechanism, const Eigen::VectorXd& q);

/// {"body": .., "joint": .., "held": ..}
Json idle_json(const std::vector<IdleJoint>& idle);

Json to_json(const Eigen::VectorXd& v);
/// Row by row.
Json rows_json(const Eigen::MatrixXd& m);
/// {"length": "mm", "angle": "rad"}: of what JSON has, whatever the file was written in; null where it names no length.
Json units_json(const Mechanism& mechanism);

}  // namespace moivre
