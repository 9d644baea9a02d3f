// SPDX-License-Identifier: MIT
// Do the lane tracker and the CVODE tracker find the same roots on the same paths, and lanes the
// index's counts?
#include <gtest/gtest.h>

#include "moivre/solver/cross_check.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre {
namespace {

constexpr int kThreads = 2;
/// CVODE takes a second or less up to here; the lanes alone follow more.
constexpr std::uint64_t kPathsForBoth = 130;
constexpr std::uint64_t kPathsForLanes = 1100;
constexpr std::uint64_t kSeedsForBoth = 3;
constexpr std::uint64_t kSeedsForLanes = 5;

class EveryProblem : public testing::TestWithParam<problems::Problem> {};

TEST_P(EveryProblem, HasTheSameRootsOnTheSamePathsWithBothTrackers) {
  const problems::Problem& p = GetParam();
  if (p.total_degree > kPathsForBoth || test::is_beyond_reach(p)) GTEST_SKIP();
  const System f = test::system_of(p);
  for (std::uint64_t seed = 1; seed <= kSeedsForBoth; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto options = test::with_seed(seed, kThreads);
    const auto fallback = make_cvode_tracker();
    SolveOptions handing_over = options;
    handing_over.fallback = fallback.get();
    const SolveResult lanes = solve(f, *make_lane_tracker(), handing_over);
    const SolveResult cvode = test::solve_with_cvode(f, options);
    if (!cvode.complete) continue;
    EXPECT_TRUE(lanes.complete);
    const CrossCheck check = compare(lanes, cvode);
    EXPECT_EQ(check.missed, 0U);
    EXPECT_EQ(check.unwitnessed, 0U);
    EXPECT_TRUE(check.disagreements.empty());
  }
}

TEST_P(EveryProblem, HasTheCountsOfTheIndexInLanes) {
  const problems::Problem& p = GetParam();
  const System f = test::system_of(p);
  const auto fallback = make_cvode_tracker();
  for (std::uint64_t seed = 1; seed <= kSeedsForLanes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    SolveOptions options = test::with_seed(seed, kThreads);
    options.fallback = fallback.get();
    const SolveResult result = solve(f, *make_lane_tracker(), options);
    test::expect_conservation(result);
    if (!result.complete && test::is_beyond_reach(p)) continue;
    if (p.roots.far > 0) {
      EXPECT_TRUE(result.complete);
      EXPECT_GE(result.solutions.size(), p.roots.distinct - p.roots.far);
      continue;
    }
    test::expect_counts_of_index(result, p);
  }
}

std::vector<problems::Problem> chosen_problems() {
  std::vector<problems::Problem> chosen;
  for (const problems::Problem& p : test::problem_index()) {
    if (p.total_degree <= kPathsForLanes) chosen.push_back(p);
  }
  return chosen;
}

std::string name_of(const testing::TestParamInfo<problems::Problem>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Index, EveryProblem, testing::ValuesIn(chosen_problems()), name_of);

}  // namespace

namespace problems {
void PrintTo(const Problem& p, std::ostream* out) { *out << p.name; }
}  // namespace problems
}  // namespace moivre
