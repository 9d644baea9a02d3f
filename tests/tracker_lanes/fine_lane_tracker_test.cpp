// SPDX-License-Identifier: MIT
// Do lanes in double-double arrive where the tracker of one path does, and only there?
#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "../tracker/segments.h"
#include "every_target.h"
#include "moivre/start/total_degree.h"
#include "moivre/tracker/double_double_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

using test::affine;
using test::from;
using test::from_square_roots_of_one;
using test::SegmentList;

// Of an end, rounded to double.
constexpr double kEndAccuracy = 1e-15;

const std::atomic<bool> kGoOn{false};

std::unique_ptr<Tracker> fine_lanes(const LaneOptions& options = {}) {
  return make_lane_tracker(options)->in_double_double();
}

SegmentResult follow_from(const Homotopy& homotopy, const PathSegment& segment,
                          const LaneOptions& options = {}) {
  return follow(*fine_lanes(options)->open(homotopy), segment, kGoOn);
}

TEST(FineLanes, SayWhatTheyAre) {
  const auto tracker = fine_lanes({.tolerance = 1e-3});
  EXPECT_EQ(tracker->kind(), "lanes");
  std::map<std::string, OptionValue> options;
  for (const auto& [name, value] : tracker->options_in_force()) options[name] = value;
  EXPECT_EQ(options["precision"], OptionValue("double-double"));
  EXPECT_EQ(options["tolerance"], OptionValue(1e-5));
  EXPECT_EQ(options["target"], OptionValue(lane_target()));
}

TEST(FineLanes, ArriveAtARegularEnd) {
  test::on_every_target([] {
    const Homotopy homotopy = from_square_roots_of_one("x^2 - 3 - 4*i");
    const SegmentResult reached = follow_from(homotopy, from({1, 1}));
    EXPECT_EQ(reached.status, SegmentStatus::arrived);
    EXPECT_LT(std::abs(affine(reached.x) - Complex(2, 1)), kEndAccuracy);
    ASSERT_TRUE(reached.regular_condition);
    EXPECT_LT(*reached.regular_condition, 100);
  });
}

TEST(FineLanes, DoNotArriveAtADoubleRoot) {
  test::on_every_target([] {
    const Homotopy homotopy = from_square_roots_of_one("x^2 - 2*i*x - 1");  // (x - i)^2
    const SegmentResult reached = follow_from(homotopy, from({1, 1}));
    EXPECT_EQ(reached.status, SegmentStatus::step_too_small);
    EXPECT_FALSE(reached.regular_condition);
    EXPECT_LT(std::abs(reached.t.rest), 1e-20);
    EXPECT_LT(std::abs(affine(reached.x) - Complex(0, 1)), 1e-9);
  });
}

TEST(FineLanes, TellRootsApartThatAreNearerThanDoubleCanTell) {
  // Roots i and i + 1e-12: their condition is 1e24 in coefficients that double holds.
  test::on_every_target([] {
    const Homotopy homotopy = from_square_roots_of_one("x^2 - (2*i + 1e-12)*x - 1 + 1e-12*i");
    std::vector<Complex> ends;
    for (const double start : {1.0, -1.0}) {
      const SegmentResult reached = follow_from(homotopy, from({start, 1}));
      ASSERT_EQ(reached.status, SegmentStatus::arrived);
      ends.push_back(affine(reached.x) - Complex(0, 1));
    }
    const auto by_real = [](Complex a, Complex b) { return a.real() < b.real(); };
    std::sort(ends.begin(), ends.end(), by_real);
    EXPECT_LT(std::abs(ends[0]), kEndAccuracy);
    EXPECT_LT(std::abs(ends[1] - 1e-12), kEndAccuracy);
  });
}

TEST(FineLanes, WalkRoundABranchPointInTwoTurns) {
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
  EXPECT_LT(std::abs(affine(follow_from(homotopy, turn).x) - affine(once.x)), 1);
  EXPECT_LT(std::abs(affine(follow_from(homotopy, turn).x) - affine(approach.x)), 1e-9);
}

TEST(FineLanes, FindTheWayBack) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 3 - 4*i");
  const SegmentResult back =
      follow_from(homotopy, from({Complex(2, 1), 1}, Contour::segment(1, 0)));
  EXPECT_EQ(back.status, SegmentStatus::arrived);
  EXPECT_LT(std::abs(affine(back.x) - 1.0), 1e-9);
}

TEST(FineLanes, SayWhyTheyStop) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 3 - 4*i");
  EXPECT_EQ(follow_from(homotopy, from({2, 1})).status, SegmentStatus::bad_start);
  EXPECT_EQ(follow_from(homotopy, from({1, 1}), {.maximum_steps = 5}).status,
            SegmentStatus::step_limit);
  const std::atomic<bool> stop{true};
  const auto session = fine_lanes()->open(homotopy);
  EXPECT_EQ(follow(*session, from({1, 1}), stop).status, SegmentStatus::cancelled);
}

TEST(FineLanes, FollowManyPathsToTheEndsThatEachHasAlone) {
  // Nine paths: more than any target has lanes.
  const System f = read_system({"test", "2\nx^3 + 2*x*y - y^2 - 3; y^3 - x^2*y + 4*x - 1;\n"});
  const TotalDegreeStart start = total_degree_start(degrees(f), 1);
  const Homotopy homotopy(f, start_system(start, f.variables));
  const auto segment = [&](std::uint64_t path) {
    PathSegment result = from(start_point(start, path));
    result.path = path;
    return result;
  };
  std::vector<PathSegment> segments;
  for (std::uint64_t path = 0; path < start.paths; ++path) segments.push_back(segment(path));
  test::on_every_target([&] {
    SegmentList together(segments);
    fine_lanes()->open(homotopy)->run(together, kGoOn);
    ASSERT_EQ(together.results.size(), start.paths);
    for (const auto& [path, reached] : together.results) {
      ASSERT_EQ(reached.status, SegmentStatus::arrived);
      const SegmentResult lonely = follow_from(homotopy, segment(path));
      EXPECT_EQ(lonely.x, reached.x) << path;
      EXPECT_EQ(lonely.count.accepted, reached.count.accepted) << path;
      const SegmentResult witness =
          follow(*make_double_double_tracker()->open(homotopy), segment(path), kGoOn);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(std::abs(reached.x[i] / reached.x[2] - witness.x[i] / witness.x[2]),
                  2 * kEndAccuracy)
            << path;
      }
    }
  });
}

}  // namespace
}  // namespace moivre
