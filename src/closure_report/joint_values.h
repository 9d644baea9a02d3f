// SPDX-License-Identifier: MIT
// Where do the joints of a spatial mechanism stand in a pose? What one who commands motors wants to
// know.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

struct JointValue {
  std::string name;
  CoordinateKind kind = CoordinateKind::angle;
  double value = 0;  ///< rad in [-pi, pi], or the slide
};

/// Of joints with one coordinate (mechanism/pose.h), in the file's order; none of planar
/// mechanisms, whose bodies say it.
std::vector<JointValue> joint_values(const Mechanism& mechanism, const Eigen::VectorXd& q);

}  // namespace moivre
