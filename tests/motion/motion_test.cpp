// SPDX-License-Identifier: MIT
// Is every closure followed, on its own branch, to where that ends, and is an exchange of branches
// found out?
#include "moivre/motion/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "../mechanism/in_unit.h"
#include "gap.h"
#include "mechanisms.h"
#include "moivre/tracker/session.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::gap;
using test::kDegree;

constexpr double kDriverValue = 1e-10;  // radians: how exactly events are located

MotionOptions options_for(const Mechanism& mechanism, int steps = 60, std::uint64_t seed = 1) {
  MotionOptions options;
  options.to = natural_duration(mechanism);
  options.steps = steps;
  options.solve.seed = seed;
  options.solve.threads = 1;
  return options;
}

MotionResult motion_of(const Mechanism& mechanism, const MotionOptions& options) {
  return find_motion(mechanism, *make_cvode_tracker(), options);
}

void expect_whole(const MotionResult& result, const Mechanism& mechanism) {
  EXPECT_TRUE(result.complete) << result.message;
  for (const std::string& failure : result.failures) ADD_FAILURE() << failure;
  for (const Checkpoint& checkpoint : result.checkpoints) {
    EXPECT_TRUE(checkpoint.agrees) << checkpoint.time << ": " << checkpoint.message;
  }
  const Phi phi(mechanism);
  for (std::size_t k = 0; k < result.branches.size(); ++k) {
    const MotionBranch& branch = result.branches[k];
    for (const BranchSample& sample : branch.samples) {
      EXPECT_GE(sample.time, branch.begins);
      EXPECT_LE(sample.time, branch.ends);
      EXPECT_LE(sample.residual, 1e-12) << "branch " << branch.id << ", t = " << sample.time;
    }
    EXPECT_TRUE(branch.begin_event || branch.begins == result.from) << branch.id;
    EXPECT_TRUE(branch.end_event || branch.ends == result.to) << branch.id;
  }
}

const Checkpoint& checkpoint_at(const MotionResult& result, double time) {
  return *std::min_element(result.checkpoints.begin(), result.checkpoints.end(),
                           [&](const Checkpoint& a, const Checkpoint& b) {
                             return std::abs(a.time - time) < std::abs(b.time - time);
                           });
}

std::vector<double> event_drivers(const MotionResult& result) {
  std::vector<double> values;
  for (const MotionEvent& event : result.events) values.push_back(event.drivers.at(0));
  return values;
}

TEST(Motion, FourBarsTwoClosuresGoRoundAndComeBackToThemselves) {
  const Mechanism m = mechanism_file("four-bar");
  const MotionResult result = motion_of(m, options_for(m));
  expect_whole(result, m);
  ASSERT_EQ(result.branches.size(), 2U);
  EXPECT_TRUE(result.events.empty());
  EXPECT_EQ(result.branches[0].id, "A");
  EXPECT_EQ(result.branches[1].id, "B");
  for (const MotionBranch& branch : result.branches) {
    ASSERT_EQ(branch.samples.size(), 61U);
    EXPECT_LE(gap(m, branch.samples.front().q, branch.samples.back().q), 1e-9);
  }
  const ClosureResult start = closures_of(m);
  EXPECT_LE(gap(m, result.branches[0].samples[0].q, start.closures[0].q), 1e-9);
  EXPECT_LE(gap(m, result.branches[1].samples[0].q, start.closures[1].q), 1e-9);
}

TEST(Motion, NortonsBothBranchesHaveThePublishedRates) {
  constexpr double kSixDecimals = 5e-6;
  const Mechanism m = mechanism_file("four-bar");
  const MotionResult result = motion_of(m, options_for(m, 10));
  ASSERT_EQ(result.branches.size(), 2U);
  for (const MotionBranch& branch : result.branches) {
    const BranchSample& first = branch.samples.front();
    const bool is_open = first.q[5] > 0;
    EXPECT_NEAR(first.q[5] / kDegree, is_open ? 20.2979 : -60.9780, 1e-4);
    EXPECT_NEAR(first.q[8] / kDegree, is_open ? 57.3249 : -98.0050, 1e-4);
    EXPECT_NEAR(first.velocity[5], is_open ? -4.120914 : -9.258772, kSixDecimals);
    EXPECT_NEAR(first.velocity[8], is_open ? 6.997985 : -20.377672, kSixDecimals);
    EXPECT_NEAR(first.acceleration[5], is_open ? 296.089193 : 597.622400, kSixDecimals);
    EXPECT_NEAR(first.acceleration[8], is_open ? 470.133530 : 423.578063, kSixDecimals);
  }
}

