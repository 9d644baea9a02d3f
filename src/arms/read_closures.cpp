// SPDX-License-Identifier: MIT
// From roots to joint values, limits, letters and counts.
#include "read_closures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "moivre/expression/joined.h"
#include "moivre/mechanism/closure_id.h"
#include "moivre/numeric/invalid_input.h"
#include "polish.h"
#include "random_values.h"
#include "read_back.h"

namespace moivre {
namespace {

/// Roots that are nearer to real than this are tried as closures: double ones leave the real line by rounding.
constexpr double kNearlyReal = 1e-4;
/// Newton's method that goes farther has found another closure than the root's.
constexpr double kFarthest = 0.05;
/// Closures that are nearer are one; those of a double root are known to half the digits.
constexpr double kSameValue = 1e-9;
constexpr double kSameDoubled = 1e-6;

/// What was done instead of following paths in all joints.
LeftOut cut_told(const Arm& arm, const Cut& cut) {
  const std::string inside = names_of(arm, cut.inside);
  switch (cut.kind) {
    case CutKind::one:
      return {"paths", "the arm has one free joint: its value is read off"};
    case CutKind::two:
      return {"unknowns of " + inside, "what two neighbours can do is given by linear equations"};
    case CutKind::two_in_quadric:
      return {"unknowns of " + inside,
              "their axes meet or are parallel, or nearly: linear equations and a quadratic one"};
    case CutKind::three:
      break;
  }
  return {
      "paths of " + inside,
      "their axes meet in a point or are parallel: a group of motions, given by linear equations; "
      "its joints are then roots of a quadratic"};
}

/// Limits are kept modulo whole turns; a slide has none.
void place_in_limits(const Arm& arm, ArmClosure& closure) {
  constexpr double kRounding = 1e-9;
  constexpr double kTurn = 2 * std::numbers::pi;
  closure.in_limits = closure.values;
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const ArmJoint& joint = arm.joints[k];
    if (!joint.limits) continue;
    const auto i = static_cast<Eigen::Index>(k);
    const double slack = kRounding * std::max(1.0, std::abs(closure.values[i]));
    const double lower = joint.limits->lower - slack;
    const double upper = joint.limits->upper + slack;
    double value = closure.values[i];
    if (!joint.is_slide && value < lower) value += kTurn * std::ceil((lower - value) / kTurn);
    if (!joint.is_slide && value > upper) value -= kTurn * std::ceil((value - upper) / kTurn);
    if (value < lower || value > upper) {
      closure.beyond.push_back(k);
    } else {
      closure.in_limits[i] = value;
    }
  }
}

/// Turns in (-pi, pi], a half turn from either side as pi.
void reduce_turns(const Arm& arm, Eigen::VectorXd& values) {
  constexpr double kRounding = 1e-12;
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    if (arm.joints[k].is_slide) continue;
    double& value = values[static_cast<Eigen::Index>(k)];
    value = std::remainder(value, 2 * std::numbers::pi);
    if (value <= -std::numbers::pi + kRounding) value = std::numbers::pi;
  }
}

double distance(const Arm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double largest = 0;
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const double difference = a[static_cast<Eigen::Index>(k)] - b[static_cast<Eigen::Index>(k)];
    const double apart = arm.joints[k].is_slide ? difference / arm.length
                                                : std::remainder(difference, 2 * std::numbers::pi);
    largest = std::max(largest, std::abs(apart));
  }
  return largest;
}

/// The closure that the root means; nothing where it is not real.
std::optional<ArmClosure> closure_of(const Arm& arm, const Loop& loop,
                                     const Eigen::Isometry3d& pose, const Solution& solution,
                                     const LoopRoot& root) {
  if (root.imaginary > kNearlyReal) return std::nullopt;
  Eigen::VectorXd start(static_cast<Eigen::Index>(arm.joints.size()));
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    start[static_cast<Eigen::Index>(k)] = joint_value(loop, k, root.at[k]);
  }
  const Polished polished = polish(arm, pose, start);
  if (!(polished.residual <= kReach)) return std::nullopt;
  if (distance(arm, polished.values, start) > kFarthest) return std::nullopt;
  ArmClosure closure;
  closure.values = polished.values;
  closure.residual = polished.residual;
  closure.newton_iterations = polished.iterations;
  closure.smallest_singular_value = polished.smallest_singular_value;
  closure.weakest = weakest_motion(arm, polished);
  closure.path = solution.path;
  closure.multiplicity = solution.multiplicity;
  closure.singular = solution.singular;
  reduce_turns(arm, closure.values);
  place_in_limits(arm, closure);
  return closure;
}

