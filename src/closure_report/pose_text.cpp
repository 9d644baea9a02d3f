// SPDX-License-Identifier: MIT
// Poses with eight digits, one body a line.
#include "pose_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "moivre/expression/counted.h"
#include "moivre/report/number_text.h"

namespace moivre {
namespace {

// Of radians, and of the largest length of a pose: a zero of rounding would fill the line with
// digits that say nothing.
constexpr double kRoundingNoise = 1e-14;

/// The largest length among the coordinates.
double largest_length(const std::vector<Coordinate>& names, const Eigen::VectorXd& q) {
  double size = 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const double value = std::abs(q[static_cast<Eigen::Index>(k)]);
    if (names[k].kind == CoordinateKind::length) size = std::max(size, value);
  }
  return size;
}

bool moves(const Driver& driver) {
  const auto* parabola = std::get_if<Parabola>(&driver.law);
  return parabola == nullptr || parabola->velocity != 0 || parabola->acceleration != 0;
}

std::string text_of(const std::vector<Driver>& drivers, const Mechanism& mechanism, double time) {
  std::string text;
  for (const Driver& driver : drivers) {
    const Coordinate shown{driver.name, kind_of(mechanism, driver), 0};
    text += (text.empty() ? "" : ", ") + label_of(driver) + " = " +
            coordinate_text(mechanism, shown, driver_state(driver.law, time).value);
  }
  return text;
}

}  // namespace

std::string coordinate_text(const Mechanism& mechanism, const Coordinate& coordinate,
                            double value) {
  const bool is_length = coordinate.kind == CoordinateKind::length;
  const bool in_degrees = !is_length && mechanism.units.angle == "deg";
  const double known = std::abs(value) < kRoundingNoise ? 0 : value;
  const double shown = in_degrees ? known * 180 / std::numbers::pi : known;
  constexpr int kDigits = 8;
  const std::string unit = is_length ? mechanism.units.length : mechanism.units.angle;
  return short_text(shown, kDigits) + (unit.empty() ? "" : " " + unit);
}

std::string drivers_text(const Mechanism& mechanism, double time) {
  return text_of(mechanism.drivers, mechanism, time);
}

std::string moving_drivers_text(const Mechanism& mechanism, double time) {
  std::vector<Driver> drivers = mechanism.drivers;
  std::erase_if(drivers, [](const Driver& driver) { return !moves(driver); });
  return text_of(drivers.empty() ? mechanism.drivers : drivers, mechanism, time);
}

std::string counts_text(const ClosureCounts& counts) {
  return counted(counts.complex, "complex closure") + ", " + std::to_string(counts.real) + " real";
}

std::string multiplicity_text(const Closure& closure) {
  if (closure.cluster) return "a cluster of " + counted(closure.multiplicity, "closure");
  return closure.multiplicity > 1 ? "multiplicity " + std::to_string(closure.multiplicity) : "";
}

std::string fitted_text(const ClosureCounts& counts) {
  return counts.fitted == 0 ? "" : ", " + std::to_string(counts.fitted) + " within fit";
}

std::string warnings_text(const Mechanism& mechanism) {
  std::string text;
  for (const std::string& warning : mechanism.warnings) text += "warning: " + warning + '\n';
  return text;
}

std::string idle_text(const std::vector<IdleJoint>& idle) {
  std::string text;
  for (const IdleJoint& joint : idle) {
    text += "idle: " + joint.body + " moves alone across '" + joint.joint +
            "', and nothing depends on it; " + joint.held + '\n';
  }
  return text;
}

std::string pose_text(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  return pose_text(mechanism, coordinates(mechanism), q);
}

std::string pose_text(const Mechanism& mechanism, const std::vector<Coordinate>& names,
                      const Eigen::VectorXd& q) {
  std::string text;
  const double noise = kRoundingNoise * largest_length(names, q);
  std::size_t width = 0;
  for (const Coordinate& c : names) width = std::max(width, c.name.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool begins = k == 0 || is_typed(mechanism) || names[k].group != names[k - 1].group;
    if (begins) text += k == 0 ? "  " : "\n  ";
    std::string name = names[k].name;
    if (!begins) {
      name = name.substr(mechanism.bodies[names[k].group + 1].name.size() + 1);
      text += ", ";
    } else {
      name.resize(width, ' ');
    }
    const double value = q[static_cast<Eigen::Index>(k)];
    const bool is_noise = names[k].kind == CoordinateKind::length && std::abs(value) < noise;
    text += name + " = " + coordinate_text(mechanism, names[k], is_noise ? 0 : value);
  }
  return text + '\n';
}

}  // namespace moivre
