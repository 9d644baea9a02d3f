// SPDX-License-Identifier: MIT
// Does each tiny problem get the verdict that is known for it: regular, winding number, infinity,
// or the reason of a failure?
#include "moivre/endgame/endgame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "moivre/polynomial/read.h"
#include "moivre/start/total_degree.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

constexpr std::uint64_t kSeeds = 4;
/// Simple ends are known nearly to the last digit; an end of winding number m by Cauchy's integral.
constexpr double kRegularAccuracy = 1e-12;
constexpr double kSingularAccuracy = 1e-6;

/// |1 - t| of the first of the circles that are made up. A ripple of this order is the highest that
/// the samples resolve.
constexpr double kOutpost = 1e-5;
constexpr double kRippleOrder = 7;

System read(const std::string& text) { return read_system({"test", text}); }

/// A verdict and the segments that led to it.
struct Followed {
  PathEnd end;
  int segments = 0;

  Point affine() const {
    Point x(end.x.begin(), end.x.end() - 1);
    for (Complex& xi : x) xi /= end.x.back();
    return x;
  }
};

/// The paths of t F + (1 - t) G, G of the total degree; nothing is eliminated or scaled.
class Paths {
 public:
  Paths(const std::string& text, std::uint64_t seed)
      : f_(read(text)),
        start_(total_degree_start(degrees(f_), seed)),
        homotopy_(f_, start_system(start_, f_.variables)) {}

  std::uint64_t count() const { return start_.paths; }

  Followed follow_path(std::uint64_t path, const CvodeOptions& cvode = {},
                       const EndgameOptions& options = {}, bool stop = false) const {
    return follow_from(start_point(start_, path), path, cvode, options, stop);
  }

  Followed follow_from(const Point& start, std::uint64_t path, const CvodeOptions& cvode = {},
                       const EndgameOptions& options = {}, bool stop = false) const {
    const std::atomic<bool> token{stop};
    const auto tracker = make_cvode_tracker(cvode);
    const auto session = tracker->open(homotopy_);
    PathSystem scratch(homotopy_);
    Endgame endgame(options, homotopy_.chart(), path, 0);
    std::optional<PathSegment> segment = endgame.depart(start);
    Followed followed;
    while (segment) {
      ++followed.segments;
      segment = endgame.accept(follow(*session, std::move(*segment), token), scratch);
    }
    followed.end = endgame.end();
    return followed;
  }

  /// The first segment is followed; every later one gets nowhere.
  PathEnd follow_whole_way_only(std::uint64_t path) const {
    const std::atomic<bool> go_on{false};
    const auto tracker = make_cvode_tracker();
    const auto session = tracker->open(homotopy_);
    PathSystem scratch(homotopy_);
    Endgame endgame({}, homotopy_.chart(), path, 0);
    PathSegment first = endgame.depart(start_point(start_, path));
    auto next = endgame.accept(follow(*session, std::move(first), go_on), scratch);
    while (next) {
      SegmentResult stuck;
      stuck.status = SegmentStatus::step_too_small;
      stuck.x = next->x;
      next = endgame.accept(std::move(stuck), scratch);
    }
    return endgame.end();
  }

  /// Circles of one turn about (shift : 1 : x_0), the shift another for each radius, whose samples
  /// have a ripple.
  PathEnd end_of_circles(double x0, const std::vector<double>& shifts, double ripple) const {
    return end_of_circles([&](std::size_t circle, double turn) {
             const double angle = 2 * std::numbers::pi * kRippleOrder * turn;
             const double shift = shifts[std::min(circle, shifts.size() - 1)];
             return Point{shift + std::polar(ripple, angle), 1, x0};
           })
        .end;
  }

  struct Circles {
    PathEnd end;
    std::size_t count = 0;
  };

