// SPDX-License-Identifier: MIT
// Do paths that lead to one another walk a cycle together, and see what each would see alone?
#include "cycles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "moivre/solver/trace.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"
#include "tracking.h"

namespace moivre::test {
namespace {

using Cycles = std::vector<std::vector<std::size_t>>;

constexpr double kRadius = 1e-4;

/// Turns from hash to hash, all at one radius.
std::vector<Turn> turns_between(const std::vector<std::pair<Complex, Complex>>& hashes) {
  std::vector<Turn> turns;
  for (const auto& [begin, end] : hashes) turns.push_back({kRadius, begin, end});
  return turns;
}

TEST(CyclesOfTurns, AreThoseThatCloseInTheOrderOfTheTurns) {
  const Complex a(1, 2), b(-3, 1), c(1, -2), d(5, 0), e(5, 1);
  EXPECT_EQ(cycles_of(turns_between({{a, c}, {d, e}, {b, a}, {c, b}, {e, d}}), 32),
            (Cycles{{0, 3, 2}, {1, 4}}));
}

TEST(CyclesOfTurns, AreNotClosedByAPathThatIsNotThere) {
  const Complex a(1, 2), b(-3, 1), c(1, -2);
  EXPECT_EQ(cycles_of(turns_between({{a, b}, {b, c}}), 32), (Cycles{{0}, {1}}));
}

TEST(CyclesOfTurns, DoNotPassAPointWhereTwoPathsWait) {
  const Complex a(1, 2), b(-3, 1);
  EXPECT_EQ(cycles_of(turns_between({{a, b}, {b, a}, {b, a}}), 32), (Cycles{{0}, {1}, {2}}));
}

TEST(CyclesOfTurns, StayAtOneRadius) {
  const Complex a(1, 2), b(-3, 1);
  EXPECT_EQ(cycles_of({{kRadius, a, b}, {4 * kRadius, b, a}}, 32), (Cycles{{0}, {1}}));
}

TEST(CyclesOfTurns, HaveNoMoreSheetsThanAllowed) {
  const Complex a(1, 2), b(-3, 1), c(1, -2);
  const std::vector<Turn> turns = turns_between({{a, b}, {b, c}, {c, a}});
  EXPECT_EQ(cycles_of(turns, 3), (Cycles{{0, 1, 2}}));
  EXPECT_EQ(cycles_of(turns, 2), (Cycles{{0}, {1}, {2}}));
}

TEST(CyclesOfTurns, DoNotHoldPointsWithoutAMark) {
  const Complex none(std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_EQ(cycles_of(turns_between({{none, none}, {none, none}}), 32), (Cycles{{0}, {1}}));
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

}  // namespace
}  // namespace moivre::test
