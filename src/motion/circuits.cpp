// SPDX-License-Identifier: MIT
// Branches are sorted into circuits and stretches; angles are summed along the joins.
#include "moivre/motion/circuits.h"

#include <algorithm>
#include <array>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "branch_joins.h"
#include "courses.h"
#include "moivre/numeric/invalid_input.h"
#include "motion_sentences.h"

namespace moivre {
namespace {

// Radians: an angle so near below a whole turn is 0.
constexpr double kZeroAngle = 1e-9;

using Parts = std::vector<std::vector<std::size_t>>;

/// Branches that the joins hold together, each part ascending, by the first of each.
Parts parts_of(std::size_t count, const std::vector<BranchJoin>& joins) {
  boost::disjoint_sets_with_storage<> sets(count);
  for (std::size_t k = 0; k < count; ++k) sets.make_set(k);
  for (const BranchJoin& join : joins) sets.union_set(join.ends[0].branch, join.ends[1].branch);
  std::map<std::size_t, std::size_t> number;  // of a set, by its representative
  Parts parts;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [at, is_new] = number.try_emplace(sets.find_set(k), parts.size());
    if (is_new) parts.emplace_back();
    parts[at->second].push_back(k);
  }
  return parts;
}

std::vector<BranchJoin> without_dead_points(std::vector<BranchJoin> joins) {
  std::erase_if(joins, [](const BranchJoin& join) { return join.kind == JoinKind::dead_point; });
  return joins;
}

/// How to go through a part: joins that lead to one branch after another, from the first on, and
/// those that close ways.
struct Ways {
  std::vector<std::array<BranchEnd, 2>> leading;
  std::vector<std::array<BranchEnd, 2>> closing;
};

Ways ways_through(const std::vector<std::size_t>& part, const std::vector<BranchJoin>& joins) {
  std::vector<std::array<BranchEnd, 2>> open;
  for (const BranchJoin& join : joins) {
    if (std::binary_search(part.begin(), part.end(), join.ends[0].branch)) {
      open.push_back(join.ends);
    }
  }
  std::set<std::size_t> reached{part.front()};
  Ways ways;
  while (!open.empty()) {
    std::vector<std::array<BranchEnd, 2>> later;
    for (auto [a, b] : open) {
      if (reached.count(a.branch) == 0) std::swap(a, b);
      if (reached.count(a.branch) == 0) {
        later.push_back({a, b});
      } else {
        (reached.insert(b.branch).second ? ways.leading : ways.closing).push_back({a, b});
      }
    }
    open = std::move(later);
  }
  return ways;
}

/// What turns or slides, and its course on each branch.
struct Measured {
  MovingPart part;
  double from = 0;  ///< where it may turn: its range begins within one turn from here
  std::vector<Course> on;
};

std::vector<Measured> measured(const MotionResult& motion, const std::vector<MovingPart>& parts) {
  std::vector<Measured> all;
  for (const MovingPart& part : parts) {
    all.push_back({part, -std::numbers::pi, {}});
    for (const MotionBranch& branch : motion.branches) {
      all.back().on.push_back(course(branch, part));
    }
  }
  return all;
}

std::vector<Measured> measured_drivers(const MotionResult& motion, const Mechanism& mechanism) {
  std::vector<Measured> all;
  for (const Driver& driver : mechanism.drivers) {
    all.push_back({{driver.name, kind_of(mechanism, driver), may_turn(mechanism, driver)}, 0, {}});
    for (const MotionBranch& branch : motion.branches) {
      all.back().on.push_back(driver_course(branch, driver));
    }
  }
  return all;
}

double value_at(const Course& course, const BranchEnd& end) {
  return end.is_last ? course.last : course.first;
}

/// What a quantity has more on each branch of a part than the branch's own course says, and how
/// often it turns on closed ways.
struct Unrolled {
  std::map<std::size_t, double> shift;
  int turns = 0;
};

Unrolled unrolled(const std::vector<std::size_t>& part, const Ways& ways,
                  const Measured& quantity) {
  Unrolled all;
  for (const std::size_t branch : part) all.shift[branch] = 0;
  if (!quantity.part.may_turn) return all;
  const auto turns_between = [&](const BranchEnd& a, const BranchEnd& b) {
    const double gap = value_at(quantity.on[a.branch], a) + all.shift[a.branch] -
                       value_at(quantity.on[b.branch], b) - all.shift[b.branch];
    return std::round(gap / kOneTurn);
  };
  for (const auto& [a, b] : ways.leading) all.shift[b.branch] = kOneTurn * turns_between(a, b);
  for (const auto& [a, b] : ways.closing) {
    all.turns = std::gcd(all.turns, static_cast<int>(turns_between(a, b)));
  }
  return all;
}

/// Brings the range to where its lower end is in [from, from + a turn).
void shift_to(Swing& swing, double from) {
  const double turns = std::floor((swing.lower - from + kZeroAngle) / kOneTurn);
  swing.lower -= kOneTurn * turns;
  swing.upper -= kOneTurn * turns;
}

Swing swing_over(const std::vector<std::size_t>& part, const Ways& ways, const Measured& quantity) {
  const Unrolled all = unrolled(part, ways, quantity);
  Swing swing{quantity.part.name, quantity.part.kind, all.turns, 0, 0};
  if (all.turns != 0) return swing;
  swing.lower = std::numeric_limits<double>::infinity();
  swing.upper = -swing.lower;
  for (const std::size_t branch : part) {
    const double shift = all.shift.at(branch);
    swing.lower = std::min(swing.lower, quantity.on[branch].lower + shift);
    swing.upper = std::max(swing.upper, quantity.on[branch].upper + shift);
  }
  if (quantity.part.may_turn) shift_to(swing, quantity.from);
  return swing;
}

std::vector<Swing> swings(const std::vector<std::size_t>& part, const Ways& ways,
                          const std::vector<Measured>& quantities) {
  std::vector<Swing> all;
  for (const Measured& quantity : quantities) all.push_back(swing_over(part, ways, quantity));
  return all;
}

/// Whether the driver goes both ways over the range.
bool turns_back(const Driver& driver, const MotionResult& motion) {
  bool is_up = false;
  bool is_down = false;
  for (std::size_t k = 1; k < motion.times.size(); ++k) {
    const double rise = driver_state(driver.law, motion.times[k]).value -
                        driver_state(driver.law, motion.times[k - 1]).value;
    is_up = is_up || rise > 0;
    is_down = is_down || rise < 0;
  }
  return is_up && is_down;
}

/// How many turns the farthest going driver goes; 0 where none turns.
double turns_of_drivers(const Mechanism& mechanism, const MotionResult& motion) {
  const std::vector<double> begin = driver_values(mechanism, motion.from);
  const std::vector<double> end = driver_values(mechanism, motion.to);
  double most = 0;
  for (std::size_t k = 0; k < begin.size(); ++k) {
    if (!may_turn(mechanism, mechanism.drivers[k])) continue;
    most = std::max(most, std::abs(end[k] - begin[k]) / kOneTurn);
  }
  return most;
}

// Of a turn: more than this over is more than one turn.
constexpr double kOver = 1e-6;

/// Everything that is known of a motion's branches and how they are joined.
class CircuitFinder {
 public:
  CircuitFinder(const Mechanism& mechanism, const MotionResult& motion)
      : mechanism_(mechanism),
        motion_(motion),
        drivers_(measured_drivers(motion, mechanism)),
        bodies_(measured(motion, body_quantities(mechanism))),
        joints_(measured(motion, joint_quantities(mechanism))),
        joins_(branch_joins(mechanism, motion)),
        smooth_joins_(without_dead_points(joins_)),
        stretches_(parts_of(motion.branches.size(), smooth_joins_)) {}

