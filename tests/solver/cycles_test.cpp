// SPDX-License-Identifier: MIT
// Do paths that lead to one another walk a cycle together, and see what each would see alone?
#include "cycles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "moivre/solver/trace.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"
#include "tracking.h"

namespace moivre::test {
namespace {

using Chains = std::vector<SheetChain>;

constexpr double kRadius = 1e-4;

/// Turns from hash to hash, all at one radius.
std::vector<Turn> turns_between(const std::vector<std::pair<Complex, Complex>>& hashes) {
  std::vector<Turn> turns;
  for (const auto& [begin, end] : hashes) turns.push_back({kRadius, begin, end});
  return turns;
}

TEST(ChainsOfSheets, AreClosedWhereTurnsLeadToOneAnother) {
  const Complex a(1, 2), b(-3, 1), c(1, -2), d(5, 0), e(5, 1);
  EXPECT_EQ(chains_of(turns_between({{a, c}, {d, e}, {b, a}, {c, b}, {e, d}})),
            (Chains{{{0, 3, 2}, true}, {{1, 4}, true}}));
}

TEST(ChainsOfSheets, AreOpenWhereAPathIsNotThere) {
  const Complex a(1, 2), b(-3, 1), c(1, -2), d(5, 0);
  EXPECT_EQ(chains_of(turns_between({{b, c}, {a, b}, {d, a}})), (Chains{{{2, 1, 0}, false}}));
}

TEST(ChainsOfSheets, DoNotPassAPointWhereTwoPathsWait) {
  const Complex a(1, 2), b(-3, 1);
  EXPECT_EQ(chains_of(turns_between({{a, b}, {b, a}, {b, a}})),
            (Chains{{{1, 0}, false}, {{2}, false}}));
}

TEST(ChainsOfSheets, StayAtOneRadius) {
  const Complex a(1, 2), b(-3, 1);
  EXPECT_EQ(chains_of({{kRadius, a, b}, {4 * kRadius, b, a}}),
            (Chains{{{0}, false}, {{1}, false}}));
}

TEST(ChainsOfSheets, HaveAsManySheetsAsThereAre) {
  std::vector<std::pair<Complex, Complex>> ring;
  for (int k = 0; k < 54; ++k) ring.push_back({Complex(k), Complex((k + 1) % 54)});
  const Chains chains = chains_of(turns_between(ring));
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_TRUE(chains.front().is_closed);
  EXPECT_EQ(chains.front().sheets.size(), 54U);
}

TEST(ChainsOfSheets, AreOpenWhereTheyLeadIntoARing) {
  const Complex a(1, 2), b(-3, 1), c(1, -2);
  EXPECT_EQ(chains_of(turns_between({{a, b}, {b, c}, {c, b}})),
            (Chains{{{1, 2}, true}, {{0}, false}}));
}

// As far as hashes tell: the points themselves are told apart more sharply.
TEST(ChainsOfSheets, HoldATurnThatLeadsToItself) {
  const Complex a(1, 2), b(-3, 1);
  EXPECT_EQ(chains_of(turns_between({{a, a}, {b, a}})), (Chains{{{1, 0}, false}}));
  EXPECT_EQ(chains_of(turns_between({{a, a}})), (Chains{{{0}, false}}));
}

TEST(ChainsOfSheets, AreOfOnePathWhosePointHasNoHash) {
  const Complex none(std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_EQ(chains_of(turns_between({{none, none}, {none, none}})),
            (Chains{{{0}, false}, {{1}, false}}));
}

// 84 of the 120 paths of reimer-4 go to infinity, in cycles of 3 to 8 sheets.
TEST(Cycles, AreWalkedOnceForAllTheirSheets) {
  const System f = system_of(problem("reimer-4"));
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto tracker = make_lane_tracker();
    const std::atomic<bool> go_on{false};
    const SolveOptions options = with_seed(seed);
    const Setting setting(f, *tracker, options, go_on);
    moivre::Run together(setting);
    track_all(together);
    track_waiting(together, Effort::all_steps);
    std::uint64_t steps_alone = 0;
    for (std::uint64_t path = 0; path < together.table.tracked(); ++path) {
      const Trace alone = trace_path(f, *tracker, options, path, go_on);
      EXPECT_EQ(alone.end.status == PathStatus::at_infinity,
                together.table.records()[path].verdict == PathVerdict::at_infinity)
          << path;
      steps_alone += alone.end.count.accepted;
    }
    // 0.85 to 0.87, the steps of the first, brief following among them; alone each sheet walks its
    // own circle.
    EXPECT_LT(10 * together.work.accepted, 9 * steps_alone) << "seed " << seed;
  }
}

/// Of these of six paths, which all end at the sixfold root (2, 3): the ends, followed together.
std::map<std::uint64_t, PathEnd> ends_at_sixfold_root(const std::vector<std::uint64_t>& paths,
                                                      const Tracker& tracker,
                                                      int most_sheets = 32) {
  SolveOptions options = with_seed(1);
  options.endgame.ends.maximum_winding = most_sheets;
  const std::atomic<bool> go_on{false};
  const System f = read("2\n (x - 2)^6 + 5*(y - 3);\n (y - 3) - 7*(x - 2)^6;\n");
  const Setting setting(f, tracker, options, go_on);
  std::map<std::uint64_t, PathEnd> ends;
  track_paths(
      setting.problem(0), {paths.size(), [&](std::uint64_t k) { return paths[k]; }}, 0, 1,
      [&](std::uint64_t path, PathEnd&& end) { ends.emplace(path, std::move(end)); }, go_on);
  return ends;
}

std::uint64_t steps_of(const std::map<std::uint64_t, PathEnd>& ends) {
  std::uint64_t steps = 0;
  for (const auto& [path, end] : ends) steps += end.count.accepted;
  return steps;
}

// Its end needs two circles that agree.
TEST(Cycles, AreWalkedOnceOnSmallerCirclesToo) {
  for (const auto& tracker : {make_lane_tracker(), make_cvode_tracker()}) {
    SCOPED_TRACE(tracker->kind());
    std::uint64_t alone = 0;
    for (const std::uint64_t path : {0U, 1U, 2U, 3U, 4U, 5U}) {
      const auto ends = ends_at_sixfold_root({path}, *tracker);
      EXPECT_EQ(ends.at(path).winding, 6);
      alone += steps_of(ends);
    }
    const auto together = ends_at_sixfold_root({0, 1, 2, 3, 4, 5}, *tracker);
    for (const auto& [path, end] : together) EXPECT_EQ(end.winding, 6) << path;
    // 0.31 and 0.46; 0.66 and 0.74 where only the first circle is shared.
    EXPECT_LT(5 * steps_of(together), 3 * alone);
  }
}

TEST(Cycles, AreClosedByOnePathForAllWhereASheetHasNoPath) {
  for (const auto& tracker : {make_lane_tracker(), make_cvode_tracker()}) {
    SCOPED_TRACE(tracker->kind());
    const auto alone = ends_at_sixfold_root({0}, *tracker);
    const auto four = ends_at_sixfold_root({0, 2, 3, 5}, *tracker);
    ASSERT_EQ(four.size(), 4U);
    for (const auto& [path, end] : four) EXPECT_EQ(end.winding, 6) << path;
    // 2.4 and 2.8; 4 where each walks alone.
    EXPECT_LT(steps_of(four), 3 * steps_of(alone));
  }
}

TEST(Cycles, OfMoreSheetsThanAllowedAreNotTakenForOneOfFewer) {
  for (const auto& tracker : {make_lane_tracker(), make_cvode_tracker()}) {
    SCOPED_TRACE(tracker->kind());
    const auto ends = ends_at_sixfold_root({0, 1, 2, 3, 4, 5}, *tracker, 5);
    ASSERT_EQ(ends.size(), 6U);
    for (const auto& [path, end] : ends) EXPECT_FALSE(end.winding) << path;
  }
}

}  // namespace
}  // namespace moivre::test
