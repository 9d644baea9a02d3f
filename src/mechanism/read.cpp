// SPDX-License-Identifier: MIT
// How is a mechanism file read? TOML first, then section by section, every fault noted, thrown
// together.
#include "moivre/mechanism/read.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/nearest.h"
#include "read_parts.h"
#include "toml_advice.h"

namespace moivre {
namespace {

const std::vector<std::string> kLengthUnits{"m", "mm", "cm", "dm", "km", "um", "in", "ft", "yd"};
const std::vector<std::string> kAngleUnits{"rad", "deg"};

/// The unit that others write so; empty where it has no other name.
std::string unit_called(const std::string& word) {
  static const std::map<std::string, std::string> names{
      {"inch", "in"},       {"inches", "in"},      {"\"", "in"},          {"foot", "ft"},
      {"feet", "ft"},       {"yard", "yd"},        {"yards", "yd"},       {"meter", "m"},
      {"metre", "m"},       {"meters", "m"},       {"metres", "m"},       {"millimeter", "mm"},
      {"millimetre", "mm"}, {"millimeters", "mm"}, {"millimetres", "mm"}, {"MM", "mm"},
      {"centimeter", "cm"}, {"centimetre", "cm"},  {"centimeters", "cm"}, {"centimetres", "cm"},
      {"micron", "um"},     {"\u00b5m", "um"},     {"micrometer", "um"},  {"kilometer", "km"},
      {"degree", "deg"},    {"degrees", "deg"},    {"\u00b0", "deg"},     {"radian", "rad"},
      {"radians", "rad"}};
  const auto found = names.find(word);
  return found == names.end() ? "" : found->second;
}

/// One of the known words, or a fault.
std::string read_word(Reading& reading, const toml::table& in, const std::string& key,
                      const std::vector<std::string>& known, const std::string& otherwise) {
  const auto word = reading.text(in, key);
  if (!word) return otherwise;
  if (std::find(known.begin(), known.end(), *word) != known.end()) return *word;
  const std::string called = unit_called(*word);
  const bool is_unit = std::find(known.begin(), known.end(), called) != known.end();
  reading.fault(*in.get(key),
                "unknown " + key + " '" + *word + "'" +
                    (is_unit ? "; here it is called '" + called + "'" : suggestion(*word, known)));
  return otherwise;
}

/// Whether an entry is the place of a point: two or three numbers.
bool has_places(const toml::table& table) {
  return std::any_of(table.begin(), table.end(), [](const auto& entry) {
    const toml::array* place = entry.second.as_array();
    const bool is_short = place != nullptr && (place->size() == 2 || place->size() == 3);
    return is_short && std::all_of(place->begin(), place->end(),
                                   [](const toml::node& x) { return x.is_number(); });
  });
}

/// Advice on tables of points that are no [body.NAME.points], where no known key was meant;
/// [points] alone is nobody's.
std::map<std::string, std::string> bodies_called(const toml::table& document,
                                                 const std::vector<std::string>& known) {
  std::map<std::string, std::string> called;
  for (const auto& [key, value] : document) {
    const toml::table* table = value.as_table();
    const std::string name(key.str());
    if (name == "points") {
      called[name] = "points stand under [ground.points] or [body.NAME.points]";
      continue;
    }
    if (table == nullptr || nearest_word(name, known)) continue;
    const toml::table* points = table->get_as<toml::table>("points");
    if (has_places(*table) || (points != nullptr && has_places(*points))) {
      called[name] = "points of a body stand under [body." + name + ".points]";
    }
  }
  return called;
}

/// The section of the first point where every point of the file has three coordinates; nullptr
/// elsewhere.
const toml::node* drawn_in_space(const toml::table& document) {
  std::vector<const toml::table*> sections{document["ground"]["points"].as_table()};
  if (const toml::table* bodies = document["body"].as_table()) {
    for (const auto& [name, body] : *bodies) {
      if (body.is_table()) sections.push_back((*body.as_table())["points"].as_table());
    }
  }
  std::erase(sections, nullptr);
  const bool is_spatial = std::all_of(sections.begin(), sections.end(), [](const auto* points) {
    return std::all_of(points->begin(), points->end(), [](const auto& point) {
      const toml::array* at = point.second.as_array();
      return at != nullptr && at->size() == 3;
    });
  });
  return is_spatial && !sections.empty() && !sections.front()->empty() ? sections.front() : nullptr;
}

void read_header(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  const std::vector<std::string> known{"title",    "space",     "units",    "ground", "body",
                                       "joint",    "driver",    "guess",    "fit",    "tolerance",
                                       "unknowns", "constants", "equations"};
  reading.check_keys(document, known, "a mechanism file", bodies_called(document, known));
  mechanism.title = reading.text(document, "title").value_or("");
  mechanism.fit = reading.number(document, "fit");
  if (mechanism.fit && !(*mechanism.fit > 0)) {
    reading.fault(*document.get("fit"), "'fit' must be a length above 0");
  }
  mechanism.tolerance = read_tolerance(reading, document);
  const std::string space = read_word(reading, document, "space", {"planar", "spatial"}, "planar");
  mechanism.space = space == "spatial" ? Space::spatial : Space::planar;
  const toml::node* spatial = document.contains("space") ? nullptr : drawn_in_space(document);
  if (spatial != nullptr) {
    reading.fault(*spatial,
                  "every point has three coordinates; write space = \"spatial\" above "
                  "the first section");
    mechanism.space = Space::spatial;
  }
  if (const toml::table* units = reading.table(document, "units")) {
    reading.check_keys(*units, {"length", "angle"}, "[units]");
    mechanism.units.length = read_word(reading, *units, "length", kLengthUnits, "");
    mechanism.units.angle = read_word(reading, *units, "angle", kAngleUnits, "rad");
  }
}

bool has_any(const toml::table& document, const std::vector<std::string>& keys) {
  return std::any_of(keys.begin(), keys.end(),
                     [&](const std::string& key) { return document.contains(key); });
}

/// Reads the sections of the file's kind; a file of both kinds or of neither is a fault.
void read_sections(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  const bool has_bodies = has_any(document, {"ground", "body", "joint"});
  const bool has_equations = has_any(document, {"unknowns", "equations", "constants"});
  if (has_bodies && has_equations) {
    reading.fault(SourcePosition{},
                  "the file has bodies and equations; write either [body...] and [[joint]], or "
                  "[unknowns] and [equations]");
    return;
  }
  if (!has_bodies && !has_equations) {
    reading.fault(SourcePosition{},
                  "the file describes no mechanism; write [body.NAME.points] and [[joint]], or "
                  "[unknowns] and [equations]");
    return;
  }
  if (has_bodies) {
    read_bodies(reading, document, mechanism);
    read_joints(reading, document, mechanism);
  } else {
    read_equations(reading, document, mechanism);
    if (mechanism.tolerance) {
      reading.fault(*document.get("tolerance"),
                    "tolerances are of the dimensions of bodies; this file has typed equations");
    }
  }
  read_drivers(reading, document, mechanism);
  read_guess(reading, document, mechanism);
  if (reading.faults().empty()) check_structure(reading, mechanism);
}

[[noreturn]] void throw_toml_fault(const Reading& reading, const toml::parse_error& error) {
  throw ParseError(reading.source(),
                   {toml_fault(reading.source(), reading.position(error.source().begin),
                               std::string(error.description()))});
}

/// The TOML parser calls itself for each part of a dotted key: as deep as for brackets, and no
/// deeper.
void refuse_deep_keys(const Source& source) {
  constexpr std::ptrdiff_t kDeepest = 256;
  std::size_t begin = 0;
  for (std::size_t line = 1; begin < source.text.size(); ++line) {
    const std::size_t end = std::min(source.text.find('\n', begin), source.text.size());
    const std::size_t value = std::min(source.text.find('=', begin), end);
    const auto at = source.text.begin() + static_cast<std::ptrdiff_t>(begin);
    if (std::count(at, at + static_cast<std::ptrdiff_t>(value - begin), '.') > kDeepest) {
      throw ParseError(source, {{{begin, line, 1}, "a key has more than 256 parts"}});
    }
    begin = end + 1;
  }
}

/// A value that the file gives an angle, or its rate, in radians, and its name.
struct TypedAngle {
  std::string name;
  double value = 0;
  bool is_rate = false;

