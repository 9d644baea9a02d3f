// SPDX-License-Identifier: MIT
// Is scaling exact, and right where sizes are far apart?
// By powers of two, and left alone where nothing is wrong.
#include "moivre/polynomial/scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "build.h"
#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

using namespace build;

Rational ten_to(int exponent) {
  const Integer power = pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? ratio(1, power) : ratio(power);
}

/// Unknowns of size 1e6 and 1e-6: X^2+Y^2 = size^2, U^2+V^2 = size^-2, XU-YV = 1/2, X/size - size U
/// = 3/10.
System circles(const Rational& size) {
  const Polynomial x = variable(0), y = variable(1), u = variable(2), v = variable(3);
  return system(4, {x * x + y * y - build::constant(size * size),
                    u * u + v * v - build::constant(1 / (size * size)),
                    x * u - y * v - build::constant(Rational(1, 2)),
                    Rational(1 / size) * x - size * u - build::constant(Rational(3, 10))});
}

/// Planar 2R arm; the last two equations multiplied by `a` and `b`.
System arm(const Rational& a, const Rational& b) {
  const Polynomial c1 = variable(0), s1 = variable(1), c2 = variable(2), s2 = variable(3);
  const Rational l(7, 10);
  return system(4, {c1 * c1 + s1 * s1 - build::constant(1), c2 * c2 + s2 * s2 - build::constant(1),
                    a * (c1 + l * (c1 * c2 - s1 * s2) - build::constant(Rational(6, 5))),
                    b * (s1 + l * (s1 * c2 + c1 * s2) - build::constant(Rational(2, 5)))});
}

double largest_log2(const System& f) {
  double largest = 0;
  for (const Polynomial& p : f.polynomials) {
    for (const Term& term : p.terms) {
      largest = std::max(largest, std::abs(log2_size(term.coefficient)));
    }
  }
  return largest;
}

Point times_powers_of_two(const Point& y, const std::vector<int>& exponents) {
  Point x = y;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const Coefficient factor{ratio(Integer(1) << 40), 0};
    const Coefficient shifted{ratio(Integer(1) << (40 + exponents[j])), 0};
    x[j] = x[j] * shifted / factor;
  }
  return x;
}

TEST(Scaling, SizesOfNumbersThatNoDoubleHolds) {
  constexpr double kRounding = 1e-12;
  const double log2_of_ten = std::log2(10.0);
  for (int exponent : {-5000, -324, -308, -300, -1, 0, 1, 300, 308, 5000}) {
    const double expected = exponent * log2_of_ten;
    const double allowed = kRounding * (1 + std::abs(expected));
    EXPECT_NEAR(log2_size(Coefficient{ten_to(exponent), 0}), expected, allowed) << exponent;
    EXPECT_NEAR(log2_size(Coefficient{0, -ten_to(exponent)}), expected, allowed) << exponent;
    EXPECT_NEAR(log2_size(Coefficient{3 * ten_to(exponent), -4 * ten_to(exponent)}),
                expected + std::log2(5.0), allowed);
  }
  EXPECT_EQ(log2_size(Coefficient{ratio(1, Integer(1) << 1074), 0}), -1074);
}

TEST(Scaling, WellScaledSystemsAreLeftAlone) {
  for (std::uint32_t n : {3u, 8u}) {
    EXPECT_TRUE(is_identity(choose_scaling(katsura(n)))) << n;
    EXPECT_TRUE(is_identity(choose_scaling(cyclic(n)))) << n;
    EXPECT_TRUE(is_identity(choose_scaling(noon(n)))) << n;
    EXPECT_TRUE(is_identity(choose_scaling(eco(n)))) << n;
  }
  EXPECT_TRUE(is_identity(choose_scaling(circles(1))));
  EXPECT_TRUE(is_identity(choose_scaling(arm(1, 1))));
}

TEST(Scaling, Property2AMildSystemStaysThoughItCouldBeMadePerfect) {
  const System f = system(1, {Rational(256) * variable(0) * variable(0) - build::constant(1)});
  EXPECT_TRUE(is_identity(choose_scaling(f)));
  const System g = system(1, {Rational(4096) * variable(0) * variable(0) - build::constant(1)});
  EXPECT_EQ(choose_scaling(g).variable_log2, (std::vector<int>{-6}));
}

