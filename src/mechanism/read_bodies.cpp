// SPDX-License-Identifier: MIT
// How are bodies, points and joints read?
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>

#include "faults.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/nearest.h"
#include "read_parts.h"
#include "read_tolerances.h"
#include "refusals.h"

namespace moivre {
namespace {

/// x, y (and z) as a vector; a fault where their number does not fit the space.
std::optional<Eigen::Vector3d> read_vector(Reading& reading, const toml::node& node,
                                           const std::string& what, Space space) {
  const std::size_t size = space == Space::planar ? 2 : 3;
  const auto values = reading.numbers(node, what, size);
  if (!values) return std::nullopt;
  return Eigen::Vector3d((*values)[0], (*values)[1], size == 3 ? (*values)[2] : 0);
}

void read_point(Reading& reading, const toml::table& in, const toml::key& key, Space space,
                Body& body) {
  const std::string name(key.str());
  const SourcePosition where = reading.position(key.source().begin);
  if (!is_name(name)) {
    reading.fault(where, "a point's name may have letters, digits, '_' and '-' only");
  }
  const std::string what = "point '" + body.name + "." + name + "'";
  const auto at = read_vector(reading, *in.get(name), what, space);
  body.points.push_back({name, at.value_or(Eigen::Vector3d::Zero()), where});
}

void read_points(Reading& reading, const toml::table& in, Space space, Body& body) {
  std::vector<std::string> known{"points", "tolerance", "tolerances"};
  bool is_told = false;
  for (const toml::key* key : reading.keys_in_order(in)) {
    if (!in.get(key->str())->is_array() || key->str() == "points") continue;
    known.emplace_back(key->str());
    const std::string header = body.name == "ground" ? "ground" : "body." + body.name;
    if (!is_told) {
      reading.fault(reading.position(key->source().begin),
                    "points stand under [" + header + ".points], not under [" + header + "]");
    }
    is_told = true;
    read_point(reading, in, *key, space, body);
  }
  reading.check_keys(in, known, "body '" + body.name + "'");
  const toml::table* points = reading.table(in, "points");
  if (points == nullptr) return;
  for (const toml::key* key : reading.keys_in_order(*points)) {
    read_point(reading, *points, *key, space, body);
  }
}

/// Why a joint of that name is refused; empty for a mere misspelling.
std::string refusal(const std::string& type) {
  const auto is_one_of = [&](std::initializer_list<const char*> words) {
    return std::any_of(words.begin(), words.end(), [&](const char* word) { return type == word; });
  };
  if (is_one_of(
          {"rolling", "wheel", "velocity", "nonholonomic", "non-holonomic", "skate", "knife"})) {
    return kVelocityJoint;
  }
  if (is_one_of({"contact", "stop", "unilateral", "impact", "bump", "cable", "rope"})) {
    return kOneSidedJoint;
  }
  return "";
}

/// The type that others call so; nullopt where it has no other name.
std::optional<JointType> type_called(const std::string& word) {
  static const std::map<std::string, JointType> names{{"pin", JointType::revolute},
                                                      {"hinge", JointType::revolute},
                                                      {"pivot", JointType::revolute},
                                                      {"rotation", JointType::revolute},
                                                      {"slider", JointType::prismatic},
                                                      {"translation", JointType::prismatic},
                                                      {"linear", JointType::prismatic},
                                                      {"pin-in-slot", JointType::slot},
                                                      {"fixed", JointType::weld},
                                                      {"rigid", JointType::weld},
                                                      {"distance", JointType::rod},
                                                      {"link", JointType::rod},
                                                      {"bar", JointType::rod},
                                                      {"cylinder", JointType::actuator},
                                                      {"linear-actuator", JointType::actuator},
                                                      {"strut", JointType::actuator},
                                                      {"ram", JointType::actuator},
                                                      {"ball", JointType::spherical},
                                                      {"cardan", JointType::universal},
                                                      {"hooke", JointType::universal},
                                                      {"gears", JointType::gear},
                                                      {"chain", JointType::belt},
                                                      {"pulley", JointType::belt},
                                                      {"timing-belt", JointType::belt},
                                                      {"pinion", JointType::rack},
                                                      {"rack-and-pinion", JointType::rack},
                                                      {"cam-follower", JointType::cam},
                                                      {"rocker-cam", JointType::cam_lever},
                                                      {"helical", JointType::screw},
                                                      {"lead-screw", JointType::screw},
                                                      {"inline", JointType::point_on_line},
                                                      {"inplane", JointType::point_on_plane}};
  const auto found = names.find(word);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

/// Types that the space has.
std::vector<JointTraits> types_in(Space space) {
  std::vector<JointTraits> found;
  for (const JointTraits& row : all_joint_types()) {
    if (exists_in(space, row)) found.push_back(row);
  }
  return found;
}

std::optional<JointType> read_type(Reading& reading, const toml::table& entry, Space space) {
  const auto word = reading.text(entry, "type");
  if (!word) {
    if (!entry.contains("type"))
      reading.fault(entry, "a joint needs a 'type', such as \"revolute\"");
    return std::nullopt;
  }
  const toml::node& at = *entry.get("type");
  std::vector<std::string> known;
  for (const JointTraits& row : types_in(space)) {
    if (row.name == *word) return row.type;
    known.emplace_back(row.name);
  }
  const Space other = space == Space::planar ? Space::spatial : Space::planar;
  for (const JointTraits& row : types_in(other)) {
    if (row.name != *word) continue;
    reading.fault(at, "a " + *word + " joint needs space = \"" +
                          (other == Space::planar ? "planar\"" : "spatial\""));
    return std::nullopt;
  }
  const std::string reason = refusal(*word);
  const auto called = type_called(*word);
  const std::string advice =
      called ? "; here it is called '" + to_string(*called) + "'" : suggestion(*word, known);
  reading.fault(at, reason.empty() ? "unknown joint type '" + *word + "'" + advice
                                   : "'" + *word + "': " + reason);
  return std::nullopt;
}

std::vector<std::string> keys_of(JointType type, Space space) {
  if (type == JointType::gear) return {"type", "name", "bodies", "carrier", "phase", "ratio"};
  if (type == JointType::belt) {
    return {"type", "name", "bodies", "carrier", "phase", "radii", "crossed"};
  }
  if (type == JointType::cam_lever) {
    return {"type", "name", "bodies", "carrier", "phase", "profile"};
  }
  std::vector<std::string> keys{"type", "name", "at"};
  if (space == Space::planar && has_line(type)) keys.emplace_back("along");
  if (space == Space::spatial && axis_count(type) > 0) keys.emplace_back("axis");
  if (traits(type).turn == JointTurn::not_at_all) keys.insert(keys.end(), {"turn", "tolerance"});
  if (has_slide(type) || has_angle(type)) keys.emplace_back("limits");
  if (type == JointType::rod) keys.insert(keys.end(), {"length", "tolerance"});
  if (type == JointType::actuator) keys.emplace_back("length");
  if (type == JointType::screw) keys.emplace_back("pitch");
  if (type == JointType::cam) keys.insert(keys.end(), {"carrier", "phase", "profile"});
  if (type == JointType::rack) keys.insert(keys.end(), {"radius", "phase"});
  return keys;
}

void read_ends(Reading& reading, const toml::table& entry, const Mechanism& mechanism,
               Joint& joint) {
  const toml::node* at = entry.get("at");
  if (at == nullptr) {
    reading.fault(entry,
                  "the joint needs 'at', its two points: at = [\"body.point\", \"body.point\"]");
    return;
  }
  const auto names = reading.texts(entry, "at", 2, "[\"body.point\", \"other.point\"]");
  if (!names) return;
  std::array<std::optional<PointOf>, 2> found;
  for (std::size_t k = 0; k < 2; ++k) {
    found[k] =
        find_point(reading, mechanism, (*names)[k], reading.position(*at->as_array()->get(k)));
    if (found[k]) joint.at[k] = *found[k];
  }
  if (found[0] && found[1] && found[0]->body == found[1]->body) {
    reading.fault(*at, "the joint ties body '" + mechanism.bodies[found[0]->body].name +
                           "' to itself; a joint needs two bodies");
  }
}

void read_unit_vector(Reading& reading, const toml::node& node, const std::string& what,
                      Space space, Eigen::Vector3d& direction) {
  const auto value = read_vector(reading, node, what, space);
  if (!value) return;
  const double length = value->stableNorm();
  if (length > 0) {
    direction = *value / length;
  } else {
    reading.fault(node, what + " must not be the zero vector");
  }
}

/// Planar `along`, or spatial `axis`: one vector for both bodies, or one in each body's frame.
void read_axes(Reading& reading, const toml::table& entry, Space space, Joint& joint) {
  const bool is_planar = space == Space::planar;
  const char* key = is_planar ? "along" : "axis";
  const toml::node* node = entry.get(key);
  if (node == nullptr) {
    if (!is_planar && joint.type == JointType::weld) return;
    reading.fault(entry, "a " + to_string(joint.type) + " joint needs '" + key + "', " +
                             (is_planar ? "the direction of its line in the first body's frame"
                                        : "its direction in the bodies' frames"));
    return;
  }
  const toml::array* entries = node->as_array();
  const bool is_pair =
      !is_planar && entries != nullptr && entries->size() == 2 && entries->get(0)->is_array();
  const std::string what = std::string("'") + key + "'";
  if (is_pair) {
    if (axis_count(joint.type) == 1) {
      reading.fault(*node, "a " + to_string(joint.type) +
                               " joint takes one axis, a direction in the first body's frame");
      return;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      read_unit_vector(reading, *entries->get(k), what, space, joint.axis[k]);
    }
    return;
  }
  if (joint.type == JointType::universal) {
    reading.fault(
        *node, "a universal joint needs two axes, one in each body's frame: axis = [[...], [...]]");
    return;
  }
  read_unit_vector(reading, *node, what, space, joint.axis[0]);
  joint.axis[1] = joint.axis[0];
}

void read_length(Reading& reading, const toml::table& entry, Joint& joint) {
  const auto length = reading.number(entry, "length");
  if (!length) {
    const bool is_missing = joint.type == JointType::rod && !entry.contains("length");
    if (is_missing) reading.fault(entry, "a rod needs its 'length'");
    return;
  }
  if (*length <= 0) {
    const std::string name = joint.type == JointType::rod ? "a rod" : "an actuator";
    reading.fault(
        *entry.get("length"),
        name + (*length == 0
                    ? " of length zero is a revolute joint (spatial: spherical); write that"
                    : "'s length must be positive"));
  }
  joint.length = *length;
}

void read_pitch(Reading& reading, const toml::table& entry, Joint& joint) {
  const auto pitch = reading.number(entry, "pitch");
  if (!pitch) {
    if (!entry.contains("pitch")) {
      reading.fault(entry,
                    "a screw needs its 'pitch', the advance in a whole turn (negative where it is "
                    "left-handed)");
    }
    return;
  }
  if (*pitch == 0) {
    reading.fault(*entry.get("pitch"), "a screw of pitch zero is a revolute joint; write that");
  }
  joint.pitch = *pitch;
}

void read_radius(Reading& reading, const toml::table& entry, Joint& joint) {
  const auto radius = reading.number(entry, "radius");
  if (radius == 0) {
    reading.fault(*entry.get("radius"), "a pinion's pitch radius must not be zero");
  } else if (!radius && !entry.contains("radius")) {
    reading.fault(entry,
                  "a rack needs 'radius', that of the pinion's pitch circle (negative where the "
                  "pinion is on the left of 'along')");
  }
  joint.radius = radius.value_or(1);
}

void read_limits(Reading& reading, const toml::table& entry, const Mechanism& mechanism,
                 Joint& joint) {
  const auto bounds = reading.numbers(entry, "limits", 2);
  if (!bounds) return;
  const double unit = is_angular(joint.type) ? angle_unit(mechanism) : 1;
  joint.limits = Limits{(*bounds)[0] * unit, (*bounds)[1] * unit};
  if ((*bounds)[0] > (*bounds)[1]) {
    reading.fault(*entry.get("limits"),
                  "the lower limit is above the upper; write limits = [lower, upper]");
  } else if (joint.type == JointType::actuator && (*bounds)[0] < 0) {
    reading.fault(*entry.get("limits"), "the limits of an actuator's length are from 0 up");
  }
}

std::optional<int> read_teeth(Reading& reading, const toml::node& node) {
  const auto teeth = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
  if (teeth && *teeth != 0 && *teeth >= -kMostTeeth && *teeth <= kMostTeeth) {
    return static_cast<int>(*teeth);
  }
  reading.fault(node, "a gear's teeth must be a whole number other than 0, at most 100000");
  return std::nullopt;
}

void read_ratio(Reading& reading, const toml::table& entry, Joint& joint) {
  const toml::node* given = entry.get("ratio");
  const toml::array* ratio = given == nullptr ? nullptr : given->as_array();
  if (ratio != nullptr && ratio->size() == 2) {
    for (std::size_t k = 0; k < 2; ++k) {
      joint.gear.teeth[k] = read_teeth(reading, *ratio->get(k)).value_or(1);
    }
  } else {
    reading.fault(given == nullptr ? entry : *given,
                  "a gear needs 'ratio', the teeth of both wheels: ratio = [-20, 40]");
  }
}

/// Whole numbers in the ratio of two decimals, without a common factor; nothing where one would be
/// more than kMostTeeth.
std::optional<std::array<int, 2>> whole_ratio(double a, double b) {
  constexpr double kFinestDecimal = 1e9;
  constexpr double kRounding = 1e-15;
  const auto is_whole = [](double x) { return std::abs(x - std::round(x)) <= kRounding * x; };
  for (double scale = 1; scale <= kFinestDecimal; scale *= 10) {
    if (!is_whole(a * scale) || !is_whole(b * scale)) continue;
    const std::int64_t whole[] = {std::llround(a * scale), std::llround(b * scale)};
    const std::int64_t common = std::gcd(whole[0], whole[1]);
    if (std::max(whole[0], whole[1]) / common > kMostTeeth) return std::nullopt;
    return std::array{static_cast<int>(whole[0] / common), static_cast<int>(whole[1] / common)};
  }
  return std::nullopt;
}

void read_radii(Reading& reading, const toml::table& entry, Joint& joint) {
  const auto radii = reading.numbers(entry, "radii", 2);
  if (!radii) {
    if (!entry.contains("radii"))
      reading.fault(entry, "a belt needs the 'radii' of both pulleys: radii = [30, 60]");
    return;
  }
  const toml::node& at = *entry.get("radii");
  if ((*radii)[0] <= 0 || (*radii)[1] <= 0) {
    reading.fault(at, "a pulley's radius must be positive; a crossed belt has crossed = true");
    return;
  }
  joint.gear.radii = {(*radii)[0], (*radii)[1]};
  const auto ratio = whole_ratio((*radii)[0], (*radii)[1]);
  if (!ratio) {
    reading.fault(at, "the ratio of the radii must be one of whole numbers up to " +
                          std::to_string(kMostTeeth) + "; round them");
    return;
  }
  joint.gear.teeth = *ratio;
  if (reading.truth(entry, "crossed").value_or(false)) joint.gear.teeth[0] *= -1;
}

/// The two bodies of a joint without points.
void read_pair(Reading& reading, const toml::table& entry, const Mechanism& mechanism,
               Joint& joint) {
  const std::string type = to_string(joint.type);
  if (const auto names = reading.texts(entry, "bodies", 2, "[\"body\", \"other\"]")) {
    const toml::array& at = *entry.get("bodies")->as_array();
    bool is_found = true;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto body = find_body(reading, mechanism, (*names)[k], reading.position(*at.get(k)));
      is_found = is_found && body;
      joint.at[k].body = body.value_or(0);
    }
    if (is_found && joint.at[0].body == joint.at[1].body) {
      reading.fault(at, "the " + type + " ties body '" + (*names)[0] + "' to itself; a " + type +
                            " needs two bodies");
    }
  } else if (!entry.contains("bodies")) {
    reading.fault(entry, "a " + type + " needs its two 'bodies'");
  }
}

void read_carrier(Reading& reading, const toml::table& entry, const Mechanism& mechanism,
                  Joint& joint) {
  if (const auto carrier = reading.text(entry, "carrier")) {
    const SourcePosition at = reading.position(*entry.get("carrier"));
    joint.gear.carrier = find_body(reading, mechanism, *carrier, at).value_or(0);
    if (joint.gear.carrier == joint.at[0].body || joint.gear.carrier == joint.at[1].body) {
      if (joint.gear.carrier != 0)
        reading.fault(at, "a " + to_string(joint.type) + "'s carrier must be a third body");
    }
  }
}

/// Lifts over a whole turn of the cam, the last one the first.
void read_profile(Reading& reading, const toml::table& entry, const Mechanism& mechanism,
                  Joint& joint) {
  constexpr double kTurn = 2 * std::numbers::pi;
  constexpr double kRounding = 1e-9;
  constexpr std::size_t kFewest = 4;
  const toml::array* rows = reading.array(entry, "profile");
  if (rows == nullptr) {
    if (!entry.contains("profile")) {
      reading.fault(entry, "a " + to_string(joint.type) +
                               " needs its 'profile', [angle, lift] over a whole turn");
    }
    return;
  }
  const double lift_unit = joint.type == JointType::cam ? 1 : angle_unit(mechanism);
  std::vector<double> angle_rad;
  std::vector<double> lift;
  for (const toml::node& row : *rows) {
    const auto pair = reading.numbers(row, "a row of 'profile'", 2);
    if (!pair) return;
    const double at = (*pair)[0] * angle_unit(mechanism);
    if (!angle_rad.empty() && at <= angle_rad.back()) {
      return reading.fault(row, "the angles of a profile must increase");
    }
    angle_rad.push_back(at);
    lift.push_back((*pair)[1] * lift_unit);
  }
  const bool is_whole = angle_rad.size() >= kFewest &&
                        std::abs(angle_rad.back() - angle_rad.front() - kTurn) <= kRounding &&
                        lift.back() == lift.front();
  if (!is_whole) {
    return reading.fault(*rows,
                         "a profile needs four or more rows, from one angle to a whole turn "
                         "further, and ends with the lift that it begins with");
  }
  joint.profile = periodic_spline(std::move(angle_rad), std::move(lift));
}

Joint read_joint(Reading& reading, const toml::table& entry, const Mechanism& mechanism) {
  Joint joint;
  joint.where = reading.position(entry);
  const auto type = read_type(reading, entry, mechanism.space);
  if (!type) return joint;
  joint.type = *type;
  const std::vector<std::string> keys = keys_of(joint.type, mechanism.space);
  const auto has = [&](const char* key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  reading.check_keys(entry, keys, "a " + to_string(joint.type) + " joint");
  joint.name = reading.text(entry, "name").value_or("");
  if (has("at")) read_ends(reading, entry, mechanism, joint);
  if (has("along") || has("axis")) read_axes(reading, entry, mechanism.space, joint);
  if (has("turn"))
    joint.turn_rad = reading.number(entry, "turn").value_or(0) * angle_unit(mechanism);
  if (has("length")) read_length(reading, entry, joint);
  if (has("pitch")) read_pitch(reading, entry, joint);
  if (has("radius")) read_radius(reading, entry, joint);
  if (has("limits")) read_limits(reading, entry, mechanism, joint);
  if (has("ratio")) read_ratio(reading, entry, joint);
  if (has("radii")) read_radii(reading, entry, joint);
  if (has("bodies")) read_pair(reading, entry, mechanism, joint);
  if (has("carrier")) read_carrier(reading, entry, mechanism, joint);
  if (has("profile")) read_profile(reading, entry, mechanism, joint);
  if (has("phase")) {
    joint.gear.phase_rad = reading.number(entry, "phase").value_or(0) * angle_unit(mechanism);
  }
  return joint;
}

/// "A" where both points are called so, else "crank.A-coupler.B".
std::string name_from_ends(const Mechanism& mechanism, const Joint& joint) {
  if (traits(joint.type).place == JointPlace::anywhere) {
    return mechanism.bodies[joint.at[0].body].name + "-" + mechanism.bodies[joint.at[1].body].name;
  }
  const auto point = [&](std::size_t k) {
    return mechanism.bodies[joint.at[k].body].points[joint.at[k].point].name;
  };
  const auto full = [&](std::size_t k) {
    return mechanism.bodies[joint.at[k].body].name + "." + point(k);
  };
  if (point(0) != point(1)) return full(0) + "-" + full(1);
  const auto shares_point_name = [&](const Joint& other) { return other.name == point(0); };
  const bool is_taken =
      std::any_of(mechanism.joints.begin(), mechanism.joints.end(), shares_point_name);
  return is_taken ? full(0) + "-" + full(1) : point(0);
}

void check_joint_names(Reading& reading, const Mechanism& mechanism) {
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      const Joint& joint = mechanism.joints[k];
      if (joint.name.empty() || joint.name != mechanism.joints[j].name) continue;
      reading.fault(joint.where, "two joints are called '" + joint.name + "'; rename one of them");
    }
  }
}

}  // namespace

