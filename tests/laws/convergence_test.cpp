// SPDX-License-Identifier: MIT
// Orders of convergence: steps of a predictor of order p grow by tol^(-1/p); each correction by
// Newton's method squares the error.
#include <gtest/gtest.h>

#include <cmath>

#include "../mechanism/files.h"
#include "moivre/kinematics/newton.h"
#include "moivre/polynomial/read.h"
#include "moivre/start/total_degree.h"
#include "moivre/tracker/double_double_tracker.h"
#include "moivre/tracker/path_system.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "random_values.h"

namespace moivre {
namespace {

using test::RandomValues;

/// From x^2 = 1 to x^2 = c: x(t)^2 = 1 + (c - 1) t.
struct SquareRoots {
  explicit SquareRoots(Complex end) : c(end), homotopy(with_constant(-end), with_constant(-1)) {}

  static System with_constant(Complex constant_term) {
    System f;
    f.variables = {"x"};
    f.polynomials = {unknown(0) * unknown(0) +
                     constant({Rational(constant_term.real()), Rational(constant_term.imag())})};
    return f;
  }
  /// Near `guess`, of the two.
  Complex root_at(double t, Complex guess) const {
    const Complex root = std::sqrt(1.0 + (c - 1.0) * t);
    return std::abs(root - guess) < std::abs(root + guess) ? root : -root;
  }

  Complex c;
  Homotopy homotopy;
};

/// Far from 0 all along the path: |1 + (c - 1) t| >= 1/2.
Complex random_constant(RandomValues& random) {
  return {random.between(1, 4), random.between(-4, 4)};
}

Complex affine(const Point& x) { return x[0] / x[1]; }

// The homotopies of two random cubics; their nine paths have no singular point.
struct Cubics {
  explicit Cubics(std::uint64_t seed)
      : f(read_system({"test", "2\nx^3 + 2*x*y - y^2 - 3; y^3 - x^2*y + 4*x - 1;\n"})),
        start(total_degree_start(degrees(f), seed)),
        homotopy(f, start_system(start, f.variables)) {}

  /// Of all paths.
  double steps(const Tracker& tracker) const {
    const std::atomic<bool> stop{false};
    const auto session = tracker.open(homotopy);
    std::uint64_t steps = 0;
    for (std::uint64_t path = 0; path < start.paths; ++path) {
      const SegmentResult reached = follow(
          *session, {path, Contour::segment(0, 1), start_point(start, path), 0, 0, nullptr}, stop);
      EXPECT_EQ(reached.status, SegmentStatus::arrived) << path;
      steps += reached.count.accepted;
    }
    return static_cast<double>(steps);
  }

  System f;
  TotalDegreeStart start;
  Homotopy homotopy;
};

// The error of a step h is of order h^p: a tolerance 10^4 times tighter takes 10^(4/p) times the
// steps.
TEST(OrderOfConvergence, StepsOfALanesPredictorGrowByItsOrder) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Cubics cubics(seed);
    for (const LanePredictor predictor :
         {LanePredictor::tangent, LanePredictor::cubic, LanePredictor::quintic}) {
      const auto steps = [&](double tolerance) {
        return cubics.steps(*make_lane_tracker(
            {.tolerance = tolerance, .maximum_steps = 1000000, .predictor = predictor}));
      };
      EXPECT_NEAR(std::log10(steps(1e-8) / steps(1e-4)), 4.0 / order_of(predictor), 0.25)
          << to_string(predictor) << ", seed " << seed;
    }
  }
}

TEST(OrderOfConvergence, StepsInDoubleDoubleGrowByTheOrdersOfTheirPredictors) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    RandomValues random(seed);
    const SquareRoots roots(random_constant(random));
    const std::atomic<bool> stop{false};
    const auto steps = [&](const Tracker& tracker) {
      const SegmentResult reached = follow(
          *tracker.open(roots.homotopy), {0, Contour::segment(0, 1), {1, 1}, 0, 0, nullptr}, stop);
      EXPECT_EQ(reached.status, SegmentStatus::arrived);
      return static_cast<double>(reached.count.accepted);
    };
    // The tracker for one path predicts to order 12, the lanes to order 6.
    const auto alone = [&](double tolerance) {
      return steps(*make_double_double_tracker({.tolerance = tolerance}));
    };
    EXPECT_NEAR(std::log10(alone(1e-10) / alone(1e-6)), 4.0 / 12, 0.12) << seed;
    const auto lanes = [&](double tolerance) {
      return steps(*make_lane_tracker({.tolerance = tolerance})->in_double_double());
    };
    EXPECT_NEAR(std::log10(lanes(1e-14) / lanes(1e-8)), 1, 0.12) << seed;
  }
}

TEST(OrderOfConvergence, OneFreshCorrectionOfAPathSquaresTheError) {
  const CorrectorOptions once{.tolerance = 1, .maximum_iterations = 1};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    RandomValues random(seed);
    const SquareRoots roots(random_constant(random));
    PathSystem path(roots.homotopy);
    const Complex exact = roots.root_at(0.5, 1);
    const Complex aside = std::polar(1.0, random.between(0, 6));
    const auto constant_of = [&](double error) {
      Point x{exact + error * aside, 1.0};
      EXPECT_TRUE(path.correct(x, Complex(0.5), once, true).converged);
      return std::abs(affine(x) - exact) / (error * error);
    };
    EXPECT_NEAR(constant_of(1e-2) / constant_of(1e-4), 1, 0.05) << seed;
  }
}

/// log e_{k+1} / log e_k of the last steps that are far from rounding.
void expect_quadratic(const NewtonResult& run) {
  const double size = std::max(1.0, run.q.cwiseAbs().maxCoeff());
  int steps = 0;
  for (std::size_t k = 0; k + 1 < run.iterations.size(); ++k) {
    const double before = (run.iterations[k].q - run.q).norm() / size;
    const double after = (run.iterations[k + 1].q - run.q).norm() / size;
    if (before > 1e-2 || after < 1e-13) continue;
    // e_{k+1} = C e_k^2, with a C of the mechanism's own.
    EXPECT_LT(after, 50 * before * before) << before << " -> " << after;
    ++steps;
  }
  EXPECT_GT(steps, 0);
}

TEST(OrderOfConvergence, NewtonRaphsonOnConstraintsSquaresTheError) {
  for (const char* name :
       {"four-bar", "jansen-leg", "stephenson-3", "slider-crank", "rssr", "redundant-system"}) {
    const Mechanism mechanism = test::example(name);
    const Phi phi(mechanism);
    const NewtonResult assembled = newton(phi, initial_guess(mechanism), 0);
    ASSERT_EQ(assembled.status, NewtonStatus::converged) << name;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      RandomValues random(seed);
      Eigen::VectorXd guess = assembled.q;
      const double size = std::max(1.0, guess.cwiseAbs().maxCoeff());
      for (Eigen::Index k = 0; k < guess.size(); ++k) {
        const bool is_length =
            phi.coordinates()[static_cast<std::size_t>(k)].kind == CoordinateKind::length;
        guess[k] += 3e-3 * (is_length ? size : 1) * random.between(-1, 1);
      }
      SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
      const NewtonResult run = newton(phi, guess, 0);
      ASSERT_EQ(run.status, NewtonStatus::converged);
      expect_quadratic(run);
    }
  }
}

}  // namespace
}  // namespace moivre
