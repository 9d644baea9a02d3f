// SPDX-License-Identifier: MIT
// Which coordinates has a mechanism, and what are its parts called?
#include "moivre/mechanism/mechanism.h"

namespace moivre {

std::string to_string(JointType type) {
  switch (type) {
    case JointType::revolute:
      return "revolute";
    case JointType::prismatic:
      return "prismatic";
    case JointType::slot:
      return "slot";
    case JointType::weld:
      return "weld";
    case JointType::rod:
      return "rod";
    case JointType::gear:
      return "gear";
    case JointType::spherical:
      return "spherical";
    case JointType::cylindrical:
      return "cylindrical";
    case JointType::universal:
      return "universal";
  }
  return "";
}

std::string to_string(DriverKind kind) {
  switch (kind) {
    case DriverKind::angle:
      return "angle";
    case DriverKind::slide:
      return "slide";
    case DriverKind::x:
      return "x";
    case DriverKind::y:
      return "y";
    case DriverKind::z:
      return "z";
    case DriverKind::unknown:
      return "unknown";
  }
  return "";
}

bool is_typed(const Mechanism& mechanism) { return !mechanism.unknowns.empty(); }

std::vector<Coordinate> coordinates(const Mechanism& mechanism) {
  std::vector<Coordinate> q;
  if (is_typed(mechanism)) {
    for (const Unknown& unknown : mechanism.unknowns) {
      const auto kind = unknown.is_angle ? CoordinateKind::angle : CoordinateKind::length;
      q.push_back({unknown.name, kind, q.size()});
    }
    return q;
  }
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    const auto add = [&](const char* name, CoordinateKind kind) {
      q.push_back({mechanism.bodies[body].name + "." + name, kind, body - 1});
    };
    add("x", CoordinateKind::length);
    add("y", CoordinateKind::length);
    if (mechanism.space == Space::planar) {
      add("phi", CoordinateKind::angle);
    } else {
      add("z", CoordinateKind::length);
      for (const char* name : {"rx", "ry", "rz"}) add(name, CoordinateKind::rotation_vector);
    }
  }
  return q;
}

}  // namespace moivre
