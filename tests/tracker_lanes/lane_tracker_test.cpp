// SPDX-License-Identifier: MIT
// Do journeys in lanes arrive where they should, and does a journey depend on its departure alone?
#include "moivre/tracker_lanes/lane_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <thread>

#include "../tracker/journeys.h"
#include "every_target.h"
#include "moivre/start/total_degree.h"

namespace moivre {
namespace {

using test::Journeys;
using test::Target;
using test::targets;

// Arrivals are corrected to 1e-9 and less (tracker/path_system.h).
constexpr double kArrivalAccuracy = 1e-8;

/// A system, its total-degree homotopy, and a session on it.
struct Scene {
  explicit Scene(const std::string& text, const LaneOptions& options = {})
      : f(read_system({"test", text})),
        start(total_degree_start(degrees(f), 1)),
        homotopy(f, start_system(start, f.variables)),
        tracker(make_lane_tracker(options)),
        session(tracker->open(homotopy)) {}

  Departure departure(std::uint64_t path) const {
    return {path, Contour::segment(0, 1), start_point(start, path), 0, 0, nullptr};
  }

  System f;
  TotalDegreeStart start;
  Homotopy homotopy;
  std::unique_ptr<Tracker> tracker;
  std::unique_ptr<TrackerSession> session;
};

std::map<std::uint64_t, Arrival> run(Scene& scene, std::vector<Departure> departures) {
  Journeys journeys(std::move(departures));
  const std::atomic<bool> stop{false};
  scene.session->run(journeys, stop);
  return std::move(journeys.arrivals);
}

std::vector<Departure> all_departures(const Scene& scene) {
  std::vector<Departure> departures;
  for (std::uint64_t path = 0; path < scene.start.paths; ++path) {
    departures.push_back(scene.departure(path));
  }
  return departures;
}

// Nine paths: more than any target has lanes.
const char* const kCubics = "2\nx^3 + 2*x*y - y^2 - 3; y^3 - x^2*y + 4*x - 1;\n";

TEST(LaneTracker, EveryPathOfTwoCubicsArrivesOnTheTarget) {
  Scene scene(kCubics);
  const auto arrivals = run(scene, all_departures(scene));
  ASSERT_EQ(arrivals.size(), 9u);
  for (const auto& [path, arrival] : arrivals) {
    EXPECT_EQ(arrival.journey, Journey::arrived) << path;
    EXPECT_EQ(arrival.s, 1);
    PathSystem system(scene.homotopy);
    Point x = arrival.x;
    EXPECT_LT(system.correct(x, {1, 0}, {}, true).first, kArrivalAccuracy) << path;
  }
}

// At a point of norm 1 the equation is 3^-400, whose square no double holds.
TEST(LaneTracker, APathOfHighDegreeArrives) {
  Scene scene("2\nx^800 - 1; y^3 - x - 2;\n");
  const auto arrivals = run(scene, {scene.departure(0), scene.departure(1), scene.departure(999)});
  ASSERT_EQ(arrivals.size(), 3u);
  for (const auto& [path, arrival] : arrivals) {
    EXPECT_EQ(arrival.journey, Journey::arrived) << path;
  }
}

TEST(LaneTracker, JourneysDependNeitherOnNeighboursNorOnTheLane) {
  Scene scene(kCubics);
  const auto together = run(scene, all_departures(scene));
  for (std::uint64_t path = 0; path < 9; ++path) {
    const auto alone = run(scene, {scene.departure(path)});
    EXPECT_EQ(alone.at(path).x, together.at(path).x) << path;
    EXPECT_EQ(alone.at(path).count.accepted, together.at(path).count.accepted);
  }
}

TEST(LaneTracker, AnImpossibleDepartureSpoilsNoOtherLane) {
  Scene scene(kCubics);
  const auto clean = run(scene, all_departures(scene));
  std::vector<Departure> departures = all_departures(scene);
  Departure broken = scene.departure(100);
  broken.x[0] = std::numeric_limits<double>::quiet_NaN();
  Departure far = scene.departure(101);
  far.x[0] += 1.0;
  departures.insert(departures.begin(), broken);
  departures.insert(departures.begin() + 3, far);
  const auto arrivals = run(scene, departures);
  EXPECT_EQ(arrivals.at(100).journey, Journey::bad_start);
  EXPECT_EQ(arrivals.at(101).journey, Journey::bad_start);
  for (std::uint64_t path = 0; path < 9; ++path) {
    EXPECT_EQ(arrivals.at(path).x, clean.at(path).x) << path;
  }
}

TEST(LaneTracker, SamplesLieOnThePathAtEquidistantParameters) {
  Scene scene(kCubics);
  Departure departure = scene.departure(4);
  departure.samples = 7;
  const Arrival arrival = run(scene, {departure}).at(4);
  ASSERT_EQ(arrival.samples.size(), 7u);
  PathSystem system(scene.homotopy);
  for (std::size_t k = 0; k < 7; ++k) {
    Point x = arrival.samples[k];
    const PathTime t = departure.contour.at(static_cast<double>(k + 1) / 7);
    // Rounding of H over its condition: some tens of 1e-16.
    EXPECT_LT(system.correct(x, t, {}, true).first, 1e-13) << k;
  }
}

TEST(LaneTracker, ATurnAboutADoubleRootEndsOnTheOtherSheet) {
  // x^2 + t (1 - x^2) - ... : both roots of (x - 1)^2 meet at t = 1.
  Scene scene("1\n(x - 1)^2;\n");
  Departure to_circle = scene.departure(0);
  to_circle.contour = Contour::segment(0, 0.99);
  const Arrival near = run(scene, {to_circle}).at(0);
  ASSERT_EQ(near.journey, Journey::arrived);
  const Contour turn = Contour::spiral(0.01, Complex(0, 2 * std::numbers::pi));
  const Arrival once = run(scene, {{0, turn, near.x, 0, 16, nullptr}}).at(0);
  const Arrival twice = run(scene, {{0, turn, once.x, 0, 16, nullptr}}).at(0);
  ASSERT_EQ(once.journey, Journey::arrived);
  ASSERT_EQ(twice.journey, Journey::arrived);
  const auto affine = [](const Point& x) { return x[0] / x[1]; };
  EXPECT_GT(std::abs(affine(once.x) - affine(near.x)), 0.01);
  EXPECT_LT(std::abs(affine(twice.x) - affine(near.x)), kArrivalAccuracy);
}

TEST(LaneTracker, APathIntoASingularityStopsBeforeIt) {
  // At t = 1/2 the two roots of t (x^2 + 1) + (1 - t) (x^2 - 1) meet: no path goes on.
  const System f = read_system({"f", "1\nx^2 + 1;\n"});
  const System g = read_system({"g", "1\nx^2 - 1;\n"});
  const Homotopy homotopy(f, g);
  const auto tracker = make_lane_tracker();
  const auto session = tracker->open(homotopy);
  const std::atomic<bool> stop{false};
  const Arrival arrival =
      follow(*session, {0, Contour::segment(0, 1), {1.0, 1.0}, 0, 0, nullptr}, stop);
  EXPECT_EQ(arrival.journey, Journey::step_too_small);
  EXPECT_NEAR(arrival.s, 0.5, 1e-6);
}

TEST(LaneTracker, ABudgetOfStepsEndsTheJourney) {
  Scene scene(kCubics, {.maximum_steps = 5});
  for (const auto& [path, arrival] : run(scene, all_departures(scene))) {
    EXPECT_EQ(arrival.journey, Journey::step_limit) << path;
    EXPECT_EQ(arrival.count.accepted + arrival.count.rejected, 5u);
  }
}

TEST(LaneTracker, ASetStopCancelsWhatIsUnderWay) {
  Scene scene(kCubics);
  Journeys journeys(all_departures(scene));
  const std::atomic<bool> stop{true};
  scene.session->run(journeys, stop);
  for (const auto& [path, arrival] : journeys.arrivals) {
    EXPECT_EQ(arrival.journey, Journey::cancelled) << path;
  }
}

class StopAt : public Watcher {
 public:
  explicit StopAt(double s) : s_(s) {}
  Verdict watch(const StepRecord& step, PathSystem&) noexcept override {
    seen.push_back(step.s);
    return step.s >= s_ ? Verdict::stop : Verdict::go_on;
  }
  std::vector<double> seen;

