// SPDX-License-Identifier: MIT
// De Moivre: the d roots of z are turned by the d-th part of a turn, on the circle of radius
// |z|^(1/d).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "moivre/start/total_degree.h"
#include "random_values.h"

namespace moivre {
namespace {

using test::RandomValues;

// An angle of up to a turn is right to two units of its last digit (1.8e-15), and the power
// multiplies that by d; each of its d products is right to 3e-16.
double rounding(std::uint64_t d) { return 2.2e-15 * static_cast<double>(d); }

Complex power_of(Complex x, std::uint64_t d) {
  Complex product = 1;
  for (std::uint64_t k = 0; k < d; ++k) product *= x;
  return product;
}

TEST(DeMoivre, EachRootToItsPowerIsTheNumberAgain) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomValues random(seed);
    const Complex z = random.complex(2);
    for (const std::uint64_t d : {1U, 2U, 3U, 7U, 12U, 25U}) {
      for (std::uint64_t k = 0; k < d; ++k) {
        EXPECT_LE(std::abs(power_of(de_moivre_root(z, d, k), d) - z), rounding(d) * std::abs(z));
      }
    }
  }
}

TEST(DeMoivre, TheNextRootIsTurnedByTheDthPartOfATurn) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomValues random(seed);
    const Complex z = random.complex(2);
    for (const std::uint64_t d : {2U, 3U, 7U, 12U, 25U}) {
      const Complex step = std::polar(1.0, 2 * std::numbers::pi / static_cast<double>(d));
      for (std::uint64_t k = 0; k < d; ++k) {
        const Complex here = de_moivre_root(z, d, k);
        const Complex next = de_moivre_root(z, d, (k + 1) % d);
        EXPECT_LE(std::abs(next - step * here), rounding(d) * std::abs(here)) << d << ' ' << k;
        EXPECT_NEAR(std::abs(here), std::pow(std::abs(z), 1.0 / static_cast<double>(d)),
                    rounding(d) * 2);
      }
    }
  }
}

TEST(DeMoivre, TheRootsAddUpToZeroAndMultiplyToTheNumber) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomValues random(seed);
    const Complex z = random.complex(2);
    for (const std::uint64_t d : {2U, 3U, 8U, 13U}) {
      Complex sum = 0;
      Complex product = 1;
      for (std::uint64_t k = 0; k < d; ++k) {
        sum += de_moivre_root(z, d, k);
        product *= de_moivre_root(z, d, k);
      }
      EXPECT_LE(std::abs(sum), 2 * rounding(d) * static_cast<double>(d));
      // x^d - z has the constant term -z = (-1)^d x_1 ... x_d.
      EXPECT_LE(std::abs(product - (d % 2 == 1 ? z : -z)), 2 * rounding(d) * std::abs(z));
    }
  }
}

TEST(DeMoivre, StartPointsAreAsManyAsTheProductOfTheDegreesAndAllDifferent) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TotalDegreeStart start = total_degree_start({2, 3, 5}, seed);
    ASSERT_EQ(start.paths, 30U);
    for (std::uint64_t a = 0; a < start.paths; ++a) {
      const Point x = start_point(start, a);
      for (std::size_t j = 0; j < 3; ++j) {
        const Complex g = start.c1[j] * power_of(x[j], start.degrees[j]) - start.c2[j];
        EXPECT_LE(std::abs(g), 2 * rounding(start.degrees[j]));
      }
      for (std::uint64_t b = 0; b < a; ++b) {
        const Point other = start_point(start, b);
        double apart = 0;
        for (std::size_t j = 0; j < 3; ++j) apart = std::max(apart, std::abs(x[j] - other[j]));
        EXPECT_GT(apart, 1.1) << a << ' ' << b;  // 2 sin(pi/5) at least
      }
    }
  }
}

}  // namespace
}  // namespace moivre