TEST(Motion, JansenLegHasEightEightSixEightRealClosuresAndItsBranchesEndInPairs) {
  const Mechanism m = mechanism_file("jansen-leg");
  for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{3}}) {
    const MotionResult result = motion_of(m, options_for(m, 60, seed));
    expect_whole(result, m);
    const std::uint64_t real[] = {8, 8, 6, 8};
    for (std::size_t k = 0; k < 4; ++k) {
      const Checkpoint& checkpoint = checkpoint_at(result, 1.5 * static_cast<double>(k));
      EXPECT_NEAR(checkpoint.drivers.at(0) / kDegree, 90.0 * static_cast<double>(k), 1e-9);
      EXPECT_EQ(checkpoint.counts.real, real[k]) << "seed " << seed;
      EXPECT_EQ(checkpoint.counts.complex, 8U) << "seed " << seed;
    }
    ASSERT_EQ(result.branches.size(), 12U) << "seed " << seed;
    ASSERT_EQ(result.events.size(), 4U) << "seed " << seed;
    for (const MotionEvent& event : result.events) {
      EXPECT_EQ(event.at.kind, EventKind::dead_point);
      EXPECT_EQ(event.ending.size() + event.beginning.size(), 2U);
    }
  }
}

TEST(Motion, JansenLegsDeadPointsAreThoseOfItsLastDyad) {
  // Branches meet where D and C are as far apart as f + g; the first two dyads turn all the way
  // round.
  const Mechanism m = mechanism_file("jansen-leg");
  const MotionResult result = motion_of(m, options_for(m));
  const auto body = [&](const std::string& name) {
    for (std::size_t k = 1; k < m.bodies.size(); ++k) {
      if (m.bodies[k].name == name) return static_cast<Eigen::Index>(3 * (k - 1));
    }
    return Eigen::Index{-1};
  };
  for (const MotionEvent& event : result.events) {
    const VectorXd& q = event.at.q;
    const double turn = q[body("lower") + 2] - q[body("link_f") + 2];
    EXPECT_NEAR(std::sin(turn), 0, 1e-8) << "driver " << event.drivers[0] / kDegree;
  }
}

TEST(Motion, OffsetSliderCranksTwoRangesAreBothFound) {
  // b sin(phi1) lies between r - a and r + a twice a turn; the second range lies between two
  // checkpoints.
  const Mechanism m = mechanism_file("slider-crank");
  const MotionResult result = motion_of(m, options_for(m));
  expect_whole(result, m);
  const double low = std::asin(0.2), high = std::asin(0.6), pi = std::numbers::pi;
  const double expected[] = {high, pi - high, pi - low, 2 * pi + low};
  const std::vector<double> found = event_drivers(result);
  ASSERT_EQ(found.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found[k], expected[k], kDriverValue);
  EXPECT_EQ(result.branches.size(), 6U);
  EXPECT_EQ(result.events[1].beginning, (std::vector<std::string>{"C", "D"}));
  EXPECT_EQ(result.events[2].ending, (std::vector<std::string>{"C", "D"}));
}

TEST(Motion, ParallelogramBifurcatesAtBothChangePoints) {
  Mechanism m = mechanism_file("parallelogram");
  m.drivers[0].law = Parabola{60 * kDegree, 60 * kDegree, 0};
  const MotionResult result = motion_of(m, options_for(m));
  expect_whole(result, m);
  ASSERT_EQ(result.events.size(), 2U);
  EXPECT_EQ(result.branches.size(), 6U);
  const double turns[] = {1, 2};
  for (std::size_t k = 0; k < 2; ++k) {
    const MotionEvent& event = result.events[k];
    EXPECT_EQ(event.at.kind, EventKind::bifurcation);
    EXPECT_NEAR(event.drivers[0], turns[k] * std::numbers::pi, kDriverValue);
    EXPECT_EQ(event.ending.size(), 2U);
    EXPECT_EQ(event.beginning.size(), 2U);
  }
}

