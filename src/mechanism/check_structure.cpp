// SPDX-License-Identifier: MIT
// Does the file describe one mechanism? What no single entry shows: loose bodies, weld cycles,
// links of no length, drivers.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "faults.h"
#include "joint_lengths.h"
#include "moivre/expression/counted.h"
#include "moivre/mechanism/joint_type.h"
#include "read_parts.h"

namespace moivre {
namespace {

/// Sets of bodies that are joined (union-find).
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::size_t find(std::size_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  /// Whether the two were apart.
  bool join(std::size_t a, std::size_t b) {
    const std::size_t first = find(a);
    const std::size_t second = find(b);
    parent_[first] = second;
    return first != second;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// Gears, racks and cams hold motions, not places.
bool places(const Joint& joint) { return !is_transmission(joint.type); }

void check_connected(Faults& faults, const Mechanism& mechanism) {
  Groups groups(mechanism.bodies.size());
  for (const Joint& joint : mechanism.joints) {
    if (places(joint)) groups.join(joint.at[0].body, joint.at[1].body);
  }
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    if (groups.find(body) == groups.find(0)) continue;
    faults.push_back({mechanism.bodies[body].where,
                      "body '" + mechanism.bodies[body].name +
                          "' is not connected to the ground by joints; join it or remove it"});
  }
}

void check_welds(Faults& faults, const Mechanism& mechanism) {
  Groups groups(mechanism.bodies.size());
  for (const Joint& joint : mechanism.joints) {
    if (joint.type != JointType::weld || groups.join(joint.at[0].body, joint.at[1].body)) continue;
    faults.push_back(
        {joint.where, "weld '" + joint.name + "' closes a cycle of welds; remove one of them"});
  }
}

/// What is counted for zero, in rank and in what moves, is so relative to lengths near 1.
void check_size(Faults& faults, const Mechanism& mechanism) {
  constexpr double kLongest = 1e9;
  double longest = 0;
  for (const Body& body : mechanism.bodies) {
    // Squares of lengths below 1e-162 vanish, and so would a norm made of them.
    for (const BodyPoint& point : body.points) {
      longest = std::max(longest, point.at.stableNorm());
    }
  }
  for (const Joint& joint : mechanism.joints) {
    if (reads_length(joint.type)) longest = std::max(longest, std::abs(joint.length));
  }
  if (longest == 0 || (longest <= kLongest && longest >= 1 / kLongest)) return;
  faults.push_back(
      {SourcePosition{},
       "the largest length must lie between 1e-9 and 1e9; give lengths in another unit"});
}

/// Rank, null spaces and singular values are those of dense matrices: more bodies take minutes a
/// pose.
void check_count(Faults& faults, const Mechanism& mechanism) {
  constexpr std::size_t kMostBodies = 300;
  if (mechanism.bodies.size() <= kMostBodies + 1) return;
  faults.push_back({mechanism.bodies[kMostBodies + 1].where,
                    "there are " + counted(mechanism.bodies.size() - 1, "body", "bodies") +
                        ", at most " + std::to_string(kMostBodies) + " are taken"});
}

void check_rods(Faults& faults, const Mechanism& mechanism) {
  for (const Joint& joint : mechanism.joints) {
    if (joint.type != JointType::rod || joint.length > 0) continue;
    faults.push_back({joint.where, "rod '" + joint.name + "' needs a length above 0"});
  }
}

/// A body that is held at one place only, by pins twice or more, turns about it for nothing.
void check_lengths(Faults& faults, const Mechanism& mechanism) {
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    std::vector<Eigen::Vector3d> pins;
    bool has_pins_only = true;
    for (const Joint& joint : mechanism.joints) {
      for (const PointOf& end : joint.at) {
        if (end.body != body) continue;
        has_pins_only = has_pins_only && joint.type == JointType::revolute;
        if (has_pins_only) pins.push_back(mechanism.bodies[body].points[end.point].at);
      }
    }
    const bool is_one_place = std::all_of(
        pins.begin(), pins.end(), [&](const Eigen::Vector3d& pin) { return pin == pins.front(); });
    if (!has_pins_only || pins.size() < 2 || !is_one_place || mechanism.space != Space::planar)
      continue;
    faults.push_back(
        {mechanism.bodies[body].where,
         "body '" + mechanism.bodies[body].name +
             "' has length zero: all its joints are at one place; move one or join its "
             "neighbours directly"});
  }
}

/// What a rack's second point or a cam's first is: the centre of a wheel.
struct Centre {
  PointOf point;
  const char* of;
  const char* advice;
};

std::optional<Centre> centre_of(const Joint& joint) {
  if (joint.type == JointType::rack) {
    return Centre{joint.at[1], "pinion", "[\"rack.point\", \"pinion.centre\"]"};
  }
  if (joint.type == JointType::cam) {
    return Centre{joint.at[0], "cam", "[\"cam.centre\", \"follower.point\"]"};
  }
  return std::nullopt;
}

void check_centres(Faults& faults, const Mechanism& mechanism) {
  const auto place = [&](const PointOf& p) { return mechanism.bodies[p.body].points[p.point].at; };
  for (const Joint& joint : mechanism.joints) {
    const auto centre = centre_of(joint);
    if (!centre) continue;
    const PointOf& at = centre->point;
    const auto is_there = [&](const PointOf& end) {
      return end.body == at.body && place(end) == place(at);
    };
    const bool has_pin =
        std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& other) {
          return other.type == JointType::revolute &&
                 (is_there(other.at[0]) || is_there(other.at[1]));
        });
    if (has_pin) continue;
    const Body& wheel = mechanism.bodies[at.body];
    faults.push_back({joint.where, "no revolute joint is at '" + wheel.name + "." +
                                       wheel.points[at.point].name + "', which should be the " +
                                       centre->of + "'s centre; write at = " + centre->advice});
  }
}