  /// Circles of one turn, each a quarter as wide as the one before, made of the points of each at a
  /// share of its turn.
  Circles end_of_circles(const std::function<Point(std::size_t, double)>& point) const {
    PathSystem scratch(homotopy_);
    Endgame endgame({}, homotopy_.chart(), 0, 0);
    endgame.depart(start_point(start_, 0));
    StepRecord step;
    const Point first = point(0, 0);
    step.t = PathTime(1 - kOutpost, kOutpost);
    step.x = first;
    endgame.watch(step, scratch);
    SegmentResult reached;
    reached.t = step.t;
    reached.x = first;
    reached.status = SegmentStatus::step_too_small;
    std::size_t circle = 0;
    while (const auto next = endgame.accept(std::move(reached), scratch)) {
      reached = SegmentResult{};
      reached.status = SegmentStatus::arrived;
      for (int k = 1; k <= next->samples; ++k) {
        reached.samples.push_back(point(circle, static_cast<double>(k) / next->samples));
      }
      if (next->samples > 0) ++circle;
      reached.x = point(circle, 0);
    }
    return {endgame.end(), circle};
  }

  std::vector<Followed> follow_all() const {
    std::vector<Followed> all;
    for (std::uint64_t path = 0; path < count(); ++path) all.push_back(follow_path(path));
    return all;
  }

 private:
  System f_;
  TotalDegreeStart start_;
  Homotopy homotopy_;
};

/// check(paths) for several seeds; a failure names the seed.
template <class Check>
void for_seeds(const std::string& text, const Check& check) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    check(Paths(text, seed));
  }
}

double distance(const Point& x, const Point& y) {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::abs(x[i] - y[i]));
  return largest;
}

std::vector<const Followed*> ending_at(const std::vector<Followed>& all, const Point& x,
                                       double within) {
  std::vector<const Followed*> found;
  for (const Followed& path : all) {
    if (path.end.status == PathStatus::finite && distance(path.affine(), x) < within) {
      found.push_back(&path);
    }
  }
  return found;
}

int count_of(const std::vector<Followed>& all, PathStatus status) {
  return static_cast<int>(std::count_if(
      all.begin(), all.end(), [&](const Followed& path) { return path.end.status == status; }));
}

TEST(Endgame, IsLeftOutOnRegularEnds) {
  for_seeds("2\n x^2 + y^2 - 5;\n x*y - 2;\n", [](const Paths& paths) {
    const auto all = paths.follow_all();
    for (const Followed& path : all) {
      EXPECT_EQ(path.end.status, PathStatus::finite);
      EXPECT_EQ(path.segments, 1);
      EXPECT_EQ(path.end.winding, std::nullopt);
      EXPECT_FALSE(path.end.singular);
    }
    for (const Point& root : {Point{1, 2}, Point{2, 1}, Point{-1, -2}, Point{-2, -1}}) {
      EXPECT_EQ(ending_at(all, root, kRegularAccuracy).size(), 1U);
    }
  });
}

TEST(Endgame, StatesAnAccuracyThatHoldsAtARegularEnd) {
  for_seeds("1\n x^3 - 6*x^2 + 11*x - 6;\n", [](const Paths& paths) {
    for (const Followed& path : paths.follow_all()) {
      const Complex x = path.affine()[0];
      const double error = std::abs(x - std::round(x.real()));
      EXPECT_LE(error, 10 * (path.end.accuracy + 1e-15) * std::abs(x));
      EXPECT_LT(error, kRegularAccuracy);
    }
  });
}

/// All paths of `text` that end at x: `count` of them, singular, each of winding number `winding`.
void expect_winding(const std::vector<Followed>& all, const Point& x, std::size_t count,
                    int winding) {
  const auto found = ending_at(all, x, kSingularAccuracy);
  EXPECT_EQ(found.size(), count);
  for (const Followed* path : found) {
    EXPECT_EQ(path->end.winding, winding);
    EXPECT_TRUE(path->end.singular);
    EXPECT_GT(path->segments, winding);
  }
}

TEST(Endgame, DoubleRootHasWindingNumberTwo) {
  for_seeds("2\n x^2 + y^2 - 2;\n x*y - 1;\n", [](const Paths& paths) {
    const auto all = paths.follow_all();
    expect_winding(all, {1, 1}, 2, 2);
    expect_winding(all, {-1, -1}, 2, 2);
  });
}

TEST(Endgame, TripleRootHasWindingNumberThree) {
  for_seeds("2\n x^3 - 3*x^2 + 3*x - 1;\n y^2 - x - 1;\n", [](const Paths& paths) {
    const auto all = paths.follow_all();
    expect_winding(all, {1, std::sqrt(2.0)}, 3, 3);
    expect_winding(all, {1, -std::sqrt(2.0)}, 3, 3);
  });
}

