// SPDX-License-Identifier: MIT
// How are drivers and the guess read?
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <numeric>

#include "moivre/mechanism/dimensions.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/nearest.h"
#include "read_formula.h"
#include "read_parts.h"

namespace moivre {
namespace {

const std::vector<std::string> kTargets{"angle", "slide", "x", "y", "z", "unknown"};
const std::vector<std::string> kLaws{"start", "velocity", "acceleration", "table", "value"};

/// What others call the keys of a driver.
const std::map<std::string, std::string> kTargetsCalled{
    {"body", "its angle is driven by angle = \"body\""},
    {"joint", "it is driven by angle = \"body\" or slide = \"joint\""},
    {"position", "its slide is driven by slide = \"joint\", a point by x = \"body.point\""},
    {"displacement", "it is driven by slide = \"joint\""},
    {"length", "it is driven by slide = \"joint\""}};
const std::map<std::string, std::string> kLawsCalled{{"speed", "velocity"},
                                                     {"omega", "velocity"},
                                                     {"w", "velocity"},
                                                     {"rate", "velocity"},
                                                     {"angular_velocity", "velocity"},
                                                     {"v", "velocity"},
                                                     {"alpha", "acceleration"},
                                                     {"a", "acceleration"},
                                                     {"angular_acceleration", "acceleration"},
                                                     {"phi", "start"},
                                                     {"phi0", "start"},
                                                     {"theta", "start"},
                                                     {"initial", "start"},
                                                     {"from", "start"},
                                                     {"at", "start"},
                                                     {"formula", "value"},
                                                     {"function", "value"}};

/// "60 rpm are velocity = 360": in the file's unit of angle.
std::string rpm_advice(const toml::table& entry, const std::string& angle_name) {
  const double turn = angle_name == "deg" ? 360 : 2 * std::numbers::pi;
  const auto rpm = entry.get("rpm") != nullptr ? entry.get("rpm")->value<double>() : std::nullopt;
  constexpr double kMinute = 60;
  const double turns = rpm.value_or(kMinute);
  char text[80];
  std::snprintf(text, sizeof text, "%.6g rpm are velocity = %.8g", turns, turns / kMinute * turn);
  return text + (", " + angle_name + " per second");
}

/// Advice on the words of others in this driver.
std::map<std::string, std::string> called_in(const toml::table& entry, const Mechanism& mechanism) {
  std::map<std::string, std::string> called = kTargetsCalled;
  for (const auto& [word, key] : kLawsCalled) called[word] = "here it is called '" + key + "'";
  called["rpm"] = rpm_advice(entry, mechanism.units.angle);
  return called;
}

/// Whether another's word stands where a law is expected.
bool has_law_by_another_name(const toml::table& entry) {
  return entry.contains("rpm") ||
         std::any_of(kLawsCalled.begin(), kLawsCalled.end(),
                     [&](const auto& word) { return entry.contains(word.first); });
}

std::optional<std::size_t> find_joint(Reading& reading, const Mechanism& mechanism,
                                      const std::string& name, const toml::node& at) {
  std::vector<std::string> known;
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    if (mechanism.joints[k].name == name) return k;
    known.push_back(mechanism.joints[k].name);
  }
  reading.fault(at, "there is no joint '" + name + "'" + suggestion(name, known));
  return std::nullopt;
}

void read_planar_angle(Reading& reading, const toml::node& node, const toml::table& entry,
                       const Mechanism& mechanism, Driver& driver) {
  if (node.is_string()) {
    driver.name = *node.value<std::string>();
    driver.bodies[1] =
        find_body(reading, mechanism, driver.name, reading.position(node)).value_or(1);
    if (driver.bodies[1] == 0) reading.fault(node, "the ground does not turn; drive another body");
    return;
  }
  const auto names =
      reading.texts(entry, "angle", 2, "[\"body\", \"other\"], or the name of one body");
  if (!names) return;
  driver.name = (*names)[0] + "-" + (*names)[1];
  bool is_found = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto body =
        find_body(reading, mechanism, (*names)[k], reading.position(*node.as_array()->get(k)));
    is_found = is_found && body;
    driver.bodies[k] = body.value_or(0);
  }
  if (is_found && driver.bodies[0] == driver.bodies[1]) {
    reading.fault(node, "a body has no angle relative to itself; name two bodies");
  }
}

