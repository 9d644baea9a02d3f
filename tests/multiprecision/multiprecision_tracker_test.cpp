// SPDX-License-Identifier: MIT
// Do paths in a hundred digits and more lead to roots that double-double cannot part, and not to a
// multiple one?
#include "moivre/multiprecision/multiprecision_tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "moivre/tracker/double_double_tracker.h"
#include "segments.h"

namespace moivre::test {
namespace {

const std::atomic<bool> kGoOn{false};

constexpr Complex kPower(3, 4);

/// From x^m = 3 + 4 i to f, which has coefficients of 1 at most.
Homotopy from_roots(int m, const std::string& f) {
  return {read_system({"f", "1\n" + f + ";\n"}),
          read_system({"g", "1\nx^" + std::to_string(m) + " - 3 - 4*i;\n"})};
}

Point root(int m, int k) {
  const double angle = (std::arg(kPower) + 2 * std::numbers::pi * k) / m;
  return {std::polar(std::pow(std::abs(kPower), 1.0 / m), angle), 1};
}

std::vector<SegmentResult> results(const Tracker& tracker, const Homotopy& homotopy, int m) {
  const auto session = tracker.open(homotopy);
  std::vector<SegmentResult> all;
  for (int k = 0; k < m; ++k) all.push_back(follow(*session, from(root(m, k)), kGoOn));
  return all;
}

TEST(MultiprecisionTracker, PartsTenRootsWithinAMillionth) {
  const Homotopy homotopy = from_roots(10, "1/252*(x - 1)^10 - 1/252*1e-60");
  for (const int digits : kTrackedDigits) {
    SCOPED_TRACE(digits);
    std::set<int> found;
    for (const SegmentResult& reached :
         results(*make_multiprecision_tracker(digits), homotopy, 10)) {
      ASSERT_EQ(reached.status, SegmentStatus::arrived);
      ASSERT_TRUE(reached.regular_condition);
      const Complex apart = affine(reached.x) - 1.0;
      EXPECT_NEAR(std::abs(apart), 1e-6, 1e-15);
      found.insert(static_cast<int>(std::lround(std::arg(apart) * 5 / std::numbers::pi)) % 10);
    }
    EXPECT_EQ(found.size(), 10U);
  }
  for (const SegmentResult& reached : results(*make_double_double_tracker(), homotopy, 10)) {
    EXPECT_NE(reached.status, SegmentStatus::arrived);
  }
}

TEST(MultiprecisionTracker, PartsThirtyRootsInThreeHundredDigitsOnly) {
  const Homotopy homotopy = from_roots(30, "1/155117520*(x - 1)^30 - 1/155117520*1e-180");
  const auto ends_of = [&](int digits) {
    const auto session = make_multiprecision_tracker(digits)->open(homotopy);
    return follow(*session, from(root(30, 0)), kGoOn);
  };
  EXPECT_EQ(ends_of(100).status, SegmentStatus::step_too_small);
  const SegmentResult reached = ends_of(300);
  ASSERT_EQ(reached.status, SegmentStatus::arrived);
  EXPECT_NEAR(std::abs(affine(reached.x) - 1.0), 1e-6, 1e-15);
  EXPECT_GT(*reached.regular_condition, 1e150);
}

// 1 - t falls by 80 powers of ten on the way, in steps of its logarithm.
TEST(MultiprecisionTracker, ComesNearAMultipleRootInFewStepsAndDoesNotArrive) {
  const Homotopy homotopy = from_roots(3, "1/3*(x - 1)^3");
  for (const SegmentResult& reached : results(*make_multiprecision_tracker(100), homotopy, 3)) {
    EXPECT_EQ(reached.status, SegmentStatus::step_too_small);
    EXPECT_LT(std::abs(reached.t.rest), 1e-80);
    EXPECT_FALSE(reached.regular_condition);
    EXPECT_LT(reached.count.accepted, 300U);
  }
}

TEST(MultiprecisionTracker, HasOnlyTheDigitsThatItSays) {
  EXPECT_THROW(make_multiprecision_tracker(200), std::invalid_argument);
  EXPECT_EQ(make_multiprecision_tracker(100)->kind(), "100 digits");
}

}  // namespace
}  // namespace moivre::test