  Circuits find() const {
    Circuits found;
    found.joins = joins_;
    found.is_full_turn = drivers_return(mechanism_, motion_) &&
                         std::abs(turns_of_drivers(mechanism_, motion_) - 1) <= kOver;
    found.notes = notes();
    for (const std::vector<std::size_t>& part : parts_of(motion_.branches.size(), joins_)) {
      found.circuits.push_back(circuit_of_part(part));
    }
    const bool is_open = std::any_of(
        found.circuits.begin(), found.circuits.end(),
        [](const Circuit& circuit) { return circuit.driver_motion == DriverMotion::open; });
    if (found.is_full_turn && is_open && motion_.complete) {
      found.is_full_turn = false;
      found.notes.push_back(circuit_note(CircuitNote::turn_ends_in_other_poses));
    }
    return found;
  }

 private:
  Circuit circuit_of_part(const std::vector<std::size_t>& part) const {
    const Ways ways = ways_through(part, joins_);
    Circuit circuit;
    circuit.branches = part;
    circuit.drivers = swings(part, ways, drivers_);
    circuit.bodies = swings(part, ways, bodies_);
    circuit.joints = swings(part, ways, joints_);
    add_stretches(circuit);
    add_events(circuit);
    return circuit;
  }

  /// In each stretch the branches are ordered by where the first driver stands; what the driver
  /// does follows from them.
  void add_stretches(Circuit& circuit) const {
    bool turns = false;
    for (std::vector<std::size_t> part : stretches_) {
      if (!std::binary_search(circuit.branches.begin(), circuit.branches.end(), part.front())) {
        continue;
      }
      if (!drivers_.empty()) {
        const Measured& driver = drivers_.front();
        const Unrolled all = unrolled(part, ways_through(part, smooth_joins_), driver);
        turns = turns || all.turns != 0;
        std::stable_sort(part.begin(), part.end(), [&](std::size_t a, std::size_t b) {
          return driver.on[a].lower + all.shift.at(a) < driver.on[b].lower + all.shift.at(b);
        });
      }
      circuit.stretches.push_back(std::move(part));
    }
    const bool comes_round = !circuit.drivers.empty() && circuit.drivers.front().turns != 0;
    circuit.driver_motion = turns                   ? DriverMotion::turns
                            : comes_round           ? DriverMotion::turns_over_dead_points
                            : has_open_end(circuit) ? DriverMotion::open
                                                    : DriverMotion::rocks;
  }

