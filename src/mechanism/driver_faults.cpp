// SPDX-License-Identifier: MIT
// Does each driver move something that is there, by a law that can be evaluated?
#include <algorithm>

#include "faults.h"
#include "moivre/mechanism/joint_type.h"

namespace moivre {
namespace {

std::string place(const char* what, std::size_t index, std::size_t count) {
  return std::string("drives ") + what + " " + std::to_string(index) + ", counted from 0, of " +
         std::to_string(count);
}

/// A clause; empty where the two bodies can turn against each other.
std::string fault_of_planar_angle(const Mechanism& mechanism, const Driver& driver) {
  for (const std::size_t body : driver.bodies) {
    if (body >= mechanism.bodies.size()) return place("body", body, mechanism.bodies.size());
  }
  return driver.bodies[0] == driver.bodies[1] ? "drives a body against itself" : "";
}

std::string fault_of_joint(const Mechanism& mechanism, const Driver& driver) {
  if (driver.joint >= mechanism.joints.size()) {
    return place("joint", driver.joint, mechanism.joints.size());
  }
  const Joint& joint = mechanism.joints[driver.joint];
  const bool is_angle = driver.kind == DriverKind::angle;
  if (is_angle ? has_angle(joint.type) : has_slide(joint.type)) return "";
  return "drives the " + std::string(is_angle ? "angle" : "slide") + " of joint '" + joint.name +
         "', a " + to_string(joint.type) + " joint that has none";
}

std::string fault_of_point(const Mechanism& mechanism, const Driver& driver) {
  const PointOf& point = driver.point;
  if (point.body >= mechanism.bodies.size()) {
    return place("a point of body", point.body, mechanism.bodies.size());
  }
  if (point.body == 0) return "drives a point of the ground";
  const std::size_t points = mechanism.bodies[point.body].points.size();
  if (point.point >= points) return place("point", point.point, points);
  const bool is_planar = mechanism.space == Space::planar;
  return driver.kind == DriverKind::z && is_planar ? "drives z in a planar mechanism" : "";
}

std::string fault_of_target(const Mechanism& mechanism, const Driver& driver) {
  const bool drives_unknown = driver.kind == DriverKind::unknown;
  if (drives_unknown != is_typed(mechanism)) {
    return drives_unknown ? "drives an unknown of a mechanism of bodies"
                          : "drives a body where there are typed unknowns only";
  }
  switch (driver.kind) {
    case DriverKind::angle:
      return mechanism.space == Space::planar ? fault_of_planar_angle(mechanism, driver)
                                              : fault_of_joint(mechanism, driver);
    case DriverKind::slide:
      return fault_of_joint(mechanism, driver);
    case DriverKind::x:
    case DriverKind::y:
    case DriverKind::z:
      return fault_of_point(mechanism, driver);
    case DriverKind::unknown:
      if (driver.unknown < mechanism.unknowns.size()) return "";
      return place("unknown", driver.unknown, mechanism.unknowns.size());
  }
  return "drives nothing";
}

/// What the driver's kind does not read keeps its default, or names something that is there:
/// whatever copies a driver renumbers it.
std::string fault_of_unread(const Mechanism& mechanism, const Driver& driver) {
  const std::size_t bodies = mechanism.bodies.size();
  const bool is_whole = driver.bodies[0] < bodies && driver.bodies[1] < bodies &&
                        driver.point.body < bodies &&
                        (driver.joint == 0 || driver.joint < mechanism.joints.size()) &&
                        (driver.unknown == 0 || driver.unknown < mechanism.unknowns.size());
  return is_whole ? "" : "has a number of something that is not there, though it does not drive it";
}

bool is_table(const Spline& table) {
  const std::size_t rows = table.t.size();
  if (rows < 2 || table.value.size() != rows || table.curvature.size() != rows) return false;
  const auto all_workable = [](const std::vector<double>& x) {
    return std::all_of(x.begin(), x.end(), is_workable);
  };
  const auto stands = [](double a, double b) { return !(a < b); };
  return all_workable(table.t) && all_workable(table.value) && all_workable(table.curvature) &&
         std::adjacent_find(table.t.begin(), table.t.end(), stands) == table.t.end();
}

/// A clause; empty where the law has a value at any time, finite or not.
std::string fault_of_law(const DriverLaw& law) {
  if (const auto* parabola = std::get_if<Parabola>(&law)) {
    const bool is_right = is_workable(parabola->start) && is_workable(parabola->velocity) &&
                          is_workable(parabola->acceleration);
    return is_right ? "" : "needs finite numbers of its parabola, up to 1e50";
  }
  if (const auto* table = std::get_if<Spline>(&law)) {
    return is_table(*table) ? ""
                            : "needs a table of two or more finite rows with increasing times "
                              "(natural_spline makes it)";
  }
  const TypedLaw& typed = std::get<TypedLaw>(law);
  if (!is_workable(typed.unit)) return "needs a finite unit";
  return fault_of(typed.formula, 0);
}

}  // namespace

void find_driver_faults(const Mechanism& mechanism, Faults& faults) {
  for (const Driver& driver : mechanism.drivers) {
    const std::string of_target = fault_of_target(mechanism, driver);
    const std::string of_unread = of_target.empty() ? fault_of_unread(mechanism, driver) : "";
    for (const std::string& fault : {of_target, of_unread, fault_of_law(driver.law)}) {
      if (fault.empty()) continue;
      faults.push_back({driver.where, "driver '" + driver.name + "' " + fault});
    }
  }
}

}  // namespace moivre
