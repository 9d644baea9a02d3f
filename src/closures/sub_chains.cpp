// SPDX-License-Identifier: MIT
// Bodies that the drivers place, and the connected pieces of the others.
#include "moivre/closures/sub_chains.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/spins.h"

namespace moivre {
namespace {

class ChainFinder {
 public:
  explicit ChainFinder(const Mechanism& mechanism)
      : mechanism_(mechanism), is_placed_(mechanism.bodies.size(), false) {
    is_placed_[0] = true;
    while (place_next()) {
    }
  }

  std::vector<IndependentChain> find() const {
    const std::vector<std::size_t> piece = pieces();
    std::vector<IndependentChain> chains;
    for (std::size_t first = 1; first < piece.size(); ++first) {
      if (is_placed_[first] || piece[first] != first) continue;
      std::vector<bool> is_own(piece.size(), false);
      for (std::size_t body = 1; body < piece.size(); ++body) {
        is_own[body] = !is_placed_[body] && piece[body] == first;
      }
      chains.push_back(chain(is_own));
    }
    if (chains.size() < 2) chains.clear();
    return chains;
  }

 private:
  bool place_next() {
    for (std::size_t body = 1; body < is_placed_.size(); ++body) {
      if (is_placed_[body] || !is_placed_alone(body)) continue;
      is_placed_[body] = true;
      return true;
    }
    return false;
  }

  bool is_placed_alone(std::size_t body) const {
    const std::vector<std::size_t> joints = ties(body);
    if (joints.size() != 1) return false;
    const auto reach = [&](const Driver& driver) {
      const std::vector<std::size_t> bodies = bodies_of(mechanism_, driver);
      return std::find(bodies.begin(), bodies.end(), body) != bodies.end() &&
             std::all_of(bodies.begin(), bodies.end(),
                         [&](std::size_t other) { return other == body || is_placed_[other]; });
    };
    const auto drivers = std::count_if(mechanism_.drivers.begin(), mechanism_.drivers.end(), reach);
    if (mechanism_.joints[joints.front()].type == JointType::weld) return drivers == 0;
    return drivers == 1 && std::any_of(mechanism_.drivers.begin(), mechanism_.drivers.end(),
                                       [&](const Driver& driver) {
                                         return reach(driver) &&
                                                drives(driver, joints.front(), body);
                                       });
  }

  /// Whether the driver fixes the one freedom of the joint between the body and a placed one.
  bool drives(const Driver& driver, std::size_t number, std::size_t body) const {
    const Joint& joint = mechanism_.joints[number];
    const bool is_spatial = mechanism_.space == Space::spatial;
    if (joint.type == JointType::prismatic) {
      return driver.kind == DriverKind::slide && driver.joint == number;
    }
    if (joint.type != JointType::revolute || driver.kind != DriverKind::angle) return false;
    if (is_spatial) return driver.joint == number;
    const auto& [a, b] = driver.bodies;
    return (a == body && is_placed_[b]) || (b == body && is_placed_[a]);
  }

  /// The joints that hold the body to placed ones; gears among them.
  std::vector<std::size_t> ties(std::size_t body) const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < mechanism_.joints.size(); ++k) {
      const std::vector<std::size_t> bodies = bodies_of(mechanism_.joints[k]);
      const bool is_tie = std::all_of(bodies.begin(), bodies.end(), [&](std::size_t other) {
        return other == body || is_placed_[other];
      });
      const bool has_body = std::find(bodies.begin(), bodies.end(), body) != bodies.end();
      const bool holds = has_rows(mechanism_.joints[k].type, mechanism_.space);
      if (is_tie && has_body && holds) found.push_back(k);
    }
    return found;
  }

  /// Of each body the first one of its piece.
  std::vector<std::size_t> pieces() const {
    std::vector<std::size_t> piece(mechanism_.bodies.size());
    std::iota(piece.begin(), piece.end(), std::size_t{0});
    const auto join = [&](const std::vector<std::size_t>& bodies) {
      std::set<std::size_t> free;
      for (const std::size_t body : bodies) {
        if (!is_placed_[body]) free.insert(piece[body]);
      }
      for (std::size_t& of : piece) {
        if (free.count(of) > 0) of = *free.begin();
      }
    };
    for (const Joint& joint : mechanism_.joints) join(bodies_of(joint));
    for (const Driver& driver : mechanism_.drivers) join(bodies_of(mechanism_, driver));
    return piece;
  }

  /// The mechanism of these bodies and the placed ones.
  IndependentChain chain(const std::vector<bool>& is_own) const {
    IndependentChain result;
    result.mechanism = mechanism_;
    Mechanism& part = result.mechanism;
    part.bodies.clear();
    part.joints.clear();
    part.drivers.clear();
    part.warnings.clear();
    std::vector<std::size_t> place(mechanism_.bodies.size(), 0);
    const Eigen::Index size = mechanism_.space == Space::planar ? 3 : 6;
    for (std::size_t body = 0; body < is_own.size(); ++body) {
      if (!is_own[body] && !is_placed_[body]) continue;
      place[body] = part.bodies.size();
      part.bodies.push_back(mechanism_.bodies[body]);
      if (is_own[body]) result.bodies.push_back(mechanism_.bodies[body].name);
      for (Eigen::Index k = 0; body > 0 && k < size; ++k) {
        result.coordinates.push_back(size * (static_cast<Eigen::Index>(body) - 1) + k);
      }
    }
    const auto is_in = [&](const std::vector<std::size_t>& bodies) {
      return std::all_of(bodies.begin(), bodies.end(),
                         [&](std::size_t body) { return is_own[body] || is_placed_[body]; });
    };
    // One more: a driver that drives no joint names the first, and there may be none.
    std::vector<std::size_t> place_of_joint(mechanism_.joints.size() + 1, 0);
    for (std::size_t k = 0; k < mechanism_.joints.size(); ++k) {
      Joint joint = mechanism_.joints[k];
      if (!is_in(bodies_of(joint))) continue;
      for (PointOf& at : joint.at) at.body = place[at.body];
      joint.gear.carrier = place[joint.gear.carrier];
      place_of_joint[k] = part.joints.size();
      part.joints.push_back(std::move(joint));
    }
    for (Driver driver : mechanism_.drivers) {
      if (!is_in(bodies_of(mechanism_, driver))) continue;
      for (std::size_t& body : driver.bodies) body = place[body];
      driver.point.body = place[driver.point.body];
      driver.joint = place_of_joint[driver.joint];
      part.drivers.push_back(std::move(driver));
    }
    part.held_spins = find_spins(part);
    std::erase_if(part.guess, [&](const auto& entry) {
      return std::none_of(part.bodies.begin(), part.bodies.end(), [&](const Body& body) {
        return entry.first.rfind(body.name + '.', 0) == 0;
      });
    });
    return result;
  }

  const Mechanism& mechanism_;
  std::vector<bool> is_placed_;
};

}  // namespace

std::vector<IndependentChain> independent_chains(const Mechanism& mechanism) {
  if (is_typed(mechanism)) return {};
  return ChainFinder(mechanism).find();
}

}  // namespace moivre
