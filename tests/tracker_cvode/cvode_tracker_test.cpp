// SPDX-License-Identifier: MIT
// Do segments with CVODE stay on a path known in closed form, and does each way of ending one
// occur?
#include "moivre/tracker_cvode/cvode_tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "moivre/polynomial/read.h"
#include "moivre/tracker/session.h"

namespace moivre {
namespace {

// Ends are corrected to 1e-9 and less (tracker/path_system.h).
constexpr double kEndAccuracy = 1e-8;
const Complex kTarget(3, 4);

System equation(const std::string& text) { return read_system({"test", "1\n" + text + ";\n"}); }

/// x^2 = 1 becomes `target`; from x = 1.
struct Scene {
  explicit Scene(const std::string& target = "x^2 - 3 - 4*i", const CvodeOptions& options = {})
      : homotopy(equation(target), equation("x^2 - 1")),
        session(make_cvode_tracker(options)->open(homotopy)) {}

  static PathSegment segment() { return {0, Contour::segment(0, 1), {1.0, 1.0}, 0, 0, nullptr}; }
  SegmentResult go(const PathSegment& segment) { return follow(*session, segment, stop); }

  Homotopy homotopy;
  std::unique_ptr<TrackerSession> session;
  std::atomic<bool> stop{false};
};

Complex affine(std::span<const Complex> x) { return x[0] / x[1]; }

/// The path in closed form: x(t)^2 = 1 + (c - 1) t, never on the negative axis.
Complex root_at(Complex t) { return std::sqrt(1.0 + (kTarget - 1.0) * t); }

class Watching : public Watcher {
 public:
  explicit Watching(double stop_at = 2) : stop_at_(stop_at) {}
  Verdict watch(const StepRecord& step, PathSystem&) noexcept override {
    s.push_back(step.s);
    drift = std::max(drift, std::abs(affine(step.x) - root_at(step.t.t)));
    correction = std::max(correction, step.correction);
    return step.s >= stop_at_ ? Verdict::stop : Verdict::go_on;
  }

  std::vector<double> s;
  double drift = 0;       ///< largest distance of a point from the path
  double correction = 0;  ///< largest first correction of an accepted step

