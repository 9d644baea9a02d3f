// SPDX-License-Identifier: MIT
// Whole turns joint by joint, as the limits allow.
#include "moivre/arms/turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "moivre/arms/rules.h"
#include "moivre/numeric/invalid_input.h"
#include "tip.h"

namespace moivre {
namespace {

constexpr double kWholeTurn = 2 * std::numbers::pi;
// Distances that differ by less are one: two closures may share the joint that is farthest, and
// rounding is not to order them.
constexpr double kAlike = 1e-9;

/// Whole turns, the fewest and the most, with which a joint is between its limits.
struct TurnRange {
  double least = 0;
  double most = 0;
};

/// None for a joint that is beyond its limits, whatever turns are added.
std::optional<TurnRange> turns_of(const ArmJoint& joint, double value) {
  constexpr double kAtTheLimit = 1e-9;
  if (!joint.limits) return TurnRange{};
  const double slack = kAtTheLimit * std::max(1.0, std::abs(value));
  const double up = joint.limits->upper + slack - value;
  const double down = joint.limits->lower - slack - value;
  const TurnRange range =
      joint.is_slide ? TurnRange{}
                     : TurnRange{std::ceil(down / kWholeTurn), std::floor(up / kWholeTurn)};
  const bool is_within = joint.is_slide ? down <= 0 && up >= 0 : range.least <= range.most;
  return is_within ? std::optional(range) : std::nullopt;
}

}  // namespace

std::vector<std::size_t> place_in_limits(const Arm& arm, Eigen::VectorXd& values) {
  require_values(arm, values);
  std::vector<std::size_t> beyond;
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const ArmJoint& joint = arm.joints[k];
    double& value = values[static_cast<Eigen::Index>(k)];
    const auto range = turns_of(joint, value);
    if (range) {
      value += std::clamp(0.0, range->least, range->most) * kWholeTurn;
    } else {
      beyond.push_back(k);
    }
    const bool is_placed = joint.is_slide || (range && joint.limits);
    if (!is_placed) value = reduced_turn(value);
  }
  return beyond;
}

std::vector<Eigen::VectorXd> all_turns(const Arm& arm, const Eigen::VectorXd& values) {
  require_values(arm, values);
  std::vector<Eigen::VectorXd> all{values};
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const auto joint = static_cast<Eigen::Index>(k);
    const TurnRange range = turns_of(arm.joints[k], values[joint]).value_or(TurnRange{});
    if (static_cast<double>(all.size()) * (range.most - range.least + 1) > kMostChoicesOfTurns) {
      throw InvalidInput("the limits of " + arm.joints[k].name +
                         " allow more whole turns than can be listed: more than " +
                         std::to_string(kMostChoicesOfTurns) + " choices");
    }
    std::vector<Eigen::VectorXd> longer;
    for (const Eigen::VectorXd& before : all) {
      for (double turns = range.least; turns <= range.most; ++turns) {
        longer.push_back(before);
        longer.back()[joint] += turns * kWholeTurn;
      }
    }
    all = std::move(longer);
  }
  return all;
}

void require_few_turns(const Arm& arm) {
  // A joint at its lower limit has as many choices as any.
  Eigen::VectorXd values = Eigen::VectorXd::Zero(std::ssize(arm.joints));
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const ArmJoint& joint = arm.joints[k];
    if (joint.limits) values[static_cast<Eigen::Index>(k)] = joint.limits->lower;
  }
  all_turns(arm, values);
}

Eigen::VectorXd nearest_turns(const Arm& arm, const Eigen::VectorXd& values,
                              const Eigen::VectorXd& stands) {
  require_values(arm, values);
  require_standing(arm, stands);
  Eigen::VectorXd nearest = values;
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    if (arm.joints[k].is_slide) continue;
    const auto joint = static_cast<Eigen::Index>(k);
    const double wanted = std::round((stands[joint] - values[joint]) / kWholeTurn);
    const TurnRange range = turns_of(arm.joints[k], values[joint]).value_or(TurnRange{});
    const double turns =
        arm.joints[k].limits ? std::clamp(wanted, range.least, range.most) : wanted;
    nearest[joint] += turns * kWholeTurn;
  }
  return nearest;
}

double distance_from(const Arm& arm, const Eigen::VectorXd& values, const Eigen::VectorXd& stands) {
  require_values(arm, values);
  require_standing(arm, stands);
  double largest = 0;
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const auto joint = static_cast<Eigen::Index>(k);
    const double difference = std::abs(values[joint] - stands[joint]);
    largest = std::max(largest, arm.joints[k].is_slide ? difference / arm.length : difference);
  }
  return largest;
}

bool is_nearer(const Arm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b,
               const Eigen::VectorXd& stands) {
  const auto rank = [&](const Eigen::VectorXd& values) {
    return std::round(distance_from(arm, values, stands) / kAlike);
  };
  return rank(a) < rank(b);
}

void require_standing(const Arm& arm, const Eigen::VectorXd& stands) {
  if (stands.size() == std::ssize(arm.joints) && stands.allFinite()) return;
  throw InvalidInput("where the arm stands takes a finite value for each of its " +
                     std::to_string(arm.joints.size()) + " joints");
}

void sort_by_distance(const Arm& arm, const Eigen::VectorXd& stands,
                      std::vector<ArmClosure>& closures) {
  require_standing(arm, stands);
  for (ArmClosure& closure : closures) {
    closure.in_limits = nearest_turns(arm, closure.in_limits, stands);
  }
  std::stable_sort(closures.begin(), closures.end(), [&](const ArmClosure& a, const ArmClosure& b) {
    return is_nearer(arm, a.in_limits, b.in_limits, stands);
  });
}

}  // namespace moivre
