// SPDX-License-Identifier: MIT
// Do lanes in double-double arrive where the tracker of one path does, and only there?
#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "../tracker/journeys.h"
#include "every_target.h"
#include "moivre/start/total_degree.h"
#include "moivre/tracker/double_double_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

using test::affine;
using test::from;
using test::from_square_roots_of_one;
using test::Journeys;

// Of an end, rounded to double.
constexpr double kArrivalAccuracy = 1e-15;

const std::atomic<bool> kGoOn{false};

std::unique_ptr<Tracker> fine_lanes(const LaneOptions& options = {}) {
  return make_lane_tracker(options)->in_double_double();
}

Arrival follow_from(const Homotopy& homotopy, const Departure& departure,
                    const LaneOptions& options = {}) {
  return follow(*fine_lanes(options)->open(homotopy), departure, kGoOn);
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
    const Arrival arrival = follow_from(homotopy, from({1, 1}));
    EXPECT_EQ(arrival.journey, Journey::arrived);
    EXPECT_LT(std::abs(affine(arrival.x) - Complex(2, 1)), kArrivalAccuracy);
    ASSERT_TRUE(arrival.regular_condition);
    EXPECT_LT(*arrival.regular_condition, 100);
  });
}

TEST(FineLanes, DoNotArriveAtADoubleRoot) {
  test::on_every_target([] {
    const Homotopy homotopy = from_square_roots_of_one("x^2 - 2*i*x - 1");  // (x - i)^2
    const Arrival arrival = follow_from(homotopy, from({1, 1}));
    EXPECT_EQ(arrival.journey, Journey::step_too_small);
    EXPECT_FALSE(arrival.regular_condition);
    EXPECT_LT(std::abs(arrival.t.rest), 1e-20);
    EXPECT_LT(std::abs(affine(arrival.x) - Complex(0, 1)), 1e-9);
  });
}

TEST(FineLanes, TellRootsApartThatAreNearerThanDoubleCanTell) {
  // Roots i and i + 1e-12: their condition is 1e24 in coefficients that double holds.
  test::on_every_target([] {
    const Homotopy homotopy = from_square_roots_of_one("x^2 - (2*i + 1e-12)*x - 1 + 1e-12*i");
    std::vector<Complex> ends;
    for (const double start : {1.0, -1.0}) {
      const Arrival arrival = follow_from(homotopy, from({start, 1}));
      ASSERT_EQ(arrival.journey, Journey::arrived);
      ends.push_back(affine(arrival.x) - Complex(0, 1));
    }
    const auto by_real = [](Complex a, Complex b) { return a.real() < b.real(); };
    std::sort(ends.begin(), ends.end(), by_real);
    EXPECT_LT(std::abs(ends[0]), kArrivalAccuracy);
    EXPECT_LT(std::abs(ends[1] - 1e-12), kArrivalAccuracy);
  });
}

TEST(FineLanes, WalkRoundABranchPointInTwoTurns) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 2*i*x - 1");
  const double radius = 0.01;
  const Arrival approach = follow_from(homotopy, from({1, 1}, Contour::segment(0, 1 - radius)));
  ASSERT_EQ(approach.journey, Journey::arrived);
  EXPECT_FALSE(approach.regular_condition);
  Departure turn = from(approach.x, Contour::spiral(radius, Complex(0, 2 * std::numbers::pi)));
  turn.samples = 8;
  const Arrival once = follow_from(homotopy, turn);
  ASSERT_EQ(once.journey, Journey::arrived);
  ASSERT_EQ(once.samples.size(), 8U);
  EXPECT_EQ(once.samples.back(), once.x);
  EXPECT_GT(std::abs(affine(once.x) - affine(approach.x)), 0.1);
  turn.x = once.x;
  EXPECT_LT(std::abs(affine(follow_from(homotopy, turn).x) - affine(once.x)), 1);
  EXPECT_LT(std::abs(affine(follow_from(homotopy, turn).x) - affine(approach.x)), 1e-9);
}

TEST(FineLanes, FindTheWayBack) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 3 - 4*i");
  const Arrival back = follow_from(homotopy, from({Complex(2, 1), 1}, Contour::segment(1, 0)));
  EXPECT_EQ(back.journey, Journey::arrived);
  EXPECT_LT(std::abs(affine(back.x) - 1.0), 1e-9);
}

TEST(FineLanes, SayWhyTheyStop) {
  const Homotopy homotopy = from_square_roots_of_one("x^2 - 3 - 4*i");
  EXPECT_EQ(follow_from(homotopy, from({2, 1})).journey, Journey::bad_start);
  EXPECT_EQ(follow_from(homotopy, from({1, 1}), {.maximum_steps = 5}).journey, Journey::step_limit);
  const std::atomic<bool> stop{true};
  const auto session = fine_lanes()->open(homotopy);
  EXPECT_EQ(follow(*session, from({1, 1}), stop).journey, Journey::cancelled);
}

TEST(FineLanes, FollowManyPathsToTheEndsThatEachHasAlone) {
  // Nine paths: more than any target has lanes.
  const System f = read_system({"test", "2\nx^3 + 2*x*y - y^2 - 3; y^3 - x^2*y + 4*x - 1;\n"});
  const TotalDegreeStart start = total_degree_start(degrees(f), 1);
  const Homotopy homotopy(f, start_system(start, f.variables));
  const auto departure = [&](std::uint64_t path) {
    Departure result = from(start_point(start, path));
    result.path = path;
    return result;
  };
  std::vector<Departure> departures;
  for (std::uint64_t path = 0; path < start.paths; ++path) departures.push_back(departure(path));
  test::on_every_target([&] {
    Journeys together(departures);
    fine_lanes()->open(homotopy)->run(together, kGoOn);
    ASSERT_EQ(together.arrivals.size(), start.paths);
    for (const auto& [path, arrival] : together.arrivals) {
      ASSERT_EQ(arrival.journey, Journey::arrived);
      const Arrival lonely = follow_from(homotopy, departure(path));
      EXPECT_EQ(lonely.x, arrival.x) << path;
      EXPECT_EQ(lonely.count.accepted, arrival.count.accepted) << path;
      const Arrival witness =
          follow(*make_double_double_tracker()->open(homotopy), departure(path), kGoOn);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(std::abs(arrival.x[i] / arrival.x[2] - witness.x[i] / witness.x[2]),
                  2 * kArrivalAccuracy)
            << path;
      }
    }
  });
}

}  // namespace
}  // namespace moivre