std::vector<std::string> body_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const Body& body : mechanism.bodies) names.push_back(body.name);
  return names;
}

std::optional<std::size_t> find_body(Reading& reading, const Mechanism& mechanism,
                                     const std::string& name, const SourcePosition& at) {
  for (std::size_t k = 0; k < mechanism.bodies.size(); ++k) {
    if (mechanism.bodies[k].name == name) return k;
  }
  reading.fault(at, "there is no body '" + name + "'" + suggestion(name, body_names(mechanism)));
  return std::nullopt;
}

std::optional<PointOf> find_point(Reading& reading, const Mechanism& mechanism,
                                  const std::string& name, const SourcePosition& at) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) {
    reading.fault(at, "'" + name + "' is no point; write \"body.point\"");
    return std::nullopt;
  }
  const auto body = find_body(reading, mechanism, name.substr(0, dot), at);
  if (!body) return std::nullopt;
  std::vector<std::string> known;
  for (const BodyPoint& point : mechanism.bodies[*body].points) {
    if (point.name == name.substr(dot + 1)) return PointOf{*body, known.size()};
    known.push_back(point.name);
  }
  reading.fault(at, "body '" + name.substr(0, dot) + "' has no point '" + name.substr(dot + 1) +
                        "'" + suggestion(name.substr(dot + 1), known));
  return std::nullopt;
}