TEST(Motion, StartAtAChangePointBeginsTheBranchesThere) {
  const Mechanism m = mechanism_file("parallelogram");
  const MotionResult result = motion_of(m, options_for(m));
  expect_whole(result, m);
  ASSERT_FALSE(result.events.empty());
  EXPECT_NEAR(result.events[0].drivers[0], 0, kDriverValue);
  EXPECT_TRUE(result.events[0].ending.empty());
  EXPECT_EQ(result.events[0].beginning, (std::vector<std::string>{"A", "B"}));
}

TEST(Motion, DoubleParallelCrankBifurcatesAtTheLineAndGoesOnAfterIt) {
  const Mechanism m = mechanism_file("double-parallel-crank");
  const MotionResult result = motion_of(m, options_for(m));
  expect_whole(result, m);
  ASSERT_EQ(result.events.size(), 2U);
  EXPECT_NEAR(result.events[0].drivers[0], std::numbers::pi, kDriverValue);
  EXPECT_NEAR(result.events[1].drivers[0], 2 * std::numbers::pi, kDriverValue);
  for (const MotionBranch& branch : result.branches) {
    for (const BranchSample& sample : branch.samples) {
      EXPECT_NEAR(sample.velocity[5], 60 * kDegree, 1e-10);
      EXPECT_NEAR(sample.acceleration[5], 0, 1e-9);
    }
  }
}

TEST(Motion, EverySampleIsAClosureSolvedAfresh) {
  for (const std::string name : {"four-bar", "stephenson-3", "whitworth", "gear-five-bar"}) {
    const Mechanism m = mechanism_file(name);
    for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{7}}) {
      const MotionResult result = motion_of(m, options_for(m, 9, seed));
      expect_whole(result, m);
      for (const double time : result.times) {
        const ClosureResult afresh = closures_of(m, seed + 1, time);
        std::size_t present = 0;
        for (const MotionBranch& branch : result.branches) {
          for (const BranchSample& sample : branch.samples) {
            if (sample.time != time) continue;
            ++present;
            double least = 1;
            for (const Closure& closure : afresh.closures) {
              least = std::min(least, gap(m, sample.q, closure.q));
            }
            EXPECT_LE(least, 1e-9) << name << ", branch " << branch.id << ", t = " << time;
          }
        }
        EXPECT_EQ(present, afresh.closures.size()) << name << ", t = " << time;
      }
    }
  }
}

/// Follows faithfully with shortened steps; with the first ones it leaves branch `from` for `to`
/// halfway, and back the same way.
/// `both`: and `to` for `from`.
struct Exchange {
  VectorXd from, to;
  bool both = false;

  Branch operator()(const Mechanism& m, const VectorXd& q0, const std::vector<double>& times,
                    const BranchOptions& options, const std::atomic<bool>& stop) const {
    Branch own = follow_branch(m, q0, times, options, stop);
    const bool is_first = options.largest_turn_rad == BranchOptions{}.largest_turn_rad;
    const bool leaves = gap(m, q0, from) < 1e-6 || (both && gap(m, q0, to) < 1e-6);
    if (!is_first || !leaves || times.front() != 0) return own;
    const Branch other =
        follow_branch(m, gap(m, q0, from) < 1e-6 ? to : from, times, options, stop);
    for (std::size_t k = times.size() / 2; k < times.size(); ++k) own.samples[k] = other.samples[k];
    return own;
  }
};

TEST(Motion, TheUnitOfLengthChangesNoEventAndNoBranch) {
  for (const char* name : {"stephenson-3", "double-parallel-crank", "whitworth", "rssr"}) {
    const Mechanism m = mechanism_file(name);
    const MotionResult expected = motion_of(m, options_for(m, 12));
    for (const double unit : {1e-10, 3e6}) {
      SCOPED_TRACE(std::string(name) + " in " + std::to_string(unit));
      const Mechanism same = test::in_unit(m, unit);
      const MotionResult result = motion_of(same, options_for(same, 12));
      EXPECT_EQ(result.complete, expected.complete) << result.message;
      ASSERT_EQ(result.branches.size(), expected.branches.size());
      ASSERT_EQ(result.events.size(), expected.events.size());
      for (std::size_t k = 0; k < result.events.size(); ++k) {
        EXPECT_EQ(result.events[k].at.kind, expected.events[k].at.kind);
        EXPECT_NEAR(result.events[k].at.time, expected.events[k].at.time, 1e-9);
      }
      for (const MotionBranch& branch : result.branches) {
        for (const BranchSample& sample : branch.samples) EXPECT_LE(sample.residual, 1e-12);
      }
    }
  }
}

