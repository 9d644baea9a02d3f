// SPDX-License-Identifier: MIT
// What are the groups of quantities called, and what is in each?
#include "moivre/design/readings.h"

namespace moivre {

std::string to_string(QuantityGroup group) {
  switch (group) {
    case QuantityGroup::coordinates:
      return "coordinates";
    case QuantityGroup::points:
      return "points";
    case QuantityGroup::joints:
      return "joints";
    case QuantityGroup::coefficients:
      return "coefficients";
    case QuantityGroup::transmission:
      return "transmission";
    case QuantityGroup::advantage:
      return "advantage";
    case QuantityGroup::singularity:
      return "singularity";
  }
  return "";
}

std::string description(QuantityGroup group) {
  switch (group) {
    case QuantityGroup::coordinates:
      return "coordinates of all bodies, with velocity and acceleration";
    case QuantityGroup::points:
      return "places of all named points, with velocity and acceleration";
    case QuantityGroup::joints:
      return "relative angle or slide of each joint, with velocity and acceleration";
    case QuantityGroup::coefficients:
      return "kinematic coefficients: first and second derivative by each driver, whatever its "
             "speed";
    case QuantityGroup::transmission:
      return "transmission angle of each joint between two moving bodies, 0 to 90 degrees";
    case QuantityGroup::advantage:
      return "mechanical advantage: output torque or force over the driver's, without friction";
    case QuantityGroup::singularity:
      return "smallest singular value of the scaled Jacobian, 0 at a dead point";
  }
  return "";
}

std::vector<QuantityGroup> quantity_groups() {
  return {QuantityGroup::joints,    QuantityGroup::coefficients, QuantityGroup::transmission,
          QuantityGroup::advantage, QuantityGroup::singularity,  QuantityGroup::coordinates,
          QuantityGroup::points};
}

}  // namespace moivre
