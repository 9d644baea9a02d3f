// SPDX-License-Identifier: MIT
// Conservation: no path is lost or counted twice. As many paths end in a ball as it has roots, with
// their multiplicities.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "moivre/polynomial/value.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "random_values.h"

namespace moivre {
namespace {

using test::RandomValues;

Polynomial plus(const Polynomial& p, Complex c) {
  return p + constant({Rational(c.real()), Rational(c.imag())});
}

Polynomial power_of(const Polynomial& p, std::uint64_t exponent) {
  Polynomial product = constant({1, 0});
  for (std::uint64_t k = 0; k < exponent; ++k) product = product * p;
  return product;
}

SolveResult solved(const System& f, std::uint64_t seed, const Tracker& tracker) {
  SolveOptions options;
  options.seed = seed;
  options.threads = 1;
  options.start = StartKind::total_degree;
  return solve(f, tracker, options);
}

std::unique_ptr<Tracker> tracker_of(std::uint64_t seed) {
  return seed % 2 == 0 ? make_cvode_tracker() : make_lane_tracker();
}

/// Of degree `degree` in x.
System random_polynomial(RandomValues& random, std::size_t degree) {
  System f;
  f.variables = {"x"};
  Polynomial p = constant({1, 0});
  for (std::size_t k = 0; k < degree; ++k) {
    p = plus(p * unknown(0), random.complex(1));
  }
  f.polynomials = {p};
  return f;
}

/// How often p winds round 0 along the circle |x - c| = r: the number of its roots within.
long winding_number(const Polynomial& p, Complex c, double r) {
  constexpr int kSteps = 20000;
  double turned = 0;
  Complex last = value_at(p, {c + r});
  for (int k = 1; k <= kSteps; ++k) {
    const Complex value = value_at(p, {c + std::polar(r, 2 * std::numbers::pi * k / kSteps)});
    turned += std::arg(value / last);
    last = value;
  }
  return std::lround(turned / (2 * std::numbers::pi));
}

/// Multiplicities of the roots within |x - c|_inf < r.
std::uint64_t paths_into_ball(const SolveResult& result, const Point& c, double r) {
  std::uint64_t count = 0;
  for (const Solution& root : result.solutions) {
    double distance = 0;
    for (std::size_t j = 0; j < c.size(); ++j) {
      distance = std::max(distance, std::abs(root.x[j] - c[j]));
    }
    if (distance < r) count += root.multiplicity;
  }
  return count;
}

void expect_conservation(const SolveResult& result) {
  const PathCounts& paths = result.paths;
  EXPECT_EQ(paths.tracked, paths.finite + paths.at_infinity + paths.failed + paths.not_needed);
  std::uint64_t multiplicities = 0;
  for (const Solution& root : result.solutions) multiplicities += root.multiplicity;
  EXPECT_EQ(paths.finite, multiplicities + paths.on_positive_dimensional);
}

TEST(Conservation, AsManyPathsEndInADiscAsThePolynomialWindsRoundZeroAlongItsRim) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    RandomValues random(seed);
    const System f = random_polynomial(random, 3 + seed % 6);
    const SolveResult result = solved(f, seed, *tracker_of(seed));
    ASSERT_TRUE(result.complete) << seed;
    for (int disc = 0; disc < 8; ++disc) {
      const Complex c = random.complex(1.5);
      const double r = random.between(0.1, 1.5);
      EXPECT_EQ(static_cast<long>(paths_into_ball(result, {c}, r)),
                winding_number(f.polynomials[0], c, r))
          << seed << ": |x - " << c << "| < " << r;
    }
  }
}

TEST(Conservation, AsManyPathsEndAtAPlantedRootAsItsMultiplicity) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RandomValues random(seed);
    // (x - a)^m (x - b) = 0 and (y - c x)^k (y - d) = 0, all apart.
    const std::uint64_t m = 1 + seed % 3;
    const std::uint64_t k = 1 + seed / 4;
    const Complex a = random.complex(1);
    const Complex b = a + std::polar(1.5, random.between(0, 6));
    const Complex c = std::polar(1.0, random.between(0, 6));
    const Complex d = 5.0 + random.complex(1);
    System f;
    f.variables = {"x", "y"};
    const Polynomial x = unknown(0);
    const Polynomial y = unknown(1);
    const Coefficient minus_c{Rational(-c.real()), Rational(-c.imag())};
    f.polynomials = {power_of(plus(x, -a), m) * plus(x, -b),
                     power_of(y + minus_c * x, k) * plus(y, -d)};
    const SolveResult result = solved(f, seed, *tracker_of(seed));
    ASSERT_TRUE(result.complete) << seed;
    EXPECT_EQ(result.paths.tracked, (m + 1) * (k + 1));
    expect_conservation(result);
    const double kNear = 1e-3;
    EXPECT_EQ(paths_into_ball(result, {a, c * a}, kNear), m * k) << seed;
    EXPECT_EQ(paths_into_ball(result, {a, d}, kNear), m) << seed;
    EXPECT_EQ(paths_into_ball(result, {b, c * b}, kNear), k) << seed;
    EXPECT_EQ(paths_into_ball(result, {b, d}, kNear), 1U) << seed;
  }
}

TEST(Conservation, WhatLeavesTheFinitePlaneEndsAtInfinity) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RandomValues random(seed);
    // Two conics with an asymptotic direction in common meet at three finite points, and once at
    // infinity.
    const auto any = [&] {
      return Coefficient{Rational(random.between(-1, 1)), Rational(random.between(-1, 1))};
    };
    const Polynomial x = unknown(0);
    const Polynomial y = unknown(1);
    const Polynomial common = any() * x + any() * y;
    System f;
    f.variables = {"x", "y"};
    for (int e = 0; e < 2; ++e) {
      f.polynomials.push_back(common * (any() * x + any() * y) + any() * x + any() * y +
                              constant(any()));
    }
    const SolveResult result = solved(f, seed, *tracker_of(seed));
    EXPECT_TRUE(result.complete) << seed;
    expect_conservation(result);
    EXPECT_EQ(result.paths.tracked, 4U);
    EXPECT_EQ(result.paths.finite, 3U) << seed;
    EXPECT_EQ(result.paths.at_infinity + result.paths.not_needed, 1U) << seed;
  }
}

TEST(Conservation, TheNumberOfRootsDependsNeitherOnTheSeedNorOnTheOrderOfTheEquations) {
  RandomValues random(3);
  System f;
  f.variables = {"x", "y"};
  const auto any = [&] { return Coefficient{Rational(random.between(-1, 1)), 0}; };
  for (int e = 0; e < 2; ++e) {
    f.polynomials.push_back(any() * power_of(unknown(0), 3) +
                            any() * (unknown(0) * power_of(unknown(1), 2)) + any() * unknown(1) +
                            constant(any()));
  }
  System reversed = f;
  std::swap(reversed.polynomials[0], reversed.polynomials[1]);
  const SolveResult once = solved(f, 1, *tracker_of(1));
  for (std::uint64_t seed = 2; seed <= 6; ++seed) {
    for (const System& g : {f, reversed}) {
      const SolveResult again = solved(g, seed, *tracker_of(seed));
      EXPECT_EQ(again.paths.finite, once.paths.finite) << seed;
      for (const Solution& root : once.solutions) {
        EXPECT_EQ(paths_into_ball(again, root.x, 1e-8), root.multiplicity) << seed;
      }
    }
  }
}

}  // namespace
}  // namespace moivre
