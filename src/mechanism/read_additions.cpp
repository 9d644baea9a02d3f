// SPDX-License-Identifier: MIT
// A side file is read as a part of the mechanism that it is added to, and written in that one's
// frames.
#include <algorithm>
#include <charconv>
#include <sstream>

#include "moivre/expression/joined.h"
#include "moivre/mechanism/additions.h"
#include "read_parts.h"

namespace moivre {
namespace {

void check_header(Reading& reading, const toml::table& document) {
  reading.check_keys(document,
                     {"title", "space", "units", "ground", "body", "joint", "driver", "guess"},
                     "a side file");
  const auto space = reading.text(document, "space");
  if (space && *space != "spatial") {
    reading.fault(*document.get("space"), "the mechanism is spatial; remove 'space'");
  }
  const toml::table* units = reading.table(document, "units");
  const auto is_other = [&](const char* key, const char* unit) {
    const auto word = units == nullptr ? std::nullopt : reading.text(*units, key);
    return word && *word != unit;
  };
  const bool has_others = is_other("length", "m") || is_other("angle", "rad");
  if (has_others) {
    reading.fault(*document.get("units"),
                  "a side file has the robot's units, metres and radians; remove [units]");
  }
  const auto has = [&](const char* key) { return document.contains(key); };
  if (!has("joint") && !has("driver")) {
    reading.fault(SourcePosition{},
                  "the file adds nothing; write one [[joint]] for each loop that it closes");
  }
}

/// Puts the typed points of one body behind those that it has.
void add_points(Reading& reading, const Body& typed, const Eigen::Matrix3d& frame, Body& body) {
  for (BodyPoint point : typed.points) {
    const bool is_taken =
        std::any_of(body.points.begin(), body.points.end(),
                    [&](const BodyPoint& other) { return other.name == point.name; });
    if (is_taken) {
      reading.fault(point.where, "body '" + body.name + "' has a point '" + point.name +
                                     "' already, as at each of its joints; take another name");
    }
    point.at = frame * point.at;
    body.points.push_back(std::move(point));
  }
}

/// Tolerances would have to be written beside points that the mechanism has already.
void refuse_tolerances(Reading& reading, const toml::table& document) {
  const auto refuse = [&](const toml::table& body) {
    for (const char* key : {"tolerance", "tolerances"}) {
      const toml::node* node = body.get(key);
      if (node == nullptr) continue;
      reading.fault(*node,
                    "a side file has no tolerances of points; write them into the "
                    "mechanism file that moivre mechanism makes");
    }
  };
  const toml::table* ground = document["ground"].as_table();
  if (ground != nullptr) refuse(*ground);
  if (const toml::table* bodies = document["body"].as_table()) {
    for (const auto& [name, body] : *bodies) {
      if (const toml::table* table = body.as_table()) refuse(*table);
    }
  }
}

void read_more_points(Reading& reading, toml::table& document,
                      const std::vector<Eigen::Matrix3d>& frames, Mechanism& mechanism) {
  if (!document.contains("body")) document.insert("body", toml::table{});
  Mechanism typed;
  typed.space = Space::spatial;
  read_bodies(reading, document, typed);
  refuse_tolerances(reading, document);
  add_points(reading, typed.bodies[0], frames[0], mechanism.bodies[0]);
  for (std::size_t k = 1; k < typed.bodies.size(); ++k) {
    const Body& body = typed.bodies[k];
    if (const auto found = find_body(reading, mechanism, body.name, body.where)) {
      add_points(reading, body, frames[*found], mechanism.bodies[*found]);
    }
  }
}

/// With as many digits as it takes to read it back.
std::string number_text(double x) {
  char text[32];
  const std::to_chars_result result = std::to_chars(text, text + sizeof text, x);
  return std::string(static_cast<const char*>(text), static_cast<const char*>(result.ptr));
}

/// Numbers, strings, and arrays of them.
std::string value_text(const toml::node& node) {
  if (const toml::array* array = node.as_array()) {
    std::vector<std::string> entries;
    for (const toml::node& entry : *array) entries.push_back(value_text(entry));
    return "[" + joined(entries, ", ") + "]";
  }
  if (const auto number = node.value<double>()) return number_text(*number);
  std::ostringstream text;
  text << toml::toml_formatter(node, toml::format_flags::none);
  return text.str();
}

std::string vector_text(const Eigen::Vector3d& v) {
  return "[" + number_text(v.x()) + ", " + number_text(v.y()) + ", " + number_text(v.z()) + "]";
}

/// Turns the axes from the side frames into the bodies'; the text of `axis`.
std::string turn_axes(const toml::table& entry, const std::vector<Eigen::Matrix3d>& frames,
                      Joint& joint) {
  const toml::array* typed = entry["axis"].as_array();
  const bool is_pair = typed != nullptr && typed->size() == 2;
  const Eigen::Matrix3d& first = frames[joint.at[0].body];
  const Eigen::Matrix3d& second = is_pair ? frames[joint.at[1].body] : first;
  const bool stands = first == Eigen::Matrix3d::Identity() && second == Eigen::Matrix3d::Identity();
  joint.axis = {first * joint.axis[0], second * joint.axis[1]};
  if (stands && typed != nullptr) return value_text(*typed);
  if (!is_pair) return vector_text(joint.axis[0]);
  return "[" + vector_text(joint.axis[0]) + ", " + vector_text(joint.axis[1]) + "]";
}

/// The entry as text, key by key; `axis` in its place where there is one.
std::string entry_text(Reading& reading, const toml::table& entry, const std::string& kind,
                       const std::string& axis) {
  std::string text = "\n[[" + kind + "]]\n";
  for (const toml::key* key : reading.keys_in_order(entry)) {
    const std::string name(key->str());
    if (name != "axis") text += name + " = " + value_text(*entry.get(name)) + '\n';
  }
  return text + (axis.empty() ? "" : "axis = " + axis + '\n');
}

void read_more_joints(Reading& reading, toml::table& document,
                      const std::vector<Eigen::Matrix3d>& frames, Mechanism& mechanism,
                      Additions& additions) {
  if (!document.contains("joint")) document.insert("joint", toml::array{});
  const std::size_t before = mechanism.joints.size();
  read_joints(reading, document, mechanism);
  if (!reading.faults().empty()) return;
  const toml::array& entries = *document["joint"].as_array();
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const toml::table& entry = *entries[k].as_table();
    // A weld without an axis may turn about the first body's x.
    const bool has_axis = entry.contains("axis") || entry.contains("turn");
    const std::string axis =
        has_axis ? turn_axes(entry, frames, mechanism.joints[before + k]) : std::string();
    additions.joints += entry_text(reading, entry, "joint", axis);
  }
}

void read_more_drivers(Reading& reading, const toml::table& document, Mechanism& mechanism,
                       Additions& additions) {
  mechanism.drivers.clear();
  read_drivers(reading, document, mechanism);
  if (!reading.faults().empty()) return;
  additions.driven = mechanism.drivers;
  if (const toml::array* entries = document["driver"].as_array()) {
    for (const toml::node& entry : *entries) {
      additions.drivers += entry_text(reading, *entry.as_table(), "driver", "");
    }
  }
}

void read_more_guess(Reading& reading, const toml::table& document, Mechanism& mechanism,
                     Additions& additions) {
  mechanism.guess.clear();
  read_guess(reading, document, mechanism);
  for (const auto& [name, value] : mechanism.guess) {
    additions.guess += "\"" + name + "\" = " + number_text(value) + '\n';
  }
  if (!additions.guess.empty()) additions.guess = "\n[guess]\n" + additions.guess;
}

/// Faults of the whole are told at the first line of the side file where the mechanism itself has
/// them.
void forget_places(Mechanism& mechanism) {
  for (Body& body : mechanism.bodies) body.where = {};
  for (Joint& joint : mechanism.joints) joint.where = {};
}

}  // namespace

Additions read_additions(const Source& source, const Mechanism& mechanism,
                         const std::vector<Eigen::Matrix3d>& frames) {
  Reading reading(source);
  toml::table document = parse_toml(reading);
  Mechanism whole = mechanism;
  forget_places(whole);
  Additions additions;
  check_header(reading, document);
  additions.title = reading.text(document, "title").value_or("");
  read_more_points(reading, document, frames, whole);
  read_more_joints(reading, document, frames, whole, additions);
  read_more_drivers(reading, document, whole, additions);
  read_more_guess(reading, document, whole, additions);
  if (reading.faults().empty()) check_structure(reading, whole);
  throw_faults(reading);
  for (std::size_t k = 0; k < whole.bodies.size(); ++k) {
    const auto& points = whole.bodies[k].points;
    const auto first = static_cast<std::ptrdiff_t>(mechanism.bodies[k].points.size());
    additions.points.emplace_back(points.begin() + first, points.end());
  }
  return additions;
}

}  // namespace moivre