TEST(Motion, PlantedExchangeOfBranchesIsFoundOutAndRepaired) {
  const Mechanism m = mechanism_file("four-bar");
  const MotionResult expected = motion_of(m, options_for(m));
  for (const bool both : {false, true}) {
    MotionOptions options = options_for(m);
    options.follow =
        Exchange{expected.branches[0].samples[0].q, expected.branches[1].samples[0].q, both};
    const MotionResult result = motion_of(m, options);
    expect_whole(result, m);
    ASSERT_EQ(result.branches.size(), 2U);
    EXPECT_GT(result.branches[0].retracked, 0);
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::size_t i = 0; i < 61; ++i) {
        EXPECT_LE(gap(m, result.branches[k].samples[i].q, expected.branches[k].samples[i].q), 1e-9);
      }
    }
  }
}

TEST(Motion, ExchangeThatCannotBeRepairedIsSaid) {
  const Mechanism m = mechanism_file("four-bar");
  const MotionResult expected = motion_of(m, options_for(m));
  const Exchange exchange{expected.branches[0].samples[0].q, expected.branches[1].samples[0].q,
                          true};
  MotionOptions options = options_for(m);
  options.follow = [&](const Mechanism& of, const VectorXd& q0, const std::vector<double>& times,
                       const BranchOptions&,
                       const std::atomic<bool>& stop) { return exchange(of, q0, times, {}, stop); };
  const MotionResult result = motion_of(m, options);
  EXPECT_FALSE(result.complete);
  EXPECT_FALSE(result.failures.empty());
}

/// Follows branches as always, and moves their events in time by less than these are known to, in
/// turns by `shift` and not at all.
struct RoundedOtherwise {
  double shift;
  int calls = 0;

  Branch operator()(const Mechanism& mechanism, const VectorXd& q0,
                    const std::vector<double>& times, const BranchOptions& options,
                    const std::atomic<bool>& stop) {
    Branch branch = follow_branch(mechanism, q0, times, options, stop);
    if (branch.event && ++calls % 2 == 0) branch.event->time += shift;
    return branch;
  }
};

TEST(Motion, RoundingDoesNotChangeTheNamesOfBranchesThatBeginTogether) {
  const Mechanism m = mechanism_file("jansen-leg");
  const MotionResult expected = motion_of(m, options_for(m));
  for (const double shift : {1e-12, -1e-12}) {
    MotionOptions options = options_for(m);
    options.follow = RoundedOtherwise{shift};
    const MotionResult result = motion_of(m, options);
    ASSERT_EQ(result.branches.size(), expected.branches.size());
    for (std::size_t k = 0; k < result.branches.size(); ++k) {
      EXPECT_LE(gap(m, result.branches[k].end_pose, expected.branches[k].end_pose), 1e-4)
          << "branch " << result.branches[k].id << ", shifted by " << shift;
    }
  }
}

TEST(Motion, BranchThatIsFoundAtTheLastCheckpointSaysHowItEnded) {
  const Mechanism m = mechanism_file("jansen-leg");
  MotionOptions options = options_for(m);
  options.checkpoints = 1;
  for (const MotionBranch& branch : motion_of(m, options).branches) {
    EXPECT_EQ(branch.message, branch.end_event ? "dead point" : "followed to the end") << branch.id;
  }
}

TEST(Motion, LongStepsDoNotChangeTheBranches) {
  // Steps that may turn by anything and miss by anything: the samples and the checkpoints hold
  // them.
  const Mechanism m = mechanism_file("jansen-leg");
  const MotionResult expected = motion_of(m, options_for(m));
  MotionOptions options = options_for(m, 2);
  options.checkpoints = 8;
  options.branch.largest_turn_rad = std::numbers::pi;
  options.branch.largest_miss = 1e3;
  options.branch.longest_step = 50;
  options.branch.largest_approach = 1e3;
  const MotionResult result = motion_of(m, options);
  expect_whole(result, m);
  ASSERT_EQ(result.branches.size(), expected.branches.size());
  for (std::size_t k = 0; k < result.branches.size(); ++k) {
    EXPECT_NEAR(result.branches[k].ends, expected.branches[k].ends, 1e-9);
    if (result.branches[k].end_event || result.branches[k].begin_event) continue;
    EXPECT_LE(gap(m, result.branches[k].samples.back().q, expected.branches[k].samples.back().q),
              1e-8)
        << result.branches[k].id;
  }
}

