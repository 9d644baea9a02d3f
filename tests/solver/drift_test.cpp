// SPDX-License-Identifier: MIT
// Does the drift tell a corrected method from an uncorrected one, and does it end where solve()
// ends?
#include "moivre/solver/drift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "moivre/polynomial/read.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

// tracker/path_system.h corrects points to 1e-9 relative; |H| is then of that size at most.
constexpr double kCorrected = 1e-8;
const std::vector<std::uint64_t> kPaths{0, 1, 2, 3};

System two_conics() { return read_system({"test", "x^2 + y^2 - 4; x*y - 1;"}); }

std::vector<PathDrift> drift_of(const CvodeOptions& options) {
  return measure_drift(two_conics(), *make_cvode_tracker(options), {}, kPaths);
}

double largest_end_error(const std::vector<PathDrift>& drifts) {
  const SolveResult solved = solve(two_conics(), *make_cvode_tracker());
  double largest = 0;
  for (const PathDrift& drift : drifts) {
    const auto root = std::find_if(solved.solutions.begin(), solved.solutions.end(),
                                   [&](const Solution& s) { return s.path == drift.path; });
    if (root == solved.solutions.end() || !drift.arrived) return 1;
    for (std::size_t i = 0; i < 2; ++i) {
      largest = std::max(largest, std::abs(drift.end[i] - root->x[i]));
    }
  }
  return largest;
}

TEST(Drift, NewtonTakesItAwayWhereTheMethodProjects) {
  for (const PathDrift& drift : drift_of({})) {
    EXPECT_GT(drift.before, 1e-5);
    EXPECT_GT(drift.correction, 1e-5);
    EXPECT_LT(drift.after, kCorrected);
  }
}

TEST(Drift, StaysWhereTheMethodDoesNotCorrect) {
  for (const PathDrift& drift : drift_of({.method = CvodeMethod::adams, .rtol = 1e-4})) {
    EXPECT_EQ(drift.before, drift.after);
    EXPECT_EQ(drift.correction, 0);
    EXPECT_GT(drift.after, kCorrected);
  }
}

TEST(Drift, EndsCarryTheErrorThatTheMethodGathered) {
  EXPECT_LT(largest_end_error(drift_of({})), kCorrected);
  const double loose = largest_end_error(drift_of({.method = CvodeMethod::adams, .rtol = 1e-4}));
  const double tight = largest_end_error(drift_of({.method = CvodeMethod::adams, .rtol = 1e-8}));
  EXPECT_GT(loose, kCorrected);
  EXPECT_LT(tight, loose / 100);
}

TEST(Drift, OfAPathThatIsNotThereIsRefused) {
  EXPECT_THROW(measure_drift(two_conics(), *make_cvode_tracker(), {}, {4}), std::invalid_argument);
}

TEST(Drift, IsNotMeasuredFurtherOnceStopped) {
  const std::atomic<bool> stop{true};
  for (const PathDrift& drift :
       measure_drift(two_conics(), *make_cvode_tracker(), {}, kPaths, stop)) {
    EXPECT_FALSE(drift.arrived);
  }
}

}  // namespace
}  // namespace moivre
