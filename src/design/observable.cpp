// SPDX-License-Identifier: MIT
// Coordinates, points and joints by name.
#include "observable.h"

#include <algorithm>
#include <set>

#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/nearest.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

Observable coordinate(const Coordinate& of, Eigen::Index k) {
  const bool is_angle = of.kind == CoordinateKind::angle;
  return {of.name, of.kind != CoordinateKind::length, is_angle && of.is_periodic,
          [k](const VectorXd& q, const VectorXd& v, const VectorXd& a) {
            return ScalarState{q[k], v[k], a[k]};
          }};
}

Observable point(const Mechanism& mechanism, const PointOf& of, int axis) {
  const Body& body = mechanism.bodies[of.body];
  return {body.name + '.' + body.points[of.point].name + '.' + "xyz"[axis], false, false,
          [&mechanism, of, axis](const VectorXd& q, const VectorXd& v, const VectorXd& a) {
            const PointState at = point_state(mechanism, of, q, v, a);
            return ScalarState{at.position[axis], at.velocity[axis], at.acceleration[axis]};
          }};
}

Observable turn(const Mechanism& mechanism, const Joint& joint, const std::string& name) {
  return {name, true, true, [&](const VectorXd& q, const VectorXd& v, const VectorXd& a) {
            return turn_state(mechanism, joint, q, v, a);
          }};
}

Observable slide(const Mechanism& mechanism, const Joint& joint, const std::string& name) {
  return {name, false, false, [&](const VectorXd& q, const VectorXd& v, const VectorXd& a) {
            return joint_state(mechanism, joint, q, v, a).value();
          }};
}

int axes(const Mechanism& mechanism) { return mechanism.space == Space::planar ? 2 : 3; }

bool is_jointed(const Mechanism& mechanism, const PointOf& of) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
    return !is_transmission(joint.type) &&
           std::any_of(joint.at.begin(), joint.at.end(), [&](const PointOf& end) {
             return end.body == of.body && end.point == of.point;
           });
  });
}

void add_points(const Mechanism& mechanism, bool jointed_too, std::vector<Observable>& all) {
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    for (std::size_t p = 0; p < mechanism.bodies[b].points.size(); ++p) {
      if (!jointed_too && is_jointed(mechanism, {b, p})) continue;
      for (int axis = 0; axis < axes(mechanism); ++axis)
        all.push_back(point(mechanism, {b, p}, axis));
    }
  }
}

/// Bodies that an angle driver turns on the ground, joints that a slide or (spatial) an angle
/// driver moves, unknowns that are driven.
std::set<std::string> driven_names(const Mechanism& mechanism) {
  std::set<std::string> names;
  for (const Driver& driver : mechanism.drivers) {
    if (driver.kind == DriverKind::unknown) {
      names.insert(mechanism.unknowns[driver.unknown].name);
    } else if (driver.kind == DriverKind::slide ||
               (driver.kind == DriverKind::angle && mechanism.space == Space::spatial)) {
      names.insert(mechanism.joints[driver.joint].name);
    } else if (driver.kind == DriverKind::angle && driver.bodies[0] == 0) {
      names.insert(mechanism.bodies[driver.bodies[1]].name);
    } else if (driver.kind == DriverKind::angle && driver.bodies[1] == 0) {
      names.insert(mechanism.bodies[driver.bodies[0]].name);
    }
  }
  return names;
}

/// What holds the body to the ground so that it slides and cannot turn; nullptr where nothing does.
const Joint* slideway(const Mechanism& mechanism, std::size_t body) {
  for (const Joint& joint : mechanism.joints) {
    const bool joins = (joint.at[0].body == 0 && joint.at[1].body == body) ||
                       (joint.at[1].body == 0 && joint.at[0].body == body);
    if (joins && joint.type == JointType::prismatic) return &joint;
  }
  return nullptr;
}