TEST(Motion, ResultIsTheSameForEveryNumberOfThreadsAndSeed) {
  const Mechanism m = mechanism_file("stephenson-3");
  MotionOptions one = options_for(m, 5);
  MotionOptions four = one;
  four.solve.threads = 4;
  const MotionResult a = motion_of(m, one);
  const MotionResult b = motion_of(m, four);
  ASSERT_EQ(a.branches.size(), b.branches.size());
  for (std::size_t k = 0; k < a.branches.size(); ++k) {
    EXPECT_EQ(a.branches[k].samples.back().q, b.branches[k].samples.back().q);
  }
  const MotionResult other = motion_of(m, options_for(m, 5, 11));
  ASSERT_EQ(other.events.size(), a.events.size());
  for (std::size_t k = 0; k < a.events.size(); ++k) {
    EXPECT_NEAR(other.events[k].drivers[0], a.events[k].drivers[0], kDriverValue);
  }
}

TEST(Motion, BranchLeavesAndComesBackThroughAJointsLimit) {
  Mechanism m = mechanism_file("four-bar");
  m.joints.at(3).limits = Limits{-100 * kDegree, 0};
  const MotionResult result = motion_of(m, options_for(m));
  expect_whole(result, m);
  ASSERT_EQ(result.events.size(), 2U);
  EXPECT_EQ(result.branches.size(), 2U);
  for (const MotionEvent& event : result.events) {
    EXPECT_EQ(event.at.kind, EventKind::joint_limit);
    EXPECT_NEAR(event.at.q[8], 100 * kDegree, 1e-9);
  }
}

TEST(Motion, EquationsOfHalfAnglesAreFollowedBeyondATurn) {
  const Mechanism m = mechanism_text(
      "[unknowns]\nangles = [\"a\", \"b\"]\n[equations]\ne = \"cos(b/2) - 0.8*cos(a)\"\n"
      "[[driver]]\nunknown = \"a\"\nstart = 0.7\nvelocity = 0.1\n[guess]\nb = 8\n");
  const MotionResult result = follow_guesses(m, {initial_guess(m)}, options_for(m, 4));
  ASSERT_EQ(result.branches.size(), 1U) << result.message;
  for (const BranchSample& sample : result.branches[0].samples) {
    EXPECT_GT(sample.q[1], 2 * std::numbers::pi);
    EXPECT_NEAR(std::cos(sample.q[1] / 2), 0.8 * std::cos(sample.q[0]), 1e-12);
  }
}

// The links of a stretched toggle pass through the line as slowly as the square of the time:
// branches touch.
TEST(Motion, BranchesThatTouchMeetInOneEvent) {
  const Mechanism m = mechanism_text(test::toggle_text("2 - (t - 1.1)^4"));
  MotionOptions options = options_for(m, 20);
  options.to = 2;
  const MotionResult result = motion_of(m, options);
  expect_whole(result, m);
  ASSERT_EQ(result.events.size(), 1U);
  EXPECT_EQ(result.events[0].ending.size(), 2U);
  EXPECT_EQ(result.events[0].beginning.size(), 2U);
  constexpr double kLocated = 1e-5;
  EXPECT_NEAR(result.events[0].at.time, 1.1, kLocated);
}

TEST(Motion, UnassemblableMechanismHasNoBranches) {
  const Mechanism m = mechanism_file("unassemblable-triangle");
  const MotionResult result = motion_of(m, options_for(m, 3));
  EXPECT_TRUE(result.complete);
  EXPECT_TRUE(result.branches.empty());
  for (const Checkpoint& checkpoint : result.checkpoints) {
    EXPECT_EQ(checkpoint.counts.real, 0U);
    EXPECT_EQ(checkpoint.counts.complex, 2U);
  }
}

