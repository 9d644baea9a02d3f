// SPDX-License-Identifier: MIT
// Each joint's coordinate as mechanism/pose.h reads it off the bodies.
#include "joint_values.h"

#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"

namespace moivre {

std::vector<JointValue> joint_values(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  std::vector<JointValue> values;
  if (is_typed(mechanism) || mechanism.space == Space::planar) return values;
  for (const Joint& joint : mechanism.joints) {
    const auto value = joint_coordinate(mechanism, joint, q);
    if (!value) continue;
    const auto kind = is_angular(joint.type) ? CoordinateKind::angle : CoordinateKind::length;
    values.push_back({joint.name, kind, *value});
  }
  return values;
}

}  // namespace moivre
