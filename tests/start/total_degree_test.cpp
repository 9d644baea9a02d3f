// SPDX-License-Identifier: MIT
// Is every start point a root of G, are all of them different, and are they as many as the degrees
// say?
#include "moivre/start/total_degree.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "moivre/polynomial/tape.h"

namespace moivre {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// The angle of a root, up to 2 pi, is rounded three times by up to 2 epsilon; x^d has d times that,
// and d products of up to 2 epsilon.
double root_error(std::uint64_t d) { return 8 * static_cast<double>(d) * kEpsilon; }

Complex power(Complex x, std::uint64_t d) {
  Complex result = 1;
  for (std::uint64_t k = 0; k < d; ++k) result *= x;
  return result;
}

std::vector<std::string> names(std::size_t n) {
  std::vector<std::string> result;
  for (std::size_t j = 0; j < n; ++j) result.push_back(std::string("x").append(std::to_string(j)));
  return result;
}

Point value(const System& g, const Point& x) {
  const Tape tape = make_tape(g);
  const std::vector<Complex> c = complex_coefficients(tape, g);
  Point registers(tape.register_count());
  Point values(tape.equations);
  evaluate<Complex, Complex>(tape, c, std::span<const Complex>(x.data(), x.size()), registers,
                             values);
  return values;
}

const std::vector<std::vector<std::uint64_t>> kDegrees{
    {1}, {7}, {2, 3}, {3, 1, 4}, {2, 2, 2, 2, 2}};

TEST(SeedP30, EveryStartPointIsARootOfTheStartSystem) {
  for (const auto& degrees : kDegrees) {
    for (const std::uint64_t seed : {1UL, 2UL, 12345UL}) {
      const TotalDegreeStart start = total_degree_start(degrees, seed);
      const System g = start_system(start, names(degrees.size()));
      for (std::uint64_t number = 0; number < start.paths; ++number) {
        Point x = start_point(start, number);
        ASSERT_EQ(x.size(), degrees.size() + 1);
        EXPECT_EQ(x.back(), 1.0);
        x.pop_back();
        EXPECT_LT(max_norm(value(g, x)), root_error(7)) << number;
      }
    }
  }
}

TEST(SeedP30, TheStartPointsAreDistinctAndAsManyAsTheProductOfTheDegrees) {
  for (const auto& degrees : kDegrees) {
    const TotalDegreeStart start = total_degree_start(degrees, 1);
    std::uint64_t product = 1;
    for (const std::uint64_t d : degrees) product *= d;
    EXPECT_EQ(start.paths, product);
    // The d-th roots of a number of modulus 1 are at least 2 sin(pi/7) apart for d <= 7.
    const double separation = 0.8;
    for (std::uint64_t a = 0; a < start.paths; ++a) {
      for (std::uint64_t b = 0; b < a; ++b) {
        Point difference = start_point(start, a);
        const Point other = start_point(start, b);
        for (std::size_t j = 0; j < difference.size(); ++j) difference[j] -= other[j];
        EXPECT_GT(max_norm(difference), separation) << a << " and " << b;
      }
    }
  }
}

TEST(SeedP30, TheStartSystemIsC1XToTheDMinusC2WithCoefficientsOnTheUnitCircle) {
  const TotalDegreeStart start = total_degree_start({2, 3}, 1);
  const System g = start_system(start, {"x", "y"});
  EXPECT_EQ(degrees(g), start.degrees);
  EXPECT_EQ(g.variables, (std::vector<std::string>{"x", "y"}));
  for (std::uint32_t j = 0; j < 2; ++j) {
    const std::vector<Term>& terms = g.polynomials[j].terms;
    ASSERT_EQ(terms.size(), 2u);
    EXPECT_EQ(terms[0].monomial, (Monomial{{j, static_cast<std::uint32_t>(start.degrees[j])}}));
    EXPECT_EQ(to_complex(terms[0].coefficient), start.c1[j]);
    EXPECT_TRUE(terms[1].monomial.empty());
    EXPECT_EQ(to_complex(terms[1].coefficient), -start.c2[j]);
    EXPECT_NEAR(std::abs(start.c1[j]), 1, 2 * kEpsilon);
    EXPECT_NEAR(std::abs(start.c2[j]), 1, 2 * kEpsilon);
  }
}

TEST(SeedP31, TheCubeRootsOfOneAndTwoIToAllPrintedDigits) {
  const Complex printed[]{{1.219617, 0.471711}, {-1.018322, 0.820363}, {-0.201294, -1.292075}};
  const double half_last_digit = 0.5e-6;
  for (std::uint64_t k = 0; k < 3; ++k) {
    const Complex root = de_moivre_root({1, 2}, 3, k);
    EXPECT_NEAR(root.real(), printed[k].real(), half_last_digit) << k;
    EXPECT_NEAR(root.imag(), printed[k].imag(), half_last_digit) << k;
  }
}

TEST(SeedP31, RootsInEveryQuadrantGiveTheirNumberBack) {
  for (const Complex z : {Complex(3, 4), Complex(-3, 4), Complex(-3, -4), Complex(3, -4),
                          Complex(-1, 0), Complex(0, -2)}) {
    for (const std::uint64_t d : {1u, 2u, 3u, 4u, 5u, 12u}) {
      Complex sum = 0;
      for (std::uint64_t k = 0; k < d; ++k) {
        const Complex root = de_moivre_root(z, d, k);
        EXPECT_LE(std::abs(power(root, d) - z), root_error(d) * std::abs(z)) << z << d;
        sum += root;
      }
      // x^d - z has no term of degree d - 1.
      const double rest = d > 1 ? std::abs(sum) : 0;
      EXPECT_LE(rest, root_error(d) * std::abs(z));
    }
  }
}

TEST(TotalDegree, PathNumbersAreMixedRadixInTheDegrees) {
  const TotalDegreeStart start = total_degree_start({3, 2, 4}, 1);
  std::uint64_t number = 0;
  for (std::uint64_t k2 = 0; k2 < 4; ++k2) {
    for (std::uint64_t k1 = 0; k1 < 2; ++k1) {
      for (std::uint64_t k0 = 0; k0 < 3; ++k0, ++number) {
        const std::uint64_t digits[]{k0, k1, k2};
        const Point x = start_point(start, number);
        for (std::size_t j = 0; j < 3; ++j) {
          EXPECT_EQ(x[j], de_moivre_root(start.c2[j] / start.c1[j], start.degrees[j], digits[j]));
        }
      }
    }
  }
  EXPECT_EQ(number, start.paths);
}

TEST(TotalDegree, TheSeedAloneDecidesTheStartSystem) {
  const TotalDegreeStart first = total_degree_start({2, 3}, 1);
  EXPECT_EQ(total_degree_start({2, 3}, 1).c1, first.c1);
  EXPECT_EQ(total_degree_start({2, 3}, 1).c2, first.c2);
  EXPECT_NE(total_degree_start({2, 3}, 2).c1, first.c1);
}

TEST(TotalDegree, RefusesAnEquationOfDegreeZero) {
  EXPECT_THROW(total_degree_start({2, 0, 3}, 1), std::invalid_argument);
}

TEST(TotalDegree, RefusesABezoutNumberBeyond64Bits) {
  const std::vector<std::uint64_t> sixty_three(63, 2);
  EXPECT_EQ(total_degree_start(sixty_three, 1).paths, std::uint64_t{1} << 63);
  const std::vector<std::uint64_t> sixty_four(64, 2);
  EXPECT_THROW(total_degree_start(sixty_four, 1), std::overflow_error);
  // 3 * 6148914691236517205 = 2^64 - 1 fits.
  EXPECT_EQ(total_degree_start({3, 6148914691236517205u}, 1).paths,
            std::numeric_limits<std::uint64_t>::max());
}

}  // namespace
}  // namespace moivre
