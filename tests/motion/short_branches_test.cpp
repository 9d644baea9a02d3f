// SPDX-License-Identifier: MIT
// Is a branch found that lives for a ten-millionth of the motion? Six-bars whose dead points are
// known from other equations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "moivre/kinematics/state.h"
#include "moivre/motion/motion.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "motion_record.h"
#include "pair_search.h"
#include "reconcile.h"
#include "short_lives.h"

namespace moivre::test {
namespace {

MotionResult turn_of(const BriefLife& brief) {
  MotionOptions options;
  options.to = kTurn_s;
  options.steps = 12;
  options.solve.threads = 1;
  return find_motion(mechanism_of(brief), *make_lane_tracker(), options);
}

/// The dead points at that time, within a billionth of the turn. A symmetric mechanism has several.
std::vector<const MotionEvent*> dead_points_at(const MotionResult& motion, double time) {
  constexpr double kSameTime = 1e-9 * kTurn_s;
  std::vector<const MotionEvent*> found;
  for (const MotionEvent& event : motion.events) {
    const bool is_there = std::abs(event.at.time - time) <= kSameTime;
    if (event.at.kind == EventKind::dead_point && is_there) found.push_back(&event);
  }
  return found;
}

/// Whether branches begin or end at a dead point of `first` and of `last` as the kind wants.
bool has_both(const std::vector<const MotionEvent*>& first,
              const std::vector<const MotionEvent*>& last, BriefKind kind) {
  for (const MotionEvent* one : first) {
    for (const MotionEvent* other : last) {
      switch (kind) {
        case BriefKind::gap:
          if (one->ending.size() == 2 && other->beginning.size() == 2) return true;
          break;
        case BriefKind::island:
          if (one->beginning.size() == 2 && one->beginning == other->ending) return true;
          break;
        case BriefKind::fold_back:
          for (const std::string& branch : one->beginning) {
            const auto& ending = other->ending;
            const bool is_brief = std::find(ending.begin(), ending.end(), branch) != ending.end();
            if (is_brief) return true;
          }
          break;
      }
    }
  }
  return false;
}

std::string name_of(double share, std::uint64_t number) {
  return "share " + exact_text(share) + ", number " + std::to_string(number);
}

void expect_found(BriefKind kind, const std::vector<double>& shares, std::uint64_t count) {
  constexpr std::uint64_t kSeed = 12;
  for (const double share : shares) {
    for (std::uint64_t number = 0; number < count; ++number) {
      SCOPED_TRACE(name_of(share, number));
      const BriefLife brief = random_brief_life(kind, share, kSeed, number);
      const MotionResult motion = turn_of(brief);
      // Three poses of a fold-back lie so near to each other that some are told to be in doubt.
      EXPECT_TRUE(motion.complete || kind == BriefKind::fold_back)
          << motion.message << ": " << (motion.failures.empty() ? "" : motion.failures.front());
      EXPECT_TRUE(has_both(dead_points_at(motion, brief.times[0]),
                           dead_points_at(motion, brief.times[1]), kind));
    }
  }
}

TEST(ShortBranches, AreToldWhereTheGapBetweenThemIsTooShortToBeFound) {
  // What sets out beyond one of the dead points does not come back to it: it was sought again
  // without end.
  const MotionResult motion = turn_of(random_brief_life(BriefKind::gap, 1e-7, 1, 1));
  EXPECT_FALSE(motion.complete);
  EXPECT_FALSE(motion.failures.empty());
}

TEST(ShortBranches, TwoThatLiveBetweenTheSameDeadPointsAreFound) {
  expect_found(BriefKind::island, {1e-3, 1e-5, 1e-7}, 6);
}

TEST(ShortBranches, OneThatFoldsBackBetweenTwoOthersIsFound) {
  expect_found(BriefKind::fold_back, {1e-3, 1e-5, 1e-7}, 2);
}

/// At 1e-7 Phi no longer tells a gap from a crossing: there it is a bifurcation.
TEST(ShortBranches, BranchesThatPartForAMomentAreNotTakenForOne) {
  expect_found(BriefKind::gap, {1e-3, 1e-5}, 3);
}

TEST(ShortBranches, TheOneThatNoSceneShowsHasItsVelocityWhereItIsASample) {
  const Mechanism m = example("four-bar");
  MotionOptions options;
  options.steps = 2;
  const std::atomic<bool> stop{false};
  MotionRun run(m, options, motion_times(options, 0), stop);
  ClosureOptions at;
  at.time = run.times.samples[1];
  const BranchPose pose{at.time, find_closures(m, *make_lane_tracker(), at).closures.front().q};
  run.tracks.push_back(brief_track(run.phi, pose, pose, pose));
  MotionResult result = empty_result(run.options, run.times);
  enter_branches(run, result);
  ASSERT_EQ(result.branches.front().samples.size(), 1U);
  const BranchSample& sample = result.branches.front().samples.front();
  const MotionState state = motion_state(run.phi, pose.q, pose.time);
  EXPECT_EQ(sample.velocity, state.velocity);
  EXPECT_EQ(sample.acceleration, state.acceleration);
}

TEST(ShortBranches, WhatIsLeftUnseenBetweenEventsIsTold) {
  const BriefLife brief = random_brief_life(BriefKind::island, 1e-3, 12, 0);
  const Mechanism m = mechanism_of(brief);
  MotionOptions options;
  options.to = kTurn_s;
  options.solve.threads = 1;
  const std::atomic<bool> stop{false};
  const auto tracker = make_lane_tracker();
  const auto doubts_after = [&](std::size_t times) {
    MotionRun run(m, options, motion_times(options, options.checkpoints), stop);
    std::vector<SolvedCheckpoint> checkpoints = solve_checkpoints(run, *tracker);
    reconcile(run, checkpoints);
    PairSearch pairs(run, *tracker);
    search_pairs(run, *tracker, checkpoints, pairs, times);
    return pairs.doubts();
  };
  EXPECT_TRUE(doubts_after(kMostSearches).empty());
  EXPECT_EQ(doubts_after(0).size(), 1U);
}

/// The dead points' times are from equations of their own: there the mechanism has a closure, and
/// is singular.
TEST(ShortBranches, TheTimesThatAreExpectedAreDeadPoints) {
  const BriefLife brief = random_brief_life(BriefKind::island, 1e-3, 12, 0);
  EXPECT_NEAR(brief.times[1] - brief.times[0], 1e-3 * kTurn_s, 1e-4 * kTurn_s);
  const Mechanism m = mechanism_of(brief);
  ClosureOptions options;
  options.solve.threads = 1;
  const auto real_at = [&](double time) {
    options.time = time;
    return find_closures(m, *make_lane_tracker(), options).counts.real;
  };
  const double little = 1e-6 * kTurn_s;
  const std::uint64_t between = real_at((brief.times[0] + brief.times[1]) / 2);
  EXPECT_EQ(real_at(brief.times[0] - little) + 2, between);
  EXPECT_EQ(real_at(brief.times[1] + little) + 2, between);
}

}  // namespace
}  // namespace moivre::test