/// All that can be an output.
std::vector<Observable> nameable(const Mechanism& mechanism) {
  std::vector<Observable> all;
  const std::vector<Coordinate> names = coordinates(mechanism);
  const bool is_planar = !is_typed(mechanism) && mechanism.space == Space::planar;
  for (std::size_t k = 0; k < names.size(); ++k) {
    Observable one = coordinate(names[k], static_cast<Eigen::Index>(k));
    if (is_planar && names[k].kind == CoordinateKind::angle) {
      const std::size_t body = names[k].group + 1;
      one.name = mechanism.bodies[body].name;
      if (const Joint* way = slideway(mechanism, body)) one = slide(mechanism, *way, one.name);
    } else if (!is_typed(mechanism)) {
      continue;
    }
    all.push_back(one);
  }
  if (is_typed(mechanism)) return all;
  for (const Joint& joint : mechanism.joints) {
    if (has_slide(joint.type)) {
      all.push_back(slide(mechanism, joint, joint.name));
    } else if (has_angle(joint.type)) {
      all.push_back(turn(mechanism, joint, joint.name));
    }
  }
  add_points(mechanism, true, all);
  return all;
}

}  // namespace

std::vector<Observable> coordinate_observables(const Mechanism& mechanism) {
  std::vector<Observable> all;
  const std::vector<Coordinate> names = coordinates(mechanism);
  for (std::size_t k = 0; k < names.size(); ++k) {
    all.push_back(coordinate(names[k], static_cast<Eigen::Index>(k)));
  }
  return all;
}

std::vector<Observable> point_observables(const Mechanism& mechanism) {
  std::vector<Observable> all;
  add_points(mechanism, true, all);
  return all;
}

std::vector<Observable> joint_observables(const Mechanism& mechanism) {
  std::vector<Observable> all;
  for (const Joint& joint : mechanism.joints) {
    const std::string name = "joint " + joint.name;
    if (has_slide(joint.type)) all.push_back(slide(mechanism, joint, name));
    if (has_angle(joint.type))
      all.push_back(turn(mechanism, joint, has_slide(joint.type) ? name + " turn" : name));
  }
  return all;
}

std::vector<Observable> driven_observables(const Mechanism& mechanism) {
  if (is_typed(mechanism)) return coordinate_observables(mechanism);
  std::vector<Observable> all;
  const bool is_planar = mechanism.space == Space::planar;
  for (Observable& one : coordinate_observables(mechanism)) {
    if (is_planar && one.is_angle) all.push_back(std::move(one));
  }
  for (const Joint& joint : mechanism.joints) {
    if (has_slide(joint.type)) {
      all.push_back(slide(mechanism, joint, joint.name));
    } else if (has_angle(joint.type) && !is_planar) {
      all.push_back(turn(mechanism, joint, joint.name));
    }
  }
  add_points(mechanism, false, all);
  return all;
}

Observable output_observable(const Mechanism& mechanism, const std::string& name) {
  std::vector<std::string> known;
  for (Observable& one : nameable(mechanism)) {
    if (one.name == name) return std::move(one);
    known.push_back(one.name);
  }
  throw InvalidInput("there is no output '" + name +
                     "': it is a body (its angle, or its slide where it cannot turn), a "
                     "joint, or a point's coordinate such as rocker.B.x" +
                     suggestion(name, known));
}

std::vector<std::string> default_outputs(const Mechanism& mechanism) {
  const std::set<std::string> driven = driven_names(mechanism);
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (driven.count(name) == 0 && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  };
  for (const Unknown& unknown : mechanism.unknowns) add(unknown.name);
  for (const Joint& joint : mechanism.joints) {
    const bool first = joint.at[0].body == 0;
    const bool second = joint.at[1].body == 0;
    if (first == second || is_transmission(joint.type)) continue;
    const std::string& body = mechanism.bodies[joint.at[first ? 1 : 0].body].name;
    if (has_slide(joint.type)) {
      add(joint.name);
    } else if (has_angle(joint.type)) {
      add(mechanism.space == Space::planar ? body : joint.name);
    }
  }
  return names;
}

}  // namespace moivre