TEST(Endgame, TwoCyclesAtOnePointHaveTwoTurnsEach) {
  for_seeds("2\n (x - 1)^2*(x + 2);\n (y - x)^2;\n", [](const Paths& paths) {
    const auto all = paths.follow_all();
    expect_winding(all, {1, 1}, 4, 2);
    expect_winding(all, {-2, -2}, 2, 2);
  });
}

TEST(Endgame, RootOfMultiplicityEightHasWindingNumberEight) {
  // Start roots have modulus 1: a multiple root at x = 1 would be near one of them for some seeds.
  for_seeds("1\n (2*x - 1)^8;\n", [](const Paths& paths) {
    const auto all = paths.follow_all();
    expect_winding(all, {0.5}, 8, 8);
  });
}

TEST(Endgame, RegularEndAtInfinityIsToldFromTheFiniteOne) {
  // x y = 1, x y + x = 3: the one root (2, 1/2), and the regular end (0 : 1 : 0).
  for_seeds("2\n x*y - 1;\n x*y + x - 3;\n", [](const Paths& paths) {
    const auto all = paths.follow_all();
    EXPECT_EQ(ending_at(all, {2, 0.5}, kRegularAccuracy).size(), 1U);
    EXPECT_EQ(count_of(all, PathStatus::at_infinity), 3);
    EXPECT_EQ(count_of(all, PathStatus::failed), 0);
  });
}

TEST(Endgame, SimpleEndAtInfinityNeedsOneTurn) {
  // The lines meet in no finite point, and their one path ends where J is regular.
  for_seeds("2\n x + y - 1;\n x + y - 2;\n", [](const Paths& paths) {
    const Followed path = paths.follow_path(0);
    EXPECT_EQ(path.end.status, PathStatus::at_infinity);
    // The way, to a radius that all paths have in common, and round.
    EXPECT_LE(path.segments, 3);
    EXPECT_EQ(path.end.winding, std::nullopt);
  });
}

TEST(Endgame, SingularEndsAtInfinityAreAtInfinity) {
  // y = x^2 + 1 and its copy moved up by x + 1: (-1, 2), and (0 : 1 : 0) three times.
  for_seeds("2\n x^2 + 1 - y;\n x^2 + x + 2 - y;\n", [](const Paths& paths) {
    const auto all = paths.follow_all();
    EXPECT_EQ(ending_at(all, {-1, 2}, kRegularAccuracy).size(), 1U);
    EXPECT_EQ(count_of(all, PathStatus::at_infinity), 3);
  });
}

// Four paths go towards z = infinity like (1 - t)^(-1/4) until z is as large as the root at -3060,
// where two of them turn.
TEST(Endgame, FiniteRootsBesideASingularPointAtInfinityAreNotAtInfinity) {
  const std::string cubics =
      "3\n (3*y*z + 5*z - 4)^2;\n x*y + 2*x + 9;\n"
      " -8*x^2 + 21*x*y*z - 6*x*y + 35*x*z - 28*x + 6*y^2*z - 6*y*z^2 - 8*y*z - 8*y - 10*z^2 - "
      "24*z + 20;\n";
  for_seeds(cubics, [](const Paths& paths) {
    const int infinite = count_of(paths.follow_all(), PathStatus::at_infinity);
    EXPECT_LE(infinite, static_cast<int>(paths.count()) - 6);
  });
}

TEST(Endgame, TwoNearRootsAreTwoRegularEnds) {
  constexpr double kHalfGap = 1e-5;
  for_seeds("2\n x^2 - 2*x + 1 - 1e-10;\n y - x;\n", [](const Paths& paths) {
    const auto all = paths.follow_all();
    for (const double x : {1 - kHalfGap, 1 + kHalfGap}) {
      const auto found = ending_at(all, {x, x}, kHalfGap / 100);
      ASSERT_EQ(found.size(), 1U);
      EXPECT_FALSE(found.front()->end.singular);
      EXPECT_EQ(found.front()->end.winding.value_or(1), 1);
    }
  });
}