 private:
  double stop_at_;
};

TEST(CvodeTracker, FollowsASquareRootWithEveryMethod) {
  for (const CvodeMethod method :
       {CvodeMethod::bdf_projection, CvodeMethod::bdf, CvodeMethod::adams}) {
    for (const CvodeIteration iteration : {CvodeIteration::fixed_point, CvodeIteration::newton}) {
      SCOPED_TRACE(to_string(method) + " " + to_string(iteration));
      Scene scene("x^2 - 3 - 4*i", {.method = method, .iteration = iteration, .rtol = 1e-4});
      const SegmentResult reached = scene.go(Scene::segment());
      EXPECT_EQ(reached.status, SegmentStatus::arrived);
      EXPECT_EQ(reached.s, 1);
      EXPECT_EQ(reached.t.rest, 0.0);
      EXPECT_LT(std::abs(affine(reached.x) - Complex(2, 1)), kEndAccuracy);
    }
  }
}

TEST(CvodeTracker, NewtonsIterationPaysItsJacobianInRightHandSides) {
  const SegmentResult substituted = Scene("x^2 - 3 - 4*i", {.rtol = 1e-6}).go(Scene::segment());
  const SegmentResult solved =
      Scene("x^2 - 3 - 4*i", {.iteration = CvodeIteration::newton, .rtol = 1e-6})
          .go(Scene::segment());
  const double per_step[]{static_cast<double>(substituted.count.work.linearizations) /
                              static_cast<double>(substituted.count.accepted),
                          static_cast<double>(solved.count.work.linearizations) /
                              static_cast<double>(solved.count.accepted)};
  EXPECT_GT(per_step[1], per_step[0]);
}

TEST(CvodeTracker, ProjectionTakesAwayTheDriftOfTheIntegrator) {
  double drift[2];
  const CvodeMethod methods[]{CvodeMethod::bdf, CvodeMethod::bdf_projection};
  for (std::size_t k = 0; k < 2; ++k) {
    Scene scene("x^2 - 3 - 4*i", {.method = methods[k]});
    Watching watcher;
    PathSegment segment = Scene::segment();
    segment.watcher = &watcher;
    scene.go(segment);
    drift[k] = watcher.drift;
  }
  EXPECT_GT(drift[0], 1e-4);
  EXPECT_LT(drift[1], kEndAccuracy);
}

TEST(CvodeTracker, MoreCareTakesMoreSteps) {
  for (const CvodeMethod method : {CvodeMethod::bdf_projection, CvodeMethod::bdf}) {
    Scene scene("x^2 - 3 - 4*i", {.method = method});
    PathSegment careful = Scene::segment();
    careful.tolerance_level = 2;
    EXPECT_GT(scene.go(careful).count.accepted, scene.go(Scene::segment()).count.accepted);
  }
}

TEST(CvodeTracker, MoreCareTrustsOnlySmallCorrections) {
  Scene scene("x^2 - 3 - 4*i", {.rtol = 0.5});
  double largest[3];
  for (int tolerance_level = 0; tolerance_level < 3; ++tolerance_level) {
    Watching watcher;
    PathSegment segment = Scene::segment();
    segment.tolerance_level = tolerance_level;
    segment.watcher = &watcher;
    EXPECT_EQ(scene.go(segment).status, SegmentStatus::arrived);
    largest[tolerance_level] = watcher.correction;
    EXPECT_LE(watcher.correction,
              CorrectorOptions{}.largest_correction * std::pow(0.1, tolerance_level));
  }
  EXPECT_GT(largest[0], 0.01);
}

TEST(CvodeTracker, SamplesLieOnThePathAtEquidistantParameters) {
  Scene scene;
  PathSegment segment = Scene::segment();
  segment.samples = 7;
  const SegmentResult reached = scene.go(segment);
  ASSERT_EQ(reached.samples.size(), 7u);
  for (std::size_t k = 0; k < 7; ++k) {
    const double t = static_cast<double>(k + 1) / 7;
    EXPECT_LT(std::abs(affine(reached.samples[k]) - root_at(t)), 1e-13) << k;
  }
}

TEST(CvodeTracker, AWatcherSeesEveryStepAndMayStopTheSegment) {
  Scene scene;
  Watching watcher(0.5);
  PathSegment segment = Scene::segment();
  segment.watcher = &watcher;
  const SegmentResult reached = scene.go(segment);
  EXPECT_EQ(reached.status, SegmentStatus::stopped);
  EXPECT_EQ(watcher.s.size(), reached.count.accepted);
  EXPECT_EQ(watcher.s.back(), reached.s);
  EXPECT_GE(reached.s, 0.5);
  EXPECT_LT(reached.s, 1);
  EXPECT_TRUE(std::is_sorted(watcher.s.begin(), watcher.s.end()));
}

TEST(CvodeTracker, APointFarFromThePathIsABadStart) {
  Scene scene;
  PathSegment segment = Scene::segment();
  segment.x[0] = 2.0;
  EXPECT_EQ(scene.go(segment).status, SegmentStatus::bad_start);
  segment.x[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(scene.go(segment).status, SegmentStatus::bad_start);
}

TEST(CvodeTracker, ABudgetOfStepsEndsTheSegment) {
  Scene scene("x^2 - 3 - 4*i", {.maximum_steps = 3});
  const SegmentResult reached = scene.go(Scene::segment());
  EXPECT_EQ(reached.status, SegmentStatus::step_limit);
  EXPECT_EQ(reached.count.accepted, 3u);
}

TEST(CvodeTracker, APathIntoASingularityStopsBeforeIt) {
  // At t = 1/2 the two roots of t (x^2 + 1) + (1 - t) (x^2 - 1) meet at 0: no path goes on.
  Scene scene("x^2 + 1");
  const SegmentResult reached = scene.go(Scene::segment());
  EXPECT_EQ(reached.status, SegmentStatus::step_too_small);
  EXPECT_NEAR(reached.s, 0.5, 1e-6);
}

TEST(CvodeTracker, StepsThatNewtonRefusesCountAsRejected) {
  // So near the singularity at t = 1/2 the loose predictions are off, and CVODE's own error test
  // lets them pass.
  const SegmentResult reached = Scene("x^2 + 1 - i/100", {.rtol = 0.3}).go(Scene::segment());
  EXPECT_EQ(reached.status, SegmentStatus::arrived);
  EXPECT_GE(reached.count.rejected, 5u);
}

TEST(CvodeTracker, ACoordinateThatIsAllRoundingDoesNotSizeTheSteps) {
  // y = 0 on the path, and of the size of rounding errors where it is computed.
  const Homotopy homotopy(read_system({"f", "2\nx^2 - 3 - 4*i;\nx*y + x^2 - 3 - 4*i;\n"}),
                          read_system({"g", "2\nx^2 - 1;\nx*y + x^2 - 1;\n"}));
  const auto session = make_cvode_tracker()->open(homotopy);
  const std::atomic<bool> stop{false};
  const SegmentResult reached =
      follow(*session, {0, Contour::segment(0, 1), {1.0, 0.0, 1.0}, 0, 0, nullptr}, stop);
  EXPECT_EQ(reached.status, SegmentStatus::arrived);
  EXPECT_LE(reached.count.accepted, 2 * Scene().go(Scene::segment()).count.accepted);
}

TEST(CvodeTracker, ASetStopCancelsTheSegment) {
  Scene scene;
  scene.stop = true;
  EXPECT_EQ(scene.go(Scene::segment()).status, SegmentStatus::cancelled);
}

TEST(CvodeTracker, OtherSegmentsInBetweenChangeNoBit) {
  Scene scene;
  const SegmentResult first = scene.go(Scene::segment());
  PathSegment other = Scene::segment();
  other.x[0] = -1.0;
  other.tolerance_level = 1;
  other.samples = 5;
  scene.go(other);
  other.x[0] = 9.0;
  scene.go(other);
  const SegmentResult again = scene.go(Scene::segment());
  EXPECT_EQ(again.x, first.x);
  EXPECT_EQ(again.count.accepted, first.count.accepted);
  EXPECT_EQ(again.count.work.linearizations, first.count.work.linearizations);
}

TEST(CvodeOptionsRules, AreAllNamedWhenBroken) {
  EXPECT_TRUE(validate(CvodeOptions{}).empty());
  EXPECT_EQ(validate({.rtol = 0, .maximum_steps = 0}).size(), 2u);
  EXPECT_EQ(validate({.rtol = std::numeric_limits<double>::quiet_NaN()}).size(), 1u);
  EXPECT_THROW(make_cvode_tracker({.rtol = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