void check_twin_joints(Faults& faults, const Mechanism& mechanism) {
  const auto same = [](const PointOf& a, const PointOf& b) {
    return a.body == b.body && a.point == b.point;
  };
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      const Joint& a = mechanism.joints[j];
      const Joint& b = mechanism.joints[k];
      if (!places(a) || a.type != b.type) continue;
      const bool is_same = same(a.at[0], b.at[0]) && same(a.at[1], b.at[1]);
      const bool is_mirrored = same(a.at[0], b.at[1]) && same(a.at[1], b.at[0]);
      if (is_same || is_mirrored)
        faults.push_back({b.where, "this joint repeats joint '" + a.name + "'; remove it"});
    }
  }
}

bool drives_a_screw(const Mechanism& mechanism, const Driver& driver) {
  const bool is_at_a_joint =
      driver.kind == DriverKind::slide ||
      (driver.kind == DriverKind::angle && mechanism.space == Space::spatial);
  return is_at_a_joint && mechanism.joints[driver.joint].type == JointType::screw;
}

bool drive_the_same(const Mechanism& mechanism, const Driver& a, const Driver& b) {
  if (a.kind != b.kind) {
    return drives_a_screw(mechanism, a) && drives_a_screw(mechanism, b) && a.joint == b.joint;
  }
  switch (a.kind) {
    case DriverKind::angle:
      if (mechanism.space == Space::spatial) return a.joint == b.joint;
      return a.bodies == b.bodies || (a.bodies[0] == b.bodies[1] && a.bodies[1] == b.bodies[0]);
    case DriverKind::slide:
      return a.joint == b.joint;
    case DriverKind::x:
    case DriverKind::y:
    case DriverKind::z:
      return a.point.body == b.point.body && a.point.point == b.point.point;
    case DriverKind::unknown:
      return a.unknown == b.unknown;
  }
  return false;
}

