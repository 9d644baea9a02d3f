// SPDX-License-Identifier: MIT
// What is the same mechanism with its lengths typed in another unit? For tests that nothing depends
// on it.
#pragma once

#include <variant>

#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/mechanism.h"

namespace moivre::test {

/// The same mechanism with lengths typed in another unit.
Mechanism in_unit(Mechanism mechanism, double unit) {
  for (Body& body : mechanism.bodies) {
    for (BodyPoint& point : body.points) point.at *= unit;
  }
  for (Joint& joint : mechanism.joints) {
    joint.length *= unit;
    joint.radius *= unit;
    if (joint.limits && !is_angular(joint.type)) {
      joint.limits = Limits{joint.limits->lower * unit, joint.limits->upper * unit};
    }
  }
  for (Driver& driver : mechanism.drivers) {
    auto* law = std::get_if<Parabola>(&driver.law);
    if (driver.kind != DriverKind::angle && law != nullptr) {
      law->start *= unit;
      law->velocity *= unit;
      law->acceleration *= unit;
    }
  }
  return mechanism;
}

}  // namespace moivre::test
