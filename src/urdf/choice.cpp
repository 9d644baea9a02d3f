// SPDX-License-Identifier: MIT
// Names looked up, with the names that were to choose from.
#include "moivre/urdf/choice.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "moivre/expression/joined.h"
#include "moivre/mechanism/nearest.h"

namespace moivre {
namespace {

/// A message names at most so many links or joints.
constexpr std::size_t kMostNamed = 20;

template <class List>
std::vector<std::string> names_of(const List& list) {
  std::vector<std::string> names;
  for (const auto& element : list) names.push_back(element.name);
  return names;
}

}  // namespace

std::string listed_names(std::vector<std::string> names) {
  const bool are_many = names.size() > kMostNamed;
  names.resize(std::min(names.size(), kMostNamed));
  return joined(names, ", ") + (are_many ? ", ..." : "");
}

std::size_t find_link(const Robot& robot, const std::optional<std::string>& name,
                      std::size_t otherwise, std::vector<std::string>& faults) {
  if (!name) return otherwise;
  if (const auto link = link_named(robot, *name)) return *link;
  faults.push_back("there is no link '" + *name + "'" + suggestion(*name, names_of(robot.links)));
  return otherwise;
}

std::size_t find_tip(const Robot& robot, const std::optional<std::string>& name,
                     std::vector<std::string>& faults) {
  const std::vector<std::size_t> ends = leaves(robot);
  if (!name && ends.size() > 1) {
    std::vector<std::string> names;
    for (const std::size_t link : ends) names.push_back(robot.links[link].name);
    faults.push_back("the robot ends in " + std::to_string(ends.size()) +
                     " links, choose one by `tip`: " + listed_names(std::move(names)));
  }
  return find_link(robot, name, ends.front(), faults);
}

namespace {

/// A joint's value by that of the one that mimics none, at the end of its leaders: factor * value +
/// offset.
struct Following {
  std::size_t leader = 0;
  double factor = 1, offset = 0;
};

Following following_of(const Robot& robot, std::size_t joint) {
  Following following{.leader = joint};
  while (const auto& mimic = robot.joints[following.leader].mimic) {
    following.offset += following.factor * mimic->offset;
    following.factor *= mimic->multiplier;
    following.leader = mimic->leader;
  }
  return following;
}

/// What joints that move together with this one say about its value, whichever of them leads.
std::optional<double> value_by_others(const Robot& robot, std::size_t joint,
                                      const std::vector<HeldJoint>& held) {
  const Following own = following_of(robot, joint);
  if (own.factor == 0) return own.offset;
  for (const HeldJoint& one : held) {
    const auto other = joint_named(robot, one.name);
    if (!other || *other == joint) continue;
    const Following following = following_of(robot, *other);
    if (following.leader != own.leader || following.factor == 0) continue;
    return own.factor * ((one.value - following.offset) / following.factor) + own.offset;
  }
  return std::nullopt;
}

std::string rounded(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Joints that move together are held where both can be, to the digits that are typed.
void check_held_together(const Robot& robot, const std::vector<HeldJoint>& held,
                         std::vector<std::string>& faults) {
  constexpr double kTyped = 1e-6;
  for (std::size_t k = 0; k < held.size(); ++k) {
    const auto joint = joint_named(robot, held[k].name);
    if (!joint) continue;
    const std::vector<HeldJoint> earlier(held.begin(),
                                         held.begin() + static_cast<std::ptrdiff_t>(k));
    const auto value = value_by_others(robot, *joint, earlier);
    if (!value || std::abs(*value - held[k].value) <= kTyped) continue;
    faults.push_back("`held`: joint '" + held[k].name +
                     "' moves together with others (mimic) and "
                     "stands at " +
                     rounded(*value) + " then");
  }
}

}  // namespace

void check_held(const Robot& robot, const std::vector<HeldJoint>& held,
                std::vector<std::string>& faults) {
  for (std::size_t k = 0; k < held.size(); ++k) {
    const std::string& name = held[k].name;
    const auto joint = joint_named(robot, name);
    if (!joint) {
      faults.push_back("`held`: there is no joint '" + name + "'" +
                       suggestion(name, names_of(robot.joints)));
    } else if (!is_moving(robot.joints[*joint])) {
      faults.push_back("`held`: joint '" + name + "' is fixed");
    }
    if (!is_workable(held[k].value))
      faults.push_back("`held` " + name + ": the value is too large");
    for (std::size_t j = 0; j < k; ++j) {
      if (held[j].name == name) faults.push_back("`held`: joint '" + name + "' is held twice");
    }
  }
  if (faults.empty()) check_held_together(robot, held, faults);
}

std::optional<double> held_value(const Robot& robot, std::size_t joint,
                                 const std::vector<HeldJoint>& held) {
  for (const HeldJoint& one : held) {
    if (one.name == robot.joints[joint].name) return one.value;
  }
  return value_by_others(robot, joint, held);
}

}  // namespace moivre
