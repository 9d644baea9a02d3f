// SPDX-License-Identifier: MIT
// Is the reported accuracy true, and not far from the truth? Roots of both trackers against the
// same roots to fifty digits.
#include <gtest/gtest.h>

#include "moivre/multiprecision/reference_roots.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre {
namespace {

constexpr int kDigits = 50;
constexpr double kUnitRoundoff = 0x1p-53;
constexpr double kLargestMedian = 100;

/// Adds reported / true error of each regular root; the true one no less than the rounding of a
/// double.
void compare(const System& f, const SolveResult& result, std::vector<double>& ratios) {
  std::vector<Point> roots;
  std::vector<double> reported;
  for (const Solution& s : result.solutions) {
    if (s.singular) continue;
    roots.push_back(s.x);
    reported.push_back(s.accuracy);
  }
  const auto references = reference_roots(f, roots, kDigits);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    ASSERT_TRUE(references[k].converged);
    EXPECT_LE(references[k].forward_error, reported[k]);
    ratios.push_back(reported[k] / std::max(references[k].forward_error, kUnitRoundoff));
  }
}

TEST(ReportedAccuracy, IsTrueAndNearTheTruth) {
  std::vector<double> ratios;
  for (const char* name :
       {"katsura-6", "cyclic-5", "noon-4", "reimer-4", "chandra-7", "eco-6", "puma", "badvars",
        "near-double", "wilkinson-15", "wilkinson-20", "dense-complex-4-3", "multiplicity-8"}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
      const System f = test::system_of(test::problem(name));
      compare(f, test::solve_with_cvode(f, test::with_seed(seed)), ratios);
      compare(f, solve(f, *make_lane_tracker(), test::with_seed(seed)), ratios);
    }
  }
  ASSERT_GT(ratios.size(), 1000U);
  std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2),
                   ratios.end());
  EXPECT_LE(ratios[ratios.size() / 2], kLargestMedian);
}

}  // namespace
}  // namespace moivre