/// Whether the joint has the freedom that is driven.
bool can_drive(DriverKind kind, const Joint& joint) {
  return kind == DriverKind::angle ? has_angle(joint.type) : has_slide(joint.type);
}

void read_joint_target(Reading& reading, const toml::node& node, const std::string& key,
                       const toml::table& entry, const Mechanism& mechanism, Driver& driver) {
  const auto name = reading.text(entry, key);
  if (!name) return;
  driver.name = *name;
  const auto joint = find_joint(reading, mechanism, *name, node);
  if (!joint) return;
  driver.joint = *joint;
  if (!can_drive(driver.kind, mechanism.joints[*joint])) {
    reading.fault(node, "joint '" + *name + "' is " + to_string(mechanism.joints[*joint].type) +
                            ", it has no " + (key == "angle" ? "angle" : "slide") + " to drive");
  }
}

void read_point_target(Reading& reading, const toml::node& node, const std::string& key,
                       const toml::table& entry, const Mechanism& mechanism, Driver& driver) {
  driver.kind = key == "x" ? DriverKind::x : key == "y" ? DriverKind::y : DriverKind::z;
  if (key == "z" && mechanism.space == Space::planar) {
    reading.fault(node, "a planar mechanism has no z to drive");
  }
  const auto name = reading.text(entry, key);
  if (!name) return;
  driver.name = *name;
  const auto point = find_point(reading, mechanism, *name, reading.position(node));
  if (!point) return;
  driver.point = *point;
  if (point->body == 0)
    reading.fault(node, "'" + *name + "' is fixed to the ground; drive a moving point");
}

void read_unknown_target(Reading& reading, const toml::node& node, const toml::table& entry,
                         const Mechanism& mechanism, Driver& driver) {
  driver.kind = DriverKind::unknown;
  const auto name = reading.text(entry, "unknown");
  if (!name) return;
  driver.name = *name;
  std::vector<std::string> known;
  for (std::size_t k = 0; k < mechanism.unknowns.size(); ++k) {
    if (mechanism.unknowns[k].name == *name) {
      driver.unknown = k;
      return;
    }
    known.push_back(mechanism.unknowns[k].name);
  }
  reading.fault(node, "there is no unknown '" + *name + "'" + suggestion(*name, known));
}

/// What is driven. A driver names one target.
void read_target(Reading& reading, const toml::table& entry, const Mechanism& mechanism,
                 Driver& driver) {
  std::vector<std::string> named;
  for (const std::string& key : kTargets) {
    if (entry.contains(key)) named.push_back(key);
  }
  if (named.size() != 1) {
    reading.fault(entry, named.empty()
                             ? "the driver drives nothing; name an angle, slide, x, y, z or unknown"
                             : "the driver drives both '" + named[0] + "' and '" + named[1] +
                                   "'; write two drivers");
    return;
  }
  const std::string& key = named[0];
  const toml::node& node = *entry.get(key);
  const bool is_unknown = key == "unknown";
  if (is_unknown != is_typed(mechanism)) {
    reading.fault(node, is_unknown
                            ? "'unknown' drives an unknown of typed equations; this file has bodies"
                            : "this file has typed equations; drive one by unknown = \"name\"");
  } else if (is_unknown) {
    read_unknown_target(reading, node, entry, mechanism, driver);
  } else if (key == "angle" && mechanism.space == Space::planar) {
    read_planar_angle(reading, node, entry, mechanism, driver);
  } else if (key == "angle" || key == "slide") {
    driver.kind = key == "angle" ? DriverKind::angle : DriverKind::slide;
    read_joint_target(reading, node, key, entry, mechanism, driver);
  } else {
    read_point_target(reading, node, key, entry, mechanism, driver);
  }
}

std::optional<DriverLaw> read_table(Reading& reading, const toml::array& rows, double unit) {
  std::vector<double> t, value;
  for (const toml::node& row : rows) {
    const auto pair = reading.numbers(row, "a row of 'table'", 2);
    if (!pair) return std::nullopt;
    if (!t.empty() && (*pair)[0] <= t.back()) {
      reading.fault(row, "the times of a table must increase");
      return std::nullopt;
    }
    t.push_back((*pair)[0]);
    value.push_back((*pair)[1] * unit);
  }
  if (t.size() < 2) {
    reading.fault(rows, "a table needs two or more rows: table = [[t, value], [t, value]]");
    return std::nullopt;
  }
  return natural_spline(std::move(t), std::move(value));
}