TEST(Endgame, RootsNearerThanAnyCircleTellsAreNeverOneDoubleRoot) {
  // Their branch point is 1e-12 from t = 1: a circle closes after two turns, as round a double
  // root.
  constexpr double kHalfGap = 1e-6;
  for_seeds("2\n x^2 - 2*x + 1 - 1e-12;\n y - x;\n", [](const Paths& paths) {
    const auto all = paths.follow_all();
    EXPECT_GE(count_of(all, PathStatus::finite), 1);
    for (const Followed& path : all) {
      if (path.end.status == PathStatus::failed) continue;
      EXPECT_EQ(path.end.winding.value_or(1), 1);
      EXPECT_NEAR(std::abs(path.affine()[0] - 1.0), kHalfGap, kHalfGap / 10);
    }
  });
}

TEST(Endgame, RootOfSizeAMillionIsFinite) {
  constexpr double kFar = 1e6;
  for_seeds("2\n (x - 1000000)*(x - 1);\n y^2 - x;\n", [](const Paths& paths) {
    const auto all = paths.follow_all();
    EXPECT_EQ(count_of(all, PathStatus::finite), 4);
    for (const double y : {1e3, -1e3}) {
      EXPECT_EQ(ending_at(all, {kFar, y}, kFar * kRegularAccuracy).size(), 1U);
    }
    for (const double y : {1.0, -1.0}) {
      EXPECT_EQ(ending_at(all, {1, y}, kSingularAccuracy).size(), 1U);
    }
  });
}

TEST(Endgame, StepLimitIsAFailureThatTellsHowFarThePathCame) {
  CvodeOptions short_of_steps;
  short_of_steps.maximum_steps = 3;
  for_seeds("1\n x^5 - 3*x + 1;\n", [&](const Paths& paths) {
    const Followed path = paths.follow_path(0, short_of_steps);
    EXPECT_EQ(path.end.status, PathStatus::failed);
    EXPECT_EQ(path.end.failure, Failure::step_limit);
    EXPECT_LT(std::abs(path.end.t), 1);
    EXPECT_GT(std::abs(path.end.t), 0);
  });
}

TEST(Endgame, PathThatEndsOnTheWayFailsWithAStepTooSmall) {
  const System f = read("1\n x^2 + 1;\n");
  const System g = read("1\n x^2 - 1;\n");
  const Homotopy homotopy(f, g);
  const std::atomic<bool> go_on{false};
  const auto tracker = make_cvode_tracker();
  const auto session = tracker->open(homotopy);
  PathSystem scratch(homotopy);
  Endgame endgame({}, homotopy.chart(), 0, 0);
  // x^2 = 1 - 2 t: both paths meet at x = 0 for t = 1/2, where the tangent is infinite.
  std::optional<PathSegment> segment = endgame.depart({1, 1});
  while (segment) {
    segment = endgame.accept(follow(*session, std::move(*segment), go_on), scratch);
  }
  EXPECT_EQ(endgame.end().status, PathStatus::failed);
  EXPECT_EQ(endgame.end().failure, Failure::step_too_small);
  EXPECT_NEAR(std::abs(endgame.end().t), 0.5, 1e-3);
}

TEST(Endgame, PointThatIsNoStartIsABadStart) {
  for_seeds("1\n x^3 - 2;\n", [](const Paths& paths) {
    const Followed path = paths.follow_from({0, 1}, 0);
    EXPECT_EQ(path.end.status, PathStatus::failed);
    EXPECT_EQ(path.end.failure, Failure::bad_start);
  });
}

TEST(Endgame, StopTokenCancelsThePath) {
  for_seeds("1\n x^3 - 2;\n", [](const Paths& paths) {
    const Followed path = paths.follow_path(0, {}, {}, true);
    EXPECT_EQ(path.end.status, PathStatus::failed);
    EXPECT_EQ(path.end.failure, Failure::cancelled);
  });
}

TEST(Endgame, CirclesThatCannotBeWalkedFailForPrecision) {
  for_seeds("2\n x^2 + y^2 - 2;\n x*y - 1;\n", [](const Paths& paths) {
    const PathEnd end = paths.follow_whole_way_only(0);
    EXPECT_EQ(end.status, PathStatus::failed);
    EXPECT_EQ(end.failure, Failure::precision);
  });
}