TEST(Motion, WithoutDriversAFreeMechanismMoves) {
  Mechanism m = mechanism_file("four-bar");
  m.drivers.clear();
  const MotionResult result = motion_of(m, options_for(m, 3));
  EXPECT_TRUE(result.branches.empty());
  EXPECT_EQ(
      result.message,
      "moves: the closures form a set of positive dimension; there is no driver that holds it");
}

TEST(Motion, FromGuessesNoPolynomialIsSolved) {
  const Mechanism m = mechanism_file("rssr");
  const VectorXd guess = initial_guess(m);
  const MotionResult result = follow_guesses(m, {guess, guess}, options_for(m));
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.branches.size(), 1U);
  EXPECT_EQ(result.branches[0].samples.size(), 61U);
  EXPECT_EQ(result.paths.tracked, 0U);
  EXPECT_TRUE(result.checkpoints.empty());
}

TEST(Motion, SpatialBranchesAreThoseOfTheClosuresAtEveryCheckpoint) {
  for (const auto& [file, branches] :
       {std::pair<std::string, std::size_t>{"rssr", 2}, {"bennett", 1}}) {
    const Mechanism m = mechanism_file(file);
    const MotionResult result = motion_of(m, options_for(m));
    EXPECT_TRUE(result.complete) << file << ": " << result.message;
    EXPECT_EQ(result.branches.size(), branches) << file;
    for (const Checkpoint& checkpoint : result.checkpoints) {
      EXPECT_TRUE(checkpoint.agrees) << file << ": " << checkpoint.message;
    }
  }
}

TEST(Motion, GuessThatDoesNotAssembleIsAFailureOfItsOwn) {
  const Mechanism m = mechanism_file("unassemblable-triangle");
  const MotionResult result = follow_guesses(m, {initial_guess(m)}, options_for(m, 3));
  EXPECT_FALSE(result.complete);
  ASSERT_EQ(result.failures.size(), 1U);
  EXPECT_EQ(result.failures[0], "guess 1: Newton-Raphson not converged after 50 steps");
}

TEST(Motion, InterruptedRunIsNotComplete) {
  const Mechanism m = mechanism_file("four-bar");
  const std::atomic<bool> stop{true};
  const MotionResult result = find_motion(m, *make_cvode_tracker(), options_for(m, 3), stop);
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.message, "interrupted: what is finished is reported");
}

TEST(Motion, WrongOptionsAreRefusedAllAtOnce) {
  MotionOptions options;
  options.to = options.from;
  options.steps = 0;
  options.checkpoints = -1;
  EXPECT_EQ(validate(options).size(), 3U);
  EXPECT_THROW(motion_of(mechanism_file("four-bar"), options), std::invalid_argument);
}

TEST(Motion, NaturalDurationIsOneTurn) {
  Mechanism m = mechanism_file("parallelogram");
  EXPECT_NEAR(natural_duration(m), 6, 1e-12);
  m.drivers[0].law = Parabola{0, -2, -1};
  const double duration = natural_duration(m, 1);
  EXPECT_NEAR(driver_values(m, 1 + duration)[0] - driver_values(m, 1)[0], -2 * std::numbers::pi,
              1e-12);
  m.drivers[0].law = natural_spline({0, 1, 3}, {0, 1, 2});
  EXPECT_NEAR(natural_duration(m, 1), 2, 1e-12);
  m.drivers.clear();
  EXPECT_EQ(natural_duration(m), 1);
}

/// Crank of 1, coupler of 1.5, pivots 4 apart: with a rocker of 1.5 it closes at the crank's angle
/// 0 alone.
std::string nearly_too_short(const std::string& rocker) {
  return R"([units]
angle = "rad"
[ground.points]
A = [0, 0]
D = [4, 0]
[body.crank.points]
A = [0, 0]
B = [1, 0]
[body.coupler.points]
B = [0, 0]
C = [1.5, 0]
[body.rocker.points]
D = [0, 0]
C = [)" + rocker +
         R"(, 0]
[[joint]]
type = "revolute"
at = ["ground.A", "crank.A"]
[[joint]]
type = "revolute"
at = ["crank.B", "coupler.B"]
[[joint]]
type = "revolute"
at = ["coupler.C", "rocker.C"]
[[joint]]
type = "revolute"
at = ["ground.D", "rocker.D"]
[[driver]]
angle = "crank"
start = -1.03
velocity = 1
)";
}

