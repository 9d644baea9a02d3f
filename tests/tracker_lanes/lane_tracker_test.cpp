// SPDX-License-Identifier: MIT
// Do segments in lanes arrive where they should, and does the end of each depend on the segment
// alone?
#include "moivre/tracker_lanes/lane_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <thread>

#include "../tracker/segments.h"
#include "every_target.h"
#include "moivre/start/total_degree.h"

namespace moivre {
namespace {

using test::SegmentList;
using test::Target;
using test::targets;

// Ends are corrected to 1e-9 and less (tracker/path_system.h).
constexpr double kEndAccuracy = 1e-8;

/// A system, its total-degree homotopy, and a session on it.
struct Scene {
  explicit Scene(const std::string& text, const LaneOptions& options = {})
      : f(read_system({"test", text})),
        start(total_degree_start(degrees(f), 1)),
        homotopy(f, start_system(start, f.variables)),
        tracker(make_lane_tracker(options)),
        session(tracker->open(homotopy)) {}

  PathSegment segment(std::uint64_t path) const {
    return {path, Contour::segment(0, 1), start_point(start, path), 0, 0, nullptr};
  }

  System f;
  TotalDegreeStart start;
  Homotopy homotopy;
  std::unique_ptr<Tracker> tracker;
  std::unique_ptr<TrackerSession> session;
};

std::map<std::uint64_t, SegmentResult> run(Scene& scene, std::vector<PathSegment> segments) {
  SegmentList list(std::move(segments));
  const std::atomic<bool> stop{false};
  scene.session->run(list, stop);
  return std::move(list.results);
}

std::vector<PathSegment> all_segments(const Scene& scene) {
  std::vector<PathSegment> segments;
  for (std::uint64_t path = 0; path < scene.start.paths; ++path) {
    segments.push_back(scene.segment(path));
  }
  return segments;
}

// Nine paths: more than any target has lanes.
const char* const kCubics = "2\nx^3 + 2*x*y - y^2 - 3; y^3 - x^2*y + 4*x - 1;\n";

TEST(LaneTracker, EveryPathOfTwoCubicsArrivesOnTheTarget) {
  Scene scene(kCubics);
  const auto results = run(scene, all_segments(scene));
  ASSERT_EQ(results.size(), 9u);
  for (const auto& [path, reached] : results) {
    EXPECT_EQ(reached.status, SegmentStatus::arrived) << path;
    EXPECT_EQ(reached.s, 1);
    PathSystem system(scene.homotopy);
    Point x = reached.x;
    EXPECT_LT(system.correct(x, {1, 0}, {}, true).first, kEndAccuracy) << path;
  }
}

// At a point of norm 1 the equation is 3^-400, whose square no double holds.
TEST(LaneTracker, APathOfHighDegreeArrives) {
  Scene scene("2\nx^800 - 1; y^3 - x - 2;\n");
  const auto results = run(scene, {scene.segment(0), scene.segment(1), scene.segment(999)});
  ASSERT_EQ(results.size(), 3u);
  for (const auto& [path, reached] : results) {
    EXPECT_EQ(reached.status, SegmentStatus::arrived) << path;
  }
}

TEST(LaneTracker, SegmentsDependNeitherOnNeighboursNorOnTheLane) {
  Scene scene(kCubics);
  const auto together = run(scene, all_segments(scene));
  for (std::uint64_t path = 0; path < 9; ++path) {
    const auto alone = run(scene, {scene.segment(path)});
    EXPECT_EQ(alone.at(path).x, together.at(path).x) << path;
    EXPECT_EQ(alone.at(path).count.accepted, together.at(path).count.accepted);
  }
}

TEST(LaneTracker, AnImpossibleSegmentSpoilsNoOtherLane) {
  Scene scene(kCubics);
  const auto clean = run(scene, all_segments(scene));
  std::vector<PathSegment> segments = all_segments(scene);
  PathSegment broken = scene.segment(100);
  broken.x[0] = std::numeric_limits<double>::quiet_NaN();
  PathSegment far = scene.segment(101);
  far.x[0] += 1.0;
  segments.insert(segments.begin(), broken);
  segments.insert(segments.begin() + 3, far);
  const auto results = run(scene, segments);
  EXPECT_EQ(results.at(100).status, SegmentStatus::bad_start);
  EXPECT_EQ(results.at(101).status, SegmentStatus::bad_start);
  for (std::uint64_t path = 0; path < 9; ++path) {
    EXPECT_EQ(results.at(path).x, clean.at(path).x) << path;
  }
}

TEST(LaneTracker, SamplesLieOnThePathAtEquidistantParameters) {
  Scene scene(kCubics);
  PathSegment segment = scene.segment(4);
  segment.samples = 7;
  const SegmentResult reached = run(scene, {segment}).at(4);
  ASSERT_EQ(reached.samples.size(), 7u);
  PathSystem system(scene.homotopy);
  for (std::size_t k = 0; k < 7; ++k) {
    Point x = reached.samples[k];
    const PathTime t = segment.contour.at(static_cast<double>(k + 1) / 7);
    // Rounding of H over its condition: some tens of 1e-16.
    EXPECT_LT(system.correct(x, t, {}, true).first, 1e-13) << k;
  }
}

TEST(LaneTracker, ATurnAboutADoubleRootEndsOnTheOtherSheet) {
  // x^2 + t (1 - x^2) - ... : both roots of (x - 1)^2 meet at t = 1.
  Scene scene("1\n(x - 1)^2;\n");
  PathSegment to_circle = scene.segment(0);
  to_circle.contour = Contour::segment(0, 0.99);
  const SegmentResult near = run(scene, {to_circle}).at(0);
  ASSERT_EQ(near.status, SegmentStatus::arrived);
  const Contour turn = Contour::spiral(0.01, Complex(0, 2 * std::numbers::pi));
  const SegmentResult once = run(scene, {{0, turn, near.x, 0, 16, nullptr}}).at(0);
  const SegmentResult twice = run(scene, {{0, turn, once.x, 0, 16, nullptr}}).at(0);
  ASSERT_EQ(once.status, SegmentStatus::arrived);
  ASSERT_EQ(twice.status, SegmentStatus::arrived);
  const auto affine = [](const Point& x) { return x[0] / x[1]; };
  EXPECT_GT(std::abs(affine(once.x) - affine(near.x)), 0.01);
  EXPECT_LT(std::abs(affine(twice.x) - affine(near.x)), kEndAccuracy);
}

TEST(LaneTracker, APathIntoASingularityStopsBeforeIt) {
  // At t = 1/2 the two roots of t (x^2 + 1) + (1 - t) (x^2 - 1) meet: no path goes on.
  const System f = read_system({"f", "1\nx^2 + 1;\n"});
  const System g = read_system({"g", "1\nx^2 - 1;\n"});
  const Homotopy homotopy(f, g);
  const auto tracker = make_lane_tracker();
  const auto session = tracker->open(homotopy);
  const std::atomic<bool> stop{false};
  const SegmentResult reached =
      follow(*session, {0, Contour::segment(0, 1), {1.0, 1.0}, 0, 0, nullptr}, stop);
  EXPECT_EQ(reached.status, SegmentStatus::step_too_small);
  EXPECT_NEAR(reached.s, 0.5, 1e-6);
}

TEST(LaneTracker, ABudgetOfStepsEndsTheSegment) {
  Scene scene(kCubics, {.maximum_steps = 5});
  for (const auto& [path, reached] : run(scene, all_segments(scene))) {
    EXPECT_EQ(reached.status, SegmentStatus::step_limit) << path;
    EXPECT_EQ(reached.count.accepted + reached.count.rejected, 5u);
  }
}

TEST(LaneTracker, ASetStopCancelsWhatIsUnderWay) {
  Scene scene(kCubics);
  SegmentList list(all_segments(scene));
  const std::atomic<bool> stop{true};
  scene.session->run(list, stop);
  for (const auto& [path, reached] : list.results) {
    EXPECT_EQ(reached.status, SegmentStatus::cancelled) << path;
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

TEST(LaneTracker, AWatcherSeesEveryStepAndMayEndTheSegment) {
  Scene scene(kCubics);
  StopAt watcher(0.5);
  PathSegment segment = scene.segment(2);
  segment.watcher = &watcher;
  const SegmentResult reached = run(scene, {segment}).at(2);
  EXPECT_EQ(reached.status, SegmentStatus::stopped);
  EXPECT_EQ(watcher.seen.size(), reached.count.accepted);
  EXPECT_EQ(watcher.seen.back(), reached.s);
  EXPECT_GE(reached.s, 0.5);
  EXPECT_TRUE(std::is_sorted(watcher.seen.begin(), watcher.seen.end()));
}

TEST(LaneTracker, MoreCareTakesShorterSteps) {
  Scene scene(kCubics);
  PathSegment careful = scene.segment(2);
  careful.tolerance_level = 2;
  const auto plain = run(scene, {scene.segment(2)}).at(2);
  const auto tight = run(scene, {careful}).at(2);
  EXPECT_GT(tight.count.accepted, plain.count.accepted);
}

std::uint64_t steps_of(LanePredictor predictor, double tolerance) {
  Scene scene(kCubics, {.tolerance = tolerance, .maximum_steps = 1000000, .predictor = predictor});
  std::uint64_t steps = 0;
  for (const auto& [path, reached] : run(scene, all_segments(scene))) {
    EXPECT_EQ(reached.status, SegmentStatus::arrived) << to_string(predictor) << ' ' << path;
    steps += reached.count.accepted;
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
  const auto together = run(scene, all_segments(scene));
  std::vector<std::map<std::uint64_t, SegmentResult>> parts(3);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    threads.emplace_back([&, k] {
      std::vector<PathSegment> own;
      for (std::uint64_t path = k; path < 9; path += parts.size()) {
        own.push_back(scene.segment(path));
      }
      SegmentList list(std::move(own));
      const std::atomic<bool> stop{false};
      scene.tracker->open(scene.homotopy)->run(list, stop);
      parts[k] = std::move(list.results);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& part : parts) {
    for (const auto& [path, reached] : part) EXPECT_EQ(reached.x, together.at(path).x) << path;
  }
}

TEST(EveryTarget, ArrivesAtTheSamePointsWithinAccuracy) {
  std::map<std::uint64_t, SegmentResult> expected;
  ASSERT_GE(targets().size(), 1u);
  for (const std::int64_t target : targets()) {
    const Target chosen(target);
    Scene scene(kCubics);
    const auto results = run(scene, all_segments(scene));
    if (expected.empty()) expected = results;
    for (const auto& [path, reached] : results) {
      ASSERT_EQ(reached.status, SegmentStatus::arrived) << lane_target() << path;
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(
            std::abs(reached.x[i] / reached.x[2] - expected.at(path).x[i] / expected.at(path).x[2]),
            kEndAccuracy)
            << lane_target() << path;
      }
    }
  }
}

TEST(EveryTarget, GivesTheSameBytesWhateverTheNeighbours) {
  for (const std::int64_t target : targets()) {
    const Target chosen(target);
    Scene scene(kCubics);
    const auto together = run(scene, all_segments(scene));
    for (std::uint64_t path = 0; path < 9; ++path) {
      EXPECT_EQ(run(scene, {scene.segment(path)}).at(path).x, together.at(path).x)
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