  void add_events(Circuit& circuit) const {
    std::vector<std::size_t> events;
    for (const std::size_t k : circuit.branches) {
      for (const auto& event : {motion_.branches[k].begin_event, motion_.branches[k].end_event}) {
        if (event) events.push_back(*event);
      }
    }
    std::sort(events.begin(), events.end());
    events.erase(std::unique(events.begin(), events.end()), events.end());
    for (const std::size_t event : events) {
      const EventKind kind = motion_.events[event].at.kind;
      auto& list = kind == EventKind::dead_point    ? circuit.dead_points
                   : kind == EventKind::bifurcation ? circuit.change_points
                                                    : circuit.stops;
      list.push_back(event);
    }
  }

  bool has_open_end(const Circuit& circuit) const {
    return std::any_of(circuit.branches.begin(), circuit.branches.end(), [&](std::size_t k) {
      const MotionBranch& branch = motion_.branches[k];
      const auto is_open = [&](bool is_last) {
        const auto& event = is_last ? branch.end_event : branch.begin_event;
        const bool is_stopped = event && motion_.events[*event].at.kind == EventKind::joint_limit;
        return !is_stopped && !is_joined({k, is_last});
      };
      // A dead point where the motion begins is one place, though it is a branch with two ends.
      const bool is_moment = branch.begins == branch.ends;
      return is_moment ? is_open(false) && is_open(true) : is_open(false) || is_open(true);
    });
  }

  bool is_joined(const BranchEnd& end) const {
    return std::any_of(joins_.begin(), joins_.end(), [&](const BranchJoin& join) {
      return std::any_of(join.ends.begin(), join.ends.end(), [&](const BranchEnd& other) {
        return other.branch == end.branch && other.is_last == end.is_last;
      });
    });
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    if (!motion_.complete) {
      notes.push_back(circuit_note(CircuitNote::motion_incomplete));
    }
    if (motion_.checkpoints.empty()) {
      notes.push_back(circuit_note(CircuitNote::no_closures));
    }
    if (mechanism_.drivers.size() > 1) {
      notes.push_back(circuit_note(CircuitNote::drivers_move_together));
    }
    for (const Driver& driver : mechanism_.drivers) {
      if (!turns_back(driver, motion_)) continue;
      notes.push_back(turning_driver_note(driver.name));
    }
    if (turns_of_drivers(mechanism_, motion_) > 1 + kOver) {
      notes.push_back(circuit_note(CircuitNote::more_than_one_turn));
    } else if (!drivers_return(mechanism_, motion_)) {
      notes.push_back(circuit_note(CircuitNote::drivers_do_not_return));
    }
    return notes;
  }

  const Mechanism& mechanism_;
  const MotionResult& motion_;
  const std::vector<Measured> drivers_;
  const std::vector<Measured> bodies_;
  const std::vector<Measured> joints_;
  const std::vector<BranchJoin> joins_;
  const std::vector<BranchJoin> smooth_joins_;
  const Parts stretches_;
};

}  // namespace

std::string to_string(DriverMotion motion) {
  constexpr std::array<const char*, 4> kNames{"turns", "turns over dead points", "rocks", "open"};
  return kNames[static_cast<std::size_t>(motion)];
}

Circuits find_circuits(const Mechanism& mechanism, const MotionResult& motion) {
  const auto count = static_cast<Eigen::Index>(coordinates(mechanism).size());
  for (const MotionBranch& branch : motion.branches) {
    if (branch.begin_pose.size() == count && branch.end_pose.size() == count) continue;
    throw InvalidInput("branch " + branch.id + " is not one of this mechanism");
  }
  if (!motion.all_listed) {
    Circuits none;
    none.notes.push_back(circuit_note(CircuitNote::not_all_listed));
    return none;
  }
  return CircuitFinder(mechanism, motion).find();
}

}  // namespace moivre