  /// Several turns, or a rate of quarter turns if it were in degrees.
  bool looks_like_degrees() const {
    constexpr double kQuarter = 90;
    if (is_rate) return value != 0 && std::fmod(value, kQuarter) == 0;
    return std::abs(value) > 2 * std::numbers::pi;
  }
};

/// Of drivers, joints and the guess.
std::vector<TypedAngle> typed_angles(const Mechanism& mechanism) {
  std::vector<TypedAngle> angles;
  for (const Driver& driver : mechanism.drivers) {
    if (kind_of(mechanism, driver) == CoordinateKind::length) continue;
    const DriverState begin = driver_state(driver.law, 0);
    angles.push_back({"driver " + driver.name, begin.value});
    angles.push_back({"the velocity of driver " + driver.name, begin.velocity, true});
  }
  for (const Joint& joint : mechanism.joints) {
    const std::string name = " of joint " + joint.name;
    angles.push_back({"'turn'" + name, joint.turn_rad});
    angles.push_back({"'phase'" + name, joint.gear.phase_rad});
    if (!joint.limits || !is_angular(joint.type)) continue;
    angles.push_back({"a limit" + name, joint.limits->lower});
    angles.push_back({"a limit" + name, joint.limits->upper});
  }
  const std::vector<Coordinate> all = coordinates(mechanism);
  for (const Coordinate& coordinate : all) {
    const auto guess = mechanism.guess.find(coordinate.name);
    if (guess == mechanism.guess.end() || coordinate.kind == CoordinateKind::length) continue;
    angles.push_back({"the guess of " + coordinate.name, guess->second});
  }
  return angles;
}

/// An angle of several turns is one in degrees more often, where the file names no unit.
void warn_of_radians(const toml::table& document, Mechanism& mechanism) {
  if (document.at_path("units.angle")) return;
  constexpr double kTurn = 2 * std::numbers::pi;
  for (const TypedAngle& angle : typed_angles(mechanism)) {
    if (!angle.looks_like_degrees()) continue;
    char text[80];
    std::snprintf(text, sizeof text, " = %.6g is %.3g turns%s", angle.value, angle.value / kTurn,
                  angle.is_rate ? " per second" : "");
    mechanism.warnings.push_back("angles are radians where [units] names none: " + angle.name +
                                 text + "; for degrees write angle = \"deg\" under [units]");
    return;
  }
}

}  // namespace

double angle_unit(const Mechanism& mechanism) {
  constexpr double kDegree = std::numbers::pi / 180;
  return mechanism.units.angle == "deg" ? kDegree : 1;
}

toml::table parse_toml(const Reading& reading) {
  refuse_deep_keys(reading.source());
  try {
    return toml::parse(reading.source().text, reading.source().name);
  } catch (const toml::parse_error& error) {
    throw_toml_fault(reading, error);
  }
}

void throw_faults(Reading& reading) {
  std::vector<Diagnostic>& faults = reading.faults();
  if (faults.empty()) return;
  std::stable_sort(faults.begin(), faults.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return a.at.offset < b.at.offset;
  });
  throw ParseError(reading.source(), faults);
}

Mechanism read_mechanism(const Source& source) {
  Reading reading(source);
  const toml::table document = parse_toml(reading);
  Mechanism mechanism;
  read_header(reading, document, mechanism);
  read_sections(reading, document, mechanism);
  throw_faults(reading);
  if (reading.has_rounded_numbers()) {
    mechanism.warnings.push_back(
        "a number has more digits than a double holds: it is rounded, and what is proved is proved "
        "of the rounded one");
  }
  warn_of_radians(document, mechanism);
  return mechanism;
}

}  // namespace moivre
