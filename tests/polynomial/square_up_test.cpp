// SPDX-License-Identifier: MIT
// Do n combinations keep the roots of m equations, their regularity and the least degrees, and do
// slices cut?
#include "moivre/polynomial/square_up.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "build.h"

namespace moivre {
namespace {

using build::Point;

/// Row of derivatives of p at x.
Point gradient(const Polynomial& p, const Point& x) {
  Point row;
  for (std::uint32_t v = 0; v < x.size(); ++v) {
    TermMap terms;
    for (const Term& term : p.terms) {
      Monomial m;
      Coefficient c = term.coefficient;
      bool holds = false;
      for (Power power : term.monomial) {
        if (power.variable == v) {
          holds = true;
          c = Coefficient{Rational(power.exponent), 0} * c;
          if (--power.exponent == 0) continue;
        }
        m.push_back(power);
      }
      if (holds) terms[m] = terms[m] + c;
    }
    row.push_back(build::value(to_polynomial(std::move(terms)), x));
  }
  return row;
}

std::size_t rank_at(const System& f, const Point& x) {
  std::vector<Point> rows;
  for (const Polynomial& p : f.polynomials) rows.push_back(gradient(p, x));
  return build::rank(std::move(rows));
}

bool is_root(const System& f, const Point& x) {
  for (const Coefficient& c : build::value(f, x)) {
    if (!is_zero(c)) return false;
  }
  return true;
}

/// m random quadrics (the first `linear` linear) in n unknowns through a point.
System through_a_point(std::uint32_t n, std::size_t m, std::size_t linear, const Point& x,
                       std::mt19937_64& random) {
  std::vector<Polynomial> polynomials;
  for (std::size_t i = 0; i < m; ++i) {
    const int degree = i < linear ? 1 : 2;
    polynomials.push_back(build::through(build::random_polynomial(n, degree, random), x));
  }
  return build::system(n, std::move(polynomials));
}

TEST(SquareUp, KeepsARootAndItsRegularity) {
  std::mt19937_64 random(1);
  for (const std::uint64_t seed : {1UL, 2UL, 12345UL}) {
    const Point x = build::random_point(3, random);
    const System f = through_a_point(3, 6, 1, x, random);
    const System g = square_up(f, seed);
    ASSERT_EQ(g.polynomials.size(), 3U);
    EXPECT_TRUE(is_root(g, x));
    EXPECT_EQ(rank_at(g, x), 3U);
  }
}

// Three equations of rank 2 at the origin, of which any two of rank 1 could lead.
TEST(SquareUp, IsRegularWhereOnlyASpareEquationMakesItSo) {
  const Polynomial x = unknown(0);
  const Polynomial y = unknown(1);
  const System f{{"x", "y"}, {x + y * y, x + x * y, y + x * x}};
  for (const std::uint64_t seed : {1UL, 2UL, 3UL, 4UL}) {
    EXPECT_EQ(rank_at(square_up(f, seed), {{0, 0}, {0, 0}}), 2U);
  }
}

TEST(SquareUp, HasTheDegreesOfTheEquationsOfHighestDegree) {
  const Polynomial x = unknown(0);
  const Polynomial y = unknown(1);
  const Polynomial one = constant({1, 0});
  const System f{{"x", "y"}, {x + y, x * x * x + one, x * y + one, y * y * x * x * x + x, y + one}};
  const System g = square_up(f, 1);
  EXPECT_EQ(degrees(g), (std::vector<std::uint64_t>{3, 5}));
}

// Two equations of low degree share a factor: the roots on it need the third equation, of high
// degree, in full.
TEST(SquareUp, KeepsRootsOnAFactorThatTheLowEquationsShare) {
  const Polynomial x = unknown(0);
  const Polynomial y = unknown(1);
  const auto number = [](int c) { return constant({c, 0}); };
  const System f{{"x", "y"},
                 {x * (x + y), x * (y + number(-7)),
                  (y + number(-1)) * (y + number(-2)) * (y + number(-3)) + x}};
  const System g = square_up(f, 1);
  for (const int root : {1, 2, 3}) {
    EXPECT_TRUE(is_root(g, {{0, 0}, {root, 0}}));
    EXPECT_EQ(rank_at(g, {{0, 0}, {root, 0}}), 2U);
  }
}

// (x - 1)(y - 2) = (x - 1)(y - 3) = 0 hold on all of x = 1; with x (y - 5) the point (1, 5) is left
// of it.
TEST(SquareUp, CutsASetThatTwoOfThreeEquationsShare) {
  const Polynomial x = unknown(0);
  const Polynomial y = unknown(1);
  const auto number = [](int c) { return constant({c, 0}); };
  const Polynomial on_set = x + number(-1);
  const System f{{"x", "y"},
                 {on_set * (y + number(-2)), on_set * (y + number(-3)), x * (y + number(-5))}};
  for (const std::uint64_t seed : {1UL, 2UL, 3UL}) {
    const System g = square_up(f, seed);
    EXPECT_TRUE(is_root(g, {{1, 0}, {5, 0}}));
    EXPECT_EQ(rank_at(g, {{1, 0}, {5, 0}}), 2U);
    for (const int other : {2, 3, 4}) EXPECT_FALSE(is_root(g, {{1, 0}, {other, 0}}));
  }
}

TEST(SquareUp, OfOneDegreeTheLongEquationsLead) {
  const Polynomial x = unknown(0);
  const Polynomial y = unknown(1);
  const Polynomial one = constant({1, 0});
  const Polynomial dense = (x + y + one) * (x + y + one);
  const System f{{"x", "y"}, {x * y + x, dense, dense + x * x}};
  const System g = square_up(f, 1);
  EXPECT_EQ(term_count(g), 12U);
}

TEST(SquareUp, BringsSpareEquationsToTheSizeOfTheLeadingOne) {
  const Polynomial x = unknown(0);
  const System f{{"x"}, {x * x + constant({-1, 0}), Coefficient{Rational(1 << 30), 0} * x}};
  const Rational mixed = square_up(f, 1).polynomials[0].terms[1].coefficient.re;
  EXPECT_GE(abs(mixed), Rational(1, 2));
  EXPECT_LE(abs(mixed), Rational(3, 2));
}

TEST(SquareUp, DropsZerosAndLeavesASquareSystemAlone) {
  const Polynomial x = unknown(0);
  const Polynomial y = unknown(1);
  const System f{{"x", "y"}, {x * x, Polynomial{}, y + x}};
  EXPECT_EQ(square_up(f, 1), (System{{"x", "y"}, {x * x, y + x}}));
  EXPECT_EQ(square_up(square_up(f, 1), 2), square_up(f, 1));
  EXPECT_EQ(square_up(System{{"x", "y"}, {x, Polynomial{}}}, 1).polynomials.size(), 1U);
  EXPECT_THROW(square_up(System{{"x", "y"}, {x}}, 1), std::invalid_argument);
}

TEST(SquareUp, TheSeedAloneDecides) {
  std::mt19937_64 random(3);
  const System f = through_a_point(2, 4, 0, build::random_point(2, random), random);
  EXPECT_EQ(square_up(f, 1), square_up(f, 1));
  EXPECT_NE(square_up(f, 1), square_up(f, 2));
}

TEST(Slices, AppendAffineLinearEquationsUntilThereAreN) {
  System f = build::system(4, {unknown(0) * unknown(1) + unknown(3)});
  f.groups = {{{0, 1}, false}, {{2, 3}, false}};
  for (const std::uint64_t seed : {1UL, 2UL}) {
    const System g = with_slices(f, seed);
    ASSERT_EQ(g.polynomials.size(), 4U);
    EXPECT_EQ(g.polynomials[0], f.polynomials[0]);
    EXPECT_EQ(g.groups, f.groups);
    for (std::size_t i = 1; i < 4; ++i) {
      EXPECT_EQ(degree(g.polynomials[i]), 1U);
      EXPECT_EQ(g.polynomials[i].terms.size(), 5U);
      EXPECT_TRUE(is_real(g.polynomials[i]));
    }
    EXPECT_EQ(rank_at(with_slices(System{g.variables, {}}, seed), Point(4)), 4U);
    EXPECT_EQ(with_slices(g, seed), g);
  }
  EXPECT_NE(with_slices(f, 1), with_slices(f, 2));
  EXPECT_THROW(with_slices(build::system(1, {unknown(0), unknown(0)}), 1), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