void read_bodies(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  if (const toml::table* ground = reading.table(document, "ground")) {
    read_points(reading, *ground, mechanism.space, mechanism.bodies[0]);
    read_point_tolerances(reading, *ground, mechanism.bodies[0], mechanism);
  }
  const toml::table* bodies = reading.table(document, "body");
  if (bodies == nullptr) {
    if (!document.contains("body")) {
      reading.fault(SourcePosition{},
                    "the file has no bodies besides the ground; write [body.NAME.points]");
    }
    return;
  }
  for (const toml::key* key : reading.keys_in_order(*bodies)) {
    Body body;
    body.name = std::string(key->str());
    body.where = reading.position(key->source().begin);
    if (body.name == "ground") {
      reading.fault(body.where, "the ground is no [body.ground]; write [ground.points]");
      continue;
    }
    if (!is_name(body.name)) {
      reading.fault(body.where, "a body's name may have letters, digits, '_' and '-' only");
    }
    if (const toml::table* entry = reading.table(*bodies, body.name)) {
      read_points(reading, *entry, mechanism.space, body);
      read_point_tolerances(reading, *entry, body, mechanism);
    }
    mechanism.bodies.push_back(std::move(body));
  }
}

void read_joints(Reading& reading, const toml::table& document, Mechanism& mechanism) {
  const toml::array* entries = reading.array(document, "joint");
  if (entries == nullptr) {
    if (!document.contains("joint")) {
      reading.fault(SourcePosition{}, "the file has no joints; write one [[joint]] for each");
    }
    return;
  }
  for (const toml::node& entry : *entries) {
    if (!entry.is_table()) {
      reading.fault(entry, "a joint must be a table; write [[joint]]");
      continue;
    }
    const std::size_t faults_before = reading.faults().size();
    Joint joint = read_joint(reading, *entry.as_table(), mechanism);
    if (reading.faults().size() != faults_before) continue;
    if (joint.name.empty()) joint.name = name_from_ends(mechanism, joint);
    if (const auto tolerance = read_tolerance(reading, *entry.as_table())) {
      const bool is_rod = joint.type == JointType::rod;
      mechanism.tolerances[joint.name + (is_rod ? ".length" : ".turn")] =
          *tolerance * (is_rod ? 1 : angle_unit(mechanism));
    }
    mechanism.joints.push_back(std::move(joint));
  }
  check_joint_names(reading, mechanism);
}

}  // namespace moivre