/// An upper bound of the degrees of freedom: a tree of joints from the ground already places every
/// body.
int freedoms_at_most(const Mechanism& mechanism) {
  if (is_typed(mechanism)) return static_cast<int>(mechanism.unknowns.size());
  std::vector<const Joint*> joints;
  for (const Joint& joint : mechanism.joints) {
    if (places(joint)) joints.push_back(&joint);
  }
  std::stable_sort(joints.begin(), joints.end(), [&](const Joint* a, const Joint* b) {
    return freedoms(a->type, mechanism.space) < freedoms(b->type, mechanism.space);
  });
  Groups groups(mechanism.bodies.size());
  int bound = 0;
  for (const Joint* joint : joints) {
    if (groups.join(joint->at[0].body, joint->at[1].body))
      bound += freedoms(joint->type, mechanism.space);
  }
  return bound;
}

void check_drivers(Faults& faults, const Mechanism& mechanism) {
  const auto& drivers = mechanism.drivers;
  for (std::size_t k = 0; k < drivers.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      if (!drive_the_same(mechanism, drivers[j], drivers[k])) continue;
      faults.push_back({drivers[k].where,
                        "'" + drivers[k].name + "' is driven twice; remove one of the drivers"});
    }
  }
  const int most = freedoms_at_most(mechanism);
  if (static_cast<int>(drivers.size()) > most) {
    faults.push_back({drivers[static_cast<std::size_t>(most)].where,
                      "too many drivers: the joints leave at most " +
                          counted(most, "degree of freedom", "degrees of freedom") +
                          ", there are " + std::to_string(drivers.size()) + " drivers"});
  }
}

int rows_of(const Joint& joint, Space space) {
  return (space == Space::planar ? 3 : 6) - freedoms(joint.type, space);
}

/// More constraints than coordinates, or more drivers than Gruebler's count, are odd, but redundant
/// constraints can make it right.
void warn_of_count(Mechanism& mechanism) {
  int naive = static_cast<int>(coordinates(mechanism).size()) -
              static_cast<int>(mechanism.equations.size());
  for (const Joint& joint : mechanism.joints) naive -= rows_of(joint, mechanism.space);
  const int drivers = static_cast<int>(mechanism.drivers.size());
  const std::string count = "coordinates minus constraints are " + std::to_string(naive);
  if (naive < 0) {
    mechanism.warnings.push_back(
        count + ": it closes only where constraints are redundant (moivre mobility names them)");
  } else if (drivers > naive) {
    mechanism.warnings.push_back(
        count + ", drivers are " + std::to_string(drivers) +
        ": too many drivers, unless constraints are redundant (moivre mobility tells)");
  }
}

/// Whether a joint names the point.
bool is_used(const Mechanism& mechanism, std::size_t body, std::size_t point) {
  const auto is_it = [&](const PointOf& p) { return p.body == body && p.point == point; };
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
    return traits(joint.type).place != JointPlace::anywhere &&
           (is_it(joint.at[0]) || is_it(joint.at[1]));
  });
}

/// A pivot that nothing is tied to is a slip more often than a mark; points of moving bodies are
/// there to be traced.
void warn_of_loose_pivots(Mechanism& mechanism) {
  const auto& points = mechanism.bodies[0].points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (is_used(mechanism, 0, k)) continue;
    mechanism.warnings.push_back("no joint holds anything at 'ground." + points[k].name +
                                 "': is one tied elsewhere?");
  }
}

}  // namespace

void find_structure_faults(const Mechanism& mechanism, Faults& faults) {
  check_connected(faults, mechanism);
  check_welds(faults, mechanism);
  check_rods(faults, mechanism);
  check_lengths(faults, mechanism);
  check_centres(faults, mechanism);
  check_size(faults, mechanism);
  check_count(faults, mechanism);
  check_twin_joints(faults, mechanism);
  check_drivers(faults, mechanism);
}

void check_structure(Reading& reading, Mechanism& mechanism) {
  find_form_faults(mechanism, reading.faults());
  if (!reading.faults().empty()) return;
  find_structure_faults(mechanism, reading.faults());
  warn_of_count(mechanism);
  warn_of_loose_pivots(mechanism);
  warn_of_mistyped_point(mechanism);
}

}  // namespace moivre
