// SPDX-License-Identifier: MIT
// Does the tracker in double-double keep to its path, arrive where the end is regular, and only
// there?
#include "moivre/tracker/double_double_tracker.h"

#include <gtest/gtest.h>

#include <numbers>

#include "segments.h"

namespace moivre {
namespace {

using test::affine;
using test::from;
using test::from_square_roots_of_one;

const std::atomic<bool> kGoOn{false};

SegmentResult follow_from(const Homotopy& homotopy, const PathSegment& segment,
                          const FineTrackerOptions& options = {}) {
  return follow(*make_double_double_tracker(options)->open(homotopy), segment, kGoOn);
}

TEST(DoubleDoubleTracker, ArrivesAtARegularEnd) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 3 - 4*i");
  const SegmentResult reached = follow_from(homotopy, from({1, 1}));
  EXPECT_EQ(reached.status, SegmentStatus::arrived);
  EXPECT_LT(std::abs(affine(reached.x) - Complex(2, 1)), 1e-15);
  ASSERT_TRUE(reached.regular_condition);
  EXPECT_LT(*reached.regular_condition, 100);
  EXPECT_GT(reached.count.accepted, 10U);
}

TEST(DoubleDoubleTracker, DoesNotArriveAtADoubleRoot) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 2*i*x - 1");  // (x - i)^2
  const SegmentResult reached = follow_from(homotopy, from({1, 1}));
  EXPECT_EQ(reached.status, SegmentStatus::step_too_small);
  EXPECT_FALSE(reached.regular_condition);
  EXPECT_LT(std::abs(reached.t.rest), 1e-20);
  // x - i = O(sqrt(1 - t)).
  EXPECT_LT(std::abs(affine(reached.x) - Complex(0, 1)), 1e-9);
}

// Both sheets pass from a distance of 1 to one of 2e-8: a landing from too far away ends at the
// other's root.
TEST(DoubleDoubleTracker, LandsOnlyWhereTheNextSheetIsFartherThanTheLandingIsUnsure) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 2*i*x - 1 - 1e-16");
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
    SCOPED_TRACE(tolerance);
    std::vector<double> ends;
    for (const double start : {1.0, -1.0}) {
      const SegmentResult reached =
          follow_from(homotopy, from({start, 1}), {.tolerance = tolerance});
      ASSERT_EQ(reached.status, SegmentStatus::arrived);
      ends.push_back(affine(reached.x).real());
    }
    std::sort(ends.begin(), ends.end());
    EXPECT_NEAR(ends[0], -1e-8, 1e-15);
    EXPECT_NEAR(ends[1], 1e-8, 1e-15);
  }
}

TEST(DoubleDoubleTracker, TellsRootsApartThatAreNearerThanDoubleCanTell) {
  // Roots i and i + 1e-12: their condition is 1e24 in coefficients that double holds.
  const Homotopy homotopy = from_square_roots_of_one("x^2 - (2*i + 1e-12)*x - 1 + 1e-12*i");
  std::vector<Complex> ends;
  for (const double start : {1.0, -1.0}) {
    const SegmentResult reached = follow_from(homotopy, from({start, 1}));
    ASSERT_EQ(reached.status, SegmentStatus::arrived);
    ends.push_back(affine(reached.x) - Complex(0, 1));
  }
  const auto by_real = [](Complex a, Complex b) { return a.real() < b.real(); };
  std::sort(ends.begin(), ends.end(), by_real);
  EXPECT_LT(std::abs(ends[0]), 1e-15);
  EXPECT_LT(std::abs(ends[1] - 1e-12), 1e-15);
}

TEST(DoubleDoubleTracker, WalksRoundABranchPointInTwoTurns) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 2*i*x - 1");
  const double radius = 0.01;
  const SegmentResult approach =
      follow_from(homotopy, from({1, 1}, Contour::segment(0, 1 - radius)));
  ASSERT_EQ(approach.status, SegmentStatus::arrived);
  EXPECT_FALSE(approach.regular_condition);
  PathSegment turn = from(approach.x, Contour::spiral(radius, Complex(0, 2 * std::numbers::pi)));
  turn.samples = 8;
  const SegmentResult once = follow_from(homotopy, turn);
  ASSERT_EQ(once.status, SegmentStatus::arrived);
  ASSERT_EQ(once.samples.size(), 8U);
  EXPECT_EQ(once.samples.back(), once.x);
  EXPECT_GT(std::abs(affine(once.x) - affine(approach.x)), 0.1);
  turn.x = once.x;
  EXPECT_LT(std::abs(affine(follow_from(homotopy, turn).x) - affine(approach.x)), 1e-14);
}

TEST(DoubleDoubleTracker, FindsTheWayBack) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 3 - 4*i");
  const SegmentResult back =
      follow_from(homotopy, from({Complex(2, 1), 1}, Contour::segment(1, 0)));
  EXPECT_EQ(back.status, SegmentStatus::arrived);
  EXPECT_LT(std::abs(affine(back.x) - 1.0), 1e-15);
}

TEST(DoubleDoubleTracker, KeepsTheSizeOfThePoint) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 3 - 4*i");
  const SegmentResult reached = follow_from(homotopy, from({1, 1}), {.tolerance = 1e-12});
  // The steps are 393. In 350 a drift of the size by 0.2 % a step would double it.
  EXPECT_GT(reached.count.accepted, 350U);
  EXPECT_LT(max_norm(reached.x), 2);
  EXPECT_GT(max_norm(reached.x), 0.5);
}

TEST(DoubleDoubleTracker, SaysWhyItStops) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 3 - 4*i");
  EXPECT_EQ(follow_from(homotopy, from({2, 1})).status, SegmentStatus::bad_start);
  EXPECT_EQ(follow_from(homotopy, from({1, 1}), {.maximum_steps = 5}).status,
            SegmentStatus::step_limit);
  const std::atomic<bool> stop{true};
  const auto session = make_double_double_tracker()->open(homotopy);
  EXPECT_EQ(follow(*session, from({1, 1}), stop).status, SegmentStatus::cancelled);
}

}  // namespace
}  // namespace moivre