std::optional<DriverLaw> read_value(Reading& reading, const toml::table& entry, double unit) {
  const auto text = reading.text(entry, "value");
  if (!text) return std::nullopt;
  const toml::node& node = *entry.get("value");
  const std::size_t before = reading.faults().size();
  const Expression expression =
      parse_expression(*text, reading.text_begin(node, *text), reading.faults());
  const bool is_parsed = reading.faults().size() == before;
  if (!is_parsed) check_names(reading, node, *text, Names{});
  const auto formula = is_parsed ? read_formula(reading, expression, Names{}) : std::nullopt;
  reading.place_faults(node, *text, before);
  if (!formula) return std::nullopt;
  return TypedLaw{*formula, unit};
}

void read_law(Reading& reading, const toml::table& entry, double unit, Driver& driver) {
  const bool is_parabola =
      entry.contains("start") || entry.contains("velocity") || entry.contains("acceleration");
  const int laws =
      (is_parabola ? 1 : 0) + (entry.contains("table") ? 1 : 0) + (entry.contains("value") ? 1 : 0);
  if (laws == 0 && has_law_by_another_name(entry)) return;
  if (laws != 1) {
    reading.fault(entry,
                  laws == 0
                      ? "the driver needs 'start' (with velocity, acceleration), 'table' or 'value'"
                      : "the driver needs one of 'start' (with velocity, acceleration), 'table' "
                        "and 'value', not several");
    return;
  }
  if (is_parabola) {
    const auto part = [&](const char* key) {
      return reading.number(entry, key).value_or(0) * unit;
    };
    driver.law = Parabola{part("start"), part("velocity"), part("acceleration")};
  } else if (const toml::array* rows = reading.array(entry, "table")) {
    if (auto law = read_table(reading, *rows, unit)) driver.law = std::move(*law);
  } else if (auto law = read_value(reading, entry, unit)) {
    driver.law = std::move(*law);
  }
}

Driver read_driver(Reading& reading, const toml::table& entry, const Mechanism& mechanism) {
  Driver driver;
  driver.where = reading.position(entry);
  std::vector<std::string> known = kTargets;
  known.insert(known.end(), kLaws.begin(), kLaws.end());
  if (!is_typed(mechanism)) known.emplace_back("tolerance");
  reading.check_keys(entry, known, "a driver", called_in(entry, mechanism));
  const std::size_t faults_before = reading.faults().size();
  read_target(reading, entry, mechanism, driver);
  const bool has_target = reading.faults().size() == faults_before;
  const bool is_angle = has_target && kind_of(mechanism, driver) == CoordinateKind::angle;
  const double unit = is_angle ? angle_unit(mechanism) : 1;
  read_law(reading, entry, unit, driver);
  return driver;
}

/// [guess] entries as dotted names: "crank.phi" = 1 and crank.phi = 1 are one.
void collect_guess(Reading& reading, const toml::table& in, const std::string& prefix,
                   const std::vector<Coordinate>& names, Mechanism& mechanism) {
  for (const toml::key* key : reading.keys_in_order(in)) {
    const std::string name = prefix + std::string(key->str());
    const toml::node& node = *in.get(key->str());
    if (node.is_table()) {
      collect_guess(reading, *node.as_table(), name + ".", names, mechanism);
      continue;
    }
    const auto found = std::find_if(names.begin(), names.end(), [&](const Coordinate& coordinate) {
      return coordinate.name == name;
    });
    if (found == names.end()) {
      std::vector<std::string> known;
      for (const Coordinate& coordinate : names) known.push_back(coordinate.name);
      reading.fault(reading.position(key->source().begin),
                    "there is no coordinate '" + name + "'" + suggestion(name, known));
      continue;
    }
    const double unit = found->kind == CoordinateKind::length ? 1 : angle_unit(mechanism);
    if (const auto value = reading.number(node, "the guess of '" + name + "'")) {
      if (found->kind != CoordinateKind::length && !is_workable_angle(*value * unit)) {
        reading.fault(node, "the guess of '" + name + "' is more than a million turns");
      }
      mechanism.guess[name] = *value * unit;
    }
  }
}

