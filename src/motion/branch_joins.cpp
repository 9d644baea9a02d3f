// SPDX-License-Identifier: MIT
// Pairs of ends at events, and of last with first poses.
#include "branch_joins.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "moivre/closures/same_pose.h"
#include "motion_times.h"

namespace moivre {
namespace {

// Of a turn, or of the larger value: drivers that come back do so but for rounding.
constexpr double kBack = 1e-9;

bool comes_back(bool may_turn, double begin, double end) {
  const double gap = may_turn ? std::remainder(end - begin, 2 * std::numbers::pi) : end - begin;
  return std::abs(gap) <= kBack * std::max({1.0, std::abs(begin), std::abs(end)});
}

std::optional<std::size_t> event_at(const MotionResult& motion, const BranchEnd& end) {
  const MotionBranch& branch = motion.branches[end.branch];
  return end.is_last ? branch.end_event : branch.begin_event;
}

/// Of branches that end at such an event; nullopt: a stop joins none.
std::optional<JoinKind> join_kind(EventKind kind) {
  if (kind == EventKind::joint_limit) return std::nullopt;
  return kind == EventKind::dead_point ? JoinKind::dead_point : JoinKind::bifurcation;
}

/// All pairs of ends at one event.
void join_at_events(const MotionResult& motion, std::vector<BranchJoin>& joins) {
  std::vector<std::vector<BranchEnd>> ends(motion.events.size());
  for (std::size_t k = 0; k < motion.branches.size(); ++k) {
    for (const bool is_last : {false, true}) {
      const BranchEnd end{k, is_last};
      if (const auto event = event_at(motion, end)) ends[*event].push_back(end);
    }
  }
  for (std::size_t event = 0; event < ends.size(); ++event) {
    const auto kind = join_kind(motion.events[event].at.kind);
    for (std::size_t a = 0; kind && a < ends[event].size(); ++a) {
      for (std::size_t b = a + 1; b < ends[event].size(); ++b) {
        joins.push_back({*kind, {ends[event][a], ends[event][b]}});
      }
    }
  }
}

/// The kind of a join over the turn; nullopt where a stop is in the way.
std::optional<JoinKind> kind_over_turn(const MotionResult& motion, const BranchEnd& last,
                                       const BranchEnd& first) {
  std::optional<JoinKind> kind = JoinKind::turn;
  for (const BranchEnd& end : {last, first}) {
    const auto event = event_at(motion, end);
    if (event && kind) kind = join_kind(motion.events[*event].at.kind);
  }
  return kind;
}

void join_over_turn(const Mechanism& mechanism, const MotionResult& motion,
                    std::vector<BranchJoin>& joins) {
  const Phi phi(mechanism);
  const double width = kSameTime * (motion.to - motion.from);
  const std::vector<std::size_t> firsts = first_branches(motion);
  for (std::size_t k = 0; k < motion.branches.size(); ++k) {
    const MotionBranch& branch = motion.branches[k];
    if (branch.ends < motion.to - width) continue;
    const BranchEnd last{k, true};
    for (const std::size_t first : firsts) {
      const auto kind = kind_over_turn(motion, last, {first, false});
      if (!kind) continue;
      const double apart = distance(phi, branch.end_pose, motion.branches[first].begin_pose);
      if (apart <= (*kind == JoinKind::turn ? kSamePose : kSamePlace)) {
        joins.push_back({*kind, {last, {first, false}}});
      }
    }
  }
}

}  // namespace

bool may_turn(const Mechanism& mechanism, const Driver& driver) {
  if (driver.kind != DriverKind::unknown) return driver.kind == DriverKind::angle;
  return coordinates(mechanism)[driver.unknown].is_periodic;
}

bool drivers_return(const Mechanism& mechanism, const MotionResult& motion) {
  for (const Equation& equation : mechanism.equations) {
    if (depends_on_time(equation.formula)) return false;
  }
  const std::vector<double> begin = driver_values(mechanism, motion.from);
  const std::vector<double> end = driver_values(mechanism, motion.to);
  for (std::size_t k = 0; k < begin.size(); ++k) {
    if (!comes_back(may_turn(mechanism, mechanism.drivers[k]), begin[k], end[k])) return false;
  }
  return !begin.empty();
}

std::vector<BranchJoin> branch_joins(const Mechanism& mechanism, const MotionResult& motion) {
  std::vector<BranchJoin> joins;
  join_at_events(motion, joins);
  if (drivers_return(mechanism, motion)) join_over_turn(mechanism, motion, joins);
  return joins;
}

}  // namespace moivre