 private:
  double s_;
};

TEST(LaneTracker, AWatcherSeesEveryStepAndMayEndTheJourney) {
  Scene scene(kCubics);
  StopAt watcher(0.5);
  Departure departure = scene.departure(2);
  departure.watcher = &watcher;
  const Arrival arrival = run(scene, {departure}).at(2);
  EXPECT_EQ(arrival.journey, Journey::stopped);
  EXPECT_EQ(watcher.seen.size(), arrival.count.accepted);
  EXPECT_EQ(watcher.seen.back(), arrival.s);
  EXPECT_GE(arrival.s, 0.5);
  EXPECT_TRUE(std::is_sorted(watcher.seen.begin(), watcher.seen.end()));
}

TEST(LaneTracker, MoreCareTakesShorterSteps) {
  Scene scene(kCubics);
  Departure careful = scene.departure(2);
  careful.care = 2;
  const auto plain = run(scene, {scene.departure(2)}).at(2);
  const auto tight = run(scene, {careful}).at(2);
  EXPECT_GT(tight.count.accepted, plain.count.accepted);
}

std::uint64_t steps_of(LanePredictor predictor, double tolerance) {
  Scene scene(kCubics, {.tolerance = tolerance, .maximum_steps = 1000000, .predictor = predictor});
  std::uint64_t steps = 0;
  for (const auto& [path, arrival] : run(scene, all_departures(scene))) {
    EXPECT_EQ(arrival.journey, Journey::arrived) << to_string(predictor) << ' ' << path;
    steps += arrival.count.accepted;
  }
  return steps;
}

TEST(LaneTracker, APredictorOfHigherOrderTakesFewerSteps) {
  const double tolerance = 1e-5;
  const std::uint64_t cubic = steps_of(LanePredictor::cubic, tolerance);
  EXPECT_LT(steps_of(LanePredictor::quintic, tolerance), cubic);
  EXPECT_LT(2 * cubic, steps_of(LanePredictor::tangent, tolerance));
}

TEST(LaneTracker, ManySessionsArriveWhereOneDoes) {
  Scene scene(kCubics);
  const auto together = run(scene, all_departures(scene));
  std::vector<std::map<std::uint64_t, Arrival>> parts(3);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    threads.emplace_back([&, k] {
      std::vector<Departure> own;
      for (std::uint64_t path = k; path < 9; path += parts.size()) {
        own.push_back(scene.departure(path));
      }
      Journeys journeys(std::move(own));
      const std::atomic<bool> stop{false};
      scene.tracker->open(scene.homotopy)->run(journeys, stop);
      parts[k] = std::move(journeys.arrivals);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& part : parts) {
    for (const auto& [path, arrival] : part) EXPECT_EQ(arrival.x, together.at(path).x) << path;
  }
}

TEST(EveryTarget, ArrivesAtTheSamePointsWithinAccuracy) {
  std::map<std::uint64_t, Arrival> expected;
  ASSERT_GE(targets().size(), 1u);
  for (const std::int64_t target : targets()) {
    const Target chosen(target);
    Scene scene(kCubics);
    const auto arrivals = run(scene, all_departures(scene));
    if (expected.empty()) expected = arrivals;
    for (const auto& [path, arrival] : arrivals) {
      ASSERT_EQ(arrival.journey, Journey::arrived) << lane_target() << path;
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(
            std::abs(arrival.x[i] / arrival.x[2] - expected.at(path).x[i] / expected.at(path).x[2]),
            kArrivalAccuracy)
            << lane_target() << path;
      }
    }
  }
}

TEST(EveryTarget, GivesTheSameBytesWhateverTheNeighbours) {
  for (const std::int64_t target : targets()) {
    const Target chosen(target);
    Scene scene(kCubics);
    const auto together = run(scene, all_departures(scene));
    for (std::uint64_t path = 0; path < 9; ++path) {
      EXPECT_EQ(run(scene, {scene.departure(path)}).at(path).x, together.at(path).x)
          << lane_target() << path;
    }
  }
}

TEST(EveryTarget, HasTheWidthOfItsVectors) {
  const std::map<std::string, std::size_t> widths = {{"AVX3", 8},  {"AVX2", 4},   {"SSE4", 2},
                                                     {"SSSE3", 2}, {"SCALAR", 1}, {"EMU128", 2}};
  for (const std::int64_t target : targets()) {
    const Target chosen(target);
    const auto known = widths.find(lane_target());
    if (known != widths.end()) {
      EXPECT_EQ(lane_width(), known->second) << lane_target();
    }
  }
}

TEST(LaneOptionsRules, AreAllNamedWhenBroken) {
  EXPECT_TRUE(validate(LaneOptions{}).empty());
  EXPECT_EQ(validate({.tolerance = 0, .maximum_steps = 0}).size(), 2u);
  EXPECT_THROW(make_lane_tracker({.tolerance = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