/// Angle of the body in the drawn pose, whole turns counted: driven, or guessed; nothing where
/// neither says.
std::optional<double> drawn_angle(const Mechanism& mechanism, std::size_t body) {
  if (body == 0) return 0;
  for (const Driver& driver : mechanism.drivers) {
    const bool turns_it = driver.kind == DriverKind::angle && driver.bodies[0] == 0;
    if (turns_it && driver.bodies[1] == body) return driver_state(driver.law, 0).value;
  }
  const auto found = mechanism.guess.find(mechanism.bodies[body].name + ".phi");
  return found == mechanism.guess.end() ? std::nullopt : std::optional(found->second);
}

/// Of the ways in which its teeth mesh, a gear without a phase has the one nearest to the drawn
/// pose: a phase of whole teeth.
void take_drawn_meshing(Joint& joint, const Mechanism& mechanism) {
  if (traits(joint.type).turn != JointTurn::geared || joint.gear.phase_rad != 0) return;
  const auto i = drawn_angle(mechanism, joint.at[0].body);
  const auto j = drawn_angle(mechanism, joint.at[1].body);
  const auto c = drawn_angle(mechanism, joint.gear.carrier);
  if (!i || !j || !c) return;
  constexpr double kTurn = 2 * std::numbers::pi;
  const int common = std::gcd(joint.gear.teeth[0], joint.gear.teeth[1]);
  const double zi = joint.gear.teeth[0] / common;
  const double zj = joint.gear.teeth[1] / common;
  const double turns = std::round((zi * (*i - *c) - zj * (*j - *c)) / kTurn);
  if (std::isfinite(turns)) joint.gear.phase_rad = -kTurn * turns / zj;
}

/// Of the drivers' values, by the names that dimensions.h has for them.
void read_driver_tolerances(Reading& reading, const toml::array& entries, Mechanism& mechanism) {
  for (const Dimension& dimension : dimensions(mechanism)) {
    if (dimension.kind != DimensionKind::driver) continue;
    const toml::table* entry = entries.get(dimension.driver)->as_table();
    if (const auto tolerance = read_tolerance(reading, *entry)) {
      const double unit = dimension.is_angle ? angle_unit(mechanism) : 1;
      mechanism.tolerances[dimension.name] = *tolerance * unit;
    }
  }
}

void read_driver_entries(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  const toml::array* entries = reading.array(document, "driver");
  if (entries == nullptr) return;
  for (const toml::node& entry : *entries) {
    if (const toml::table* table = entry.as_table()) {
      mechanism.drivers.push_back(read_driver(reading, *table, mechanism));
    } else {
      reading.fault(entry, "a driver must be a table; write [[driver]]");
    }
  }
  const bool is_whole = mechanism.drivers.size() == entries->size();
  if (is_whole && !is_typed(mechanism)) read_driver_tolerances(reading, *entries, mechanism);
}

/// An actuator with a length is driven to stand there.
void hold_actuators(Reading& reading, Mechanism& mechanism) {
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    const Joint& joint = mechanism.joints[k];
    if (joint.type != JointType::actuator || joint.length == 0) continue;
    const auto drives_it = [&](const Driver& other) {
      return other.kind == DriverKind::slide && other.joint == k;
    };
    const auto twice = std::find_if(mechanism.drivers.begin(), mechanism.drivers.end(), drives_it);
    if (twice != mechanism.drivers.end()) {
      reading.fault(twice->where,
                    "'" + joint.name + "' has a 'length' to stand at; remove that, or the driver");
      continue;
    }
    Driver driver;
    driver.kind = DriverKind::slide;
    driver.name = joint.name;
    driver.joint = k;
    driver.law = Parabola{joint.length, 0, 0};
    driver.where = joint.where;
    mechanism.drivers.push_back(std::move(driver));
  }
}

}  // namespace

void read_drivers(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  read_driver_entries(reading, document, mechanism);
  hold_actuators(reading, mechanism);
}

void read_guess(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  if (const toml::table* guess = reading.table(document, "guess")) {
    collect_guess(reading, *guess, "", coordinates(mechanism), mechanism);
  }
  for (Joint& joint : mechanism.joints) take_drawn_meshing(joint, mechanism);
}

}  // namespace moivre