TEST(Scaling, UnknownsOfVerySmallAndVeryLargeSizeBecomeTheirTwin) {
  for (int exponent : {6, 50, 300}) {
    const System f = circles(ten_to(exponent));
    const Scaling scaling = choose_scaling(f);
    const System g = scale(f, scaling);
    // 10^k is not a power of two: what is left is the rounding of v (1/2), twice, and of r.
    EXPECT_LE(largest_log2(g), 2.75) << exponent;
    const int expected = static_cast<int>(std::lround(exponent * std::log2(10.0)));
    EXPECT_NEAR(scaling.variable_log2[0], expected, 1);
    EXPECT_NEAR(scaling.variable_log2[2], -expected, 1);
  }
}

TEST(Scaling, BadRowsBecomeTheirTwinAndUnknownsStay) {
  const System f = arm(1000000, Rational(1, 1000000));
  const Scaling scaling = choose_scaling(f);
  EXPECT_EQ(scaling.variable_log2, (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(scaling.equation_log2[0], 0);
  EXPECT_EQ(scaling.equation_log2[1], 0);
  EXPECT_LE(largest_log2(scale(f, scaling)), 2);
}

TEST(Scaling, OneTinyCoefficientThatNoUnitsExplainDoesNotStretchTheUnknowns) {
  const Polynomial x = variable(0), y = variable(1);
  const System f = system(2, {x * x + y * y - build::constant(1),
                              x + Rational(6 * ten_to(-17)) * y - build::constant(Rational(1, 2))});
  EXPECT_EQ(choose_scaling(f).variable_log2, (std::vector<int>{0, 0}));
}

TEST(Scaling, WilkinsonsPolynomialComesWithinReach) {
  Polynomial p = build::constant(1);
  for (int k = 1; k <= 20; ++k) p = p * (variable(0) - build::constant(k));
  const System f = system(1, {p});
  const System g = scale(f, choose_scaling(f));
  EXPECT_GT(largest_log2(f), 63);
  // With x = 8y the sizes of the coefficients add up to prod(1 + k/8) < 2^23, and the least is 1.
  EXPECT_LT(largest_log2(g), 23);
}

TEST(Scaling, Property1IsExactAtRandomPoints) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(seed);
    System f = system(3, {random_polynomial(3, 2, random), random_polynomial(3, 2, random),
                          random_polynomial(3, 1, random)});
    Scaling scaling{{3, -17, 0}, {-2, 11, 0}};
    const System g = scale(f, scaling);
    const Point y = random_point(3, random);
    const Point expected = times_powers_of_two(
        value(f, times_powers_of_two(y, scaling.variable_log2)), scaling.equation_log2);
    EXPECT_EQ(value(g, y), expected) << "seed " << seed;
  }
}

TEST(Scaling, DegenerateSystemsAreScaledToo) {
  EXPECT_TRUE(is_identity(choose_scaling(System{})));
  const System f = system(2, {Polynomial{}, ten_to(40) * variable(0)});
  const Scaling scaling = choose_scaling(f);
  EXPECT_EQ(scaling.equation_log2[0], 0);
  EXPECT_EQ(scaling.variable_log2, (std::vector<int>{0, 0}));
  EXPECT_LE(largest_log2(scale(f, scaling)), 1);
}

TEST(Scaling, AHugeExponentIsNotTurnedIntoAHugeCoefficient) {
  const Polynomial p{
      {Term{Coefficient{1, 0}, {{0, 4000000000U}}}, Term{Coefficient{ten_to(300), 0}, {}}}};
  const System f = system(1, {p});
  EXPECT_EQ(choose_scaling(f).variable_log2, (std::vector<int>{0}));
}

TEST(Scaling, IsToldInWordsWithoutWhatStays) {
  EXPECT_EQ(to_text(Scaling{{-3, 0, 2}, {5, 5}}), "unknowns by 2^-3 to 2^2, equations by 2^5");
  EXPECT_EQ(to_text(Scaling{{0, 0}, {0, 1}}), "equations by 2^0 to 2^1");
  EXPECT_EQ(to_text(Scaling{{0}, {0}}), "");
  EXPECT_EQ(to_text(Scaling{}), "");
}

TEST(Scaling, PointsComeBackInTheOriginalUnits) {
  const Scaling scaling{{20, -20}, {0}};
  const std::vector<std::complex<double>> x = restore(scaling, {{1.5, -1}, {0, 2}});
  EXPECT_EQ(x[0], std::complex<double>(1.5 * 1048576, -1048576));
  EXPECT_EQ(x[1], std::complex<double>(0, 2.0 / 1048576));
  EXPECT_THROW(restore(scaling, {{1, 0}}), std::invalid_argument);
  EXPECT_THROW(scale(System{}, scaling), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
