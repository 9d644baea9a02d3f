// SPDX-License-Identifier: MIT
// The drivers of one joint, and the thread of a screw.
#include "moivre/mechanism/driven_joint.h"

#include <numbers>

namespace moivre {

DrivenJoint driven_joint(const Mechanism& mechanism, std::size_t joint, double t) {
  DrivenJoint driven;
  for (const Driver& driver : mechanism.drivers) {
    if (driver.joint != joint) continue;
    if (driver.kind == DriverKind::angle) driven.angle = driver_state(driver.law, t).value;
    if (driver.kind == DriverKind::slide) driven.slide = driver_state(driver.law, t).value;
  }
  if (mechanism.joints[joint].type != JointType::screw) return driven;
  const double advance = mechanism.joints[joint].pitch / (2 * std::numbers::pi);
  if (driven.angle && !driven.slide) driven.slide = advance * *driven.angle;
  if (driven.slide && !driven.angle) driven.angle = *driven.slide / advance;
  return driven;
}

}  // namespace moivre
