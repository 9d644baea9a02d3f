// SPDX-License-Identifier: MIT
// What moves that has a name? Numbers read off a pose in motion: coordinates, places of points,
// angles and slides of joints.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "moivre/mechanism/pose.h"

namespace moivre {

struct Observable {
  std::string name;
  bool is_angle = false;
  bool turns = false;  ///< a whole turn more is the same
  /// Of q, q', q''; along a driver: of q, k_a, k_aa.
  std::function<ScalarState(const Eigen::VectorXd&, const Eigen::VectorXd&, const Eigen::VectorXd&)>
      state;
};

std::vector<Observable> coordinate_observables(const Mechanism& mechanism);
std::vector<Observable> point_observables(const Mechanism& mechanism);
/// "joint A", "joint A turn" of a slot or a cylindrical joint.
std::vector<Observable> joint_observables(const Mechanism& mechanism);
/// What coefficients are of.
std::vector<Observable> driven_observables(const Mechanism& mechanism);
/// By name. Throws std::invalid_argument, with the names that are known.
Observable output_observable(const Mechanism& mechanism, const std::string& name);
/// Names of what a joint ties to the ground and no driver moves; of the unknowns that no driver
/// moves.
std::vector<std::string> default_outputs(const Mechanism& mechanism);

}  // namespace moivre