/// Adds the closure, or its multiplicity to one that is there.
void add_closure(const Arm& arm, ArmClosure closure, std::vector<ArmClosure>& closures) {
  constexpr double kSingular = 1e-5;
  for (ArmClosure& other : closures) {
    const bool are_doubled = closure.smallest_singular_value < kSingular;
    const double reach = are_doubled ? kSameDoubled : kSameValue;
    if (distance(arm, closure.values, other.values) > reach) continue;
    other.multiplicity += closure.multiplicity;
    other.singular = true;
    return;
  }
  closures.push_back(std::move(closure));
}

/// Letters by values, larger first.
void name_closures(std::vector<ArmClosure>& closures) {
  constexpr double kGrid = 1e-6;
  const auto key = [](const ArmClosure& closure) {
    std::vector<long long> rounded;
    for (const double value : closure.values) rounded.push_back(std::llround(-value / kGrid));
    return rounded;
  };
  std::sort(closures.begin(), closures.end(),
            [&](const ArmClosure& a, const ArmClosure& b) { return key(a) < key(b); });
  for (std::size_t k = 0; k < closures.size(); ++k) closures[k].id = closure_id(k);
}

ArmMoves moves_from(const Arm& arm, const Polished& closure) {
  return {closure.values, closure.least_moving, weakest_motion(arm, closure).tip};
}

/// A pose of a set of closures that moves, from random starts.
std::optional<ArmMoves> find_moving(const Arm& arm, const Eigen::Isometry3d& pose,
                                    std::uint64_t seed) {
  constexpr std::uint64_t kTries = 60;
  for (std::uint64_t trial = 0; trial < kTries; ++trial) {
    Polished there = polish(arm, pose, random_joint_values(arm, seed, trial), true);
    if (there.residual > kReach || !can_move(arm, pose, there)) continue;
    reduce_turns(arm, there.values);
    return moves_from(arm, there);
  }
  return std::nullopt;
}

std::string message_of(const Arm& arm, const ArmResult& result) {
  if (!result.complete) return "some paths are undecided: closures may be missing";
  if (result.moves) return "the joints can move while the tip stands";
  if (!result.closures.empty()) return "every path was decided";
  return arm.joints.size() < 6 ? "the arm cannot hold this pose; with fewer than six free joints "
                                 "only some can be held"
                               : "the arm cannot hold this pose";
}

/// Everything that the roots mean.
void read_roots(const Arm& arm, const Loop& loop, const Cut& cut,
                const std::vector<Solution>& solutions, ArmResult& result) {
  std::vector<ArmClosure> moving;
  std::uint64_t roots = 0;
  for (const Solution& solution : solutions) {
    roots += solution.multiplicity;
    const ReadBack read = read_back(loop, cut, solution.x, solution.accuracy);
    if (read.roots.empty()) result.counts.rejected += solution.multiplicity;
    for (const LoopRoot& root : read.roots) {
      auto closure = closure_of(arm, loop, result.pose, solution, root);
      if (read.moves) {
        if (closure) moving.push_back(std::move(*closure));
        continue;
      }
      result.counts.complex += solution.multiplicity;
      if (closure) add_closure(arm, std::move(*closure), result.closures);
    }
  }
  for (const ArmClosure& closure : moving) {
    const Polished there = polish(arm, result.pose, closure.values);
    if (!can_move(arm, result.pose, there)) continue;
    result.moves = moves_from(arm, there);
    result.moves->values = closure.values;
    break;
  }
  // Every form of a general arm has two false roots for a true one at most: where there are more, true ones were not read back.
  if (arm.joints.size() == 6 && 3 * result.counts.rejected > 2 * roots) result.complete = false;
}

}  // namespace

std::string names_of(const Arm& arm, const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t k : joints) names.push_back(arm.joints[k].name);
  return joined(names, ", ");
}

void read_closures(const Arm& arm, const Loop& loop, const Cut& cut,
                   const std::vector<Solution>& solutions, ArmResult& result) {
  result.left_out.push_back(cut_told(arm, cut));
  read_roots(arm, loop, cut, solutions, result);
  if (result.paths.on_positive_dimensional > 0 && !result.moves) {
    result.moves = find_moving(arm, result.pose, result.seed);
  }
  name_closures(result.closures);
  result.counts.real = result.closures.size();
  for (const ArmClosure& closure : result.closures) {
    if (!closure.beyond.empty()) ++result.counts.beyond_limits;
  }
  result.message = message_of(arm, result);
}

}  // namespace moivre