MotionResult motion_past_the_instant(const Mechanism& m) {
  MotionOptions options = options_for(m, 50);
  options.to = 2;
  return motion_of(m, options);
}

TEST(Motion, BranchesThatLiveForAMillionthOfTheMotionAreFoundWhereComplexClosuresComeNearToReal) {
  for (const std::string rocker : {"1.501", "1.50001", "1.5000001", "1.50000000001"}) {
    const Mechanism m = mechanism_text(nearly_too_short(rocker));
    const MotionResult result = motion_past_the_instant(m);
    expect_whole(result, m);
    ASSERT_EQ(result.branches.size(), 2U) << rocker;
    ASSERT_EQ(result.events.size(), 2U) << rocker;
    // The pivots' distance, 17 - 8 cos(phi) squared, is coupler and rocker stretched.
    const double stretched = 1.5 + std::stod(rocker);
    const double crank = std::acos((17 - stretched * stretched) / 8);
    for (const MotionEvent& event : result.events) {
      EXPECT_EQ(event.at.kind, EventKind::dead_point);
      EXPECT_NEAR(std::abs(event.drivers.at(0)), crank, 1e-4 * crank) << rocker;
    }
  }
}

TEST(Motion, APoseForAnInstantIsNoBranchButSaid) {
  const MotionResult result = motion_past_the_instant(mechanism_text(nearly_too_short("1.5")));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_TRUE(result.branches.empty());
  EXPECT_TRUE(std::any_of(result.left_out.begin(), result.left_out.end(), [](const LeftOut& out) {
    return out.what == "closures at t = 1.030000 s";
  }));
}

TEST(Motion, ClosuresThatStayComplexAreSolvedAFewTimesMore) {
  const MotionResult result = motion_past_the_instant(mechanism_text(nearly_too_short("1.499")));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_TRUE(result.branches.empty());
  EXPECT_LE(result.paths.tracked, 2 * (65 + 8));
}

/// Every segment is told to have failed.
class FailingSource : public SegmentSource {
 public:
  explicit FailingSource(SegmentSource& source) : source_(source) {}
  std::optional<PathSegment> next() override { return source_.next(); }
  void arrived(const PathSegment& segment, SegmentResult&& reached) override {
    reached.status = SegmentStatus::step_too_small;
    source_.arrived(segment, std::move(reached));
  }

 private:
  SegmentSource& source_;
};

/// CVODE, whose sessions fail from number `limit` on.
class TiringTracker : public Tracker {
 public:
  explicit TiringTracker(int limit) : limit_(limit) {}
  std::string kind() const override { return inner_->kind(); }
  OptionsInForce options_in_force() const override { return {}; }
  std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const override {
    class Session : public TrackerSession {
     public:
      explicit Session(std::unique_ptr<TrackerSession> inner) : inner_(std::move(inner)) {}
      void run(SegmentSource& source, const std::atomic<bool>& stop) noexcept override {
        FailingSource failing(source);
        inner_->run(failing, stop);
      }

     private:
      std::unique_ptr<TrackerSession> inner_;
    };
    auto session = inner_->open(homotopy);
    if (opened++ < limit_) return session;
    return std::make_unique<Session>(std::move(session));
  }

  mutable std::atomic<int> opened{0};

 private:
  std::unique_ptr<Tracker> inner_ = make_cvode_tracker();
  int limit_;
};

TEST(Motion, PathsThatFailWhereAShortBranchIsSoughtLeaveTheMotionUndecided) {
  const Mechanism m = mechanism_text(nearly_too_short("1.5000001"));
  MotionOptions options = options_for(m, 50);
  options.to = 2;
  // By paths, of which there are none to lose in a dyad that is solved by formula.
  options.solve.start = StartKind::total_degree;
  // Double-double would find what these sessions lose.
  options.solve.precision = Precision::double_precision;
  const TiringTracker tireless(std::numeric_limits<int>::max());
  EXPECT_TRUE(find_motion(m, tireless, options).complete);
  // The last sessions are those of the search.
  const MotionResult result = find_motion(m, TiringTracker(tireless.opened - 1), options);
  EXPECT_FALSE(result.complete);
  ASSERT_FALSE(result.failures.empty());
  EXPECT_EQ(result.failures.front().rfind("closures at t = 1.0", 0), 0U) << result.failures.front();
}

}  // namespace
}  // namespace moivre