// Circles agree to 2e-7: x_0 is 0 or not for all that they tell.
TEST(Endgame, EndWhoseAccuracyDoesNotTellItFromInfinityHasFailedForPrecision) {
  const Paths parabolas("2\n x^2 + 1 - y;\n x^2 + x + 2 - y;\n", 1);
  const std::vector<double> shifts{0, 2e-7, 6e-7};
  const auto end = [&](double x0) { return parabolas.end_of_circles(x0, shifts, 1e-6); };
  const PathEnd in_doubt = end(1e-6);
  EXPECT_NEAR(in_doubt.accuracy, shifts[1], shifts[1] / 100);
  EXPECT_EQ(in_doubt.status, PathStatus::failed);
  EXPECT_EQ(in_doubt.failure, Failure::precision);
  EXPECT_EQ(end(1e-3).status, PathStatus::finite);
  // x_0 may be 0, but nothing was seen of a direction that would tell.
  EXPECT_EQ(end(1e-10).status, PathStatus::failed);
}

// The patch of (10 : 1 : 1), from where the path comes, has (-1/5 : 1 : 1) at infinity.
TEST(Endgame, APathThatLeavesItsPatchInsideTheCircleNeedsNoSmallerOne) {
  const Paths parabolas("2\n x^2 + 1 - y;\n x^2 + x + 2 - y;\n", 1);
  const auto circles = parabolas.end_of_circles([](std::size_t circle, double turn) {
    const double radius = 10 * std::pow(EndParameters{}.shrink, -static_cast<double>(circle));
    return Point{std::polar(radius, 2 * std::numbers::pi * turn), 1, 1};
  });
  EXPECT_EQ(circles.end.status, PathStatus::finite);
  EXPECT_EQ(circles.count, 2);
  EXPECT_LT(std::abs(circles.end.x[0]), kRegularAccuracy * std::abs(circles.end.x[1]));
}

TEST(Endgame, EveryVerdictHasItsName) {
  EXPECT_EQ(to_string(PathStatus::finite), "finite");
  EXPECT_EQ(to_string(PathStatus::at_infinity), "at infinity");
  EXPECT_EQ(to_string(PathStatus::failed), "failed");
  EXPECT_EQ(to_string(Failure::step_limit), "step limit");
  EXPECT_EQ(to_string(Failure::step_too_small), "step too small");
  EXPECT_EQ(to_string(Failure::precision), "precision");
  EXPECT_EQ(to_string(Failure::bad_start), "bad start");
  EXPECT_EQ(to_string(Failure::cancelled), "cancelled");
  EXPECT_EQ(to_string(Failure::jumped), "jumped");
}

TEST(Endgame, APathThatWaitsGoesOnElsewhereAsItWouldHere) {
  const System f = read("1\n x^3 - 6*x^2 + 12*x - 8;\n");
  const TotalDegreeStart start = total_degree_start(degrees(f), 1);
  const Homotopy homotopy(f, start_system(start, f.variables));
  const std::atomic<bool> run_on{false};
  const auto tracker = make_cvode_tracker();
  const auto session = tracker->open(homotopy);
  PathSystem scratch(homotopy);
  EndgameOptions options;
  options.may_wait = true;
  Endgame here(options, homotopy.chart(), 0, 0);
  const auto follow_on = [&](Endgame& endgame, std::optional<PathSegment> segment) {
    while (segment) {
      segment = endgame.accept(follow(*session, std::move(*segment), run_on), scratch);
    }
  };
  follow_on(here, here.depart(start_point(start, 0)));
  ASSERT_TRUE(here.waits());
  Endgame elsewhere(options, homotopy.chart(), 0, 0);
  elsewhere.wait_as(here.bytes_of_waiting(), here.end());
  EXPECT_TRUE(elsewhere.waits());
  EXPECT_EQ(elsewhere.bytes_of_waiting(), here.bytes_of_waiting());
  for (Endgame* endgame : {&here, &elsewhere}) {
    while (endgame->waits()) follow_on(*endgame, endgame->walk_on());
  }
  EXPECT_EQ(here.end().winding, 3);
  EXPECT_EQ(elsewhere.end().winding, 3);
  EXPECT_EQ(elsewhere.end().x, here.end().x);
  EXPECT_EQ(elsewhere.end().accuracy, here.end().accuracy);
  EXPECT_EQ(elsewhere.end().count.accepted, here.end().count.accepted);
  EXPECT_THROW(elsewhere.wait_as("half", {}), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
