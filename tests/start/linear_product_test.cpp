// SPDX-License-Identifier: MIT
// Is every start point a root of G, are all of them different, and are they as many as the groups
// say?
#include "moivre/start/linear_product.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "moivre/factorization/lu.h"
#include "moivre/start/total_degree.h"
#include "systems.h"

namespace moivre {
namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon();

struct Case {
  const char* name;
  GroupDegrees degrees;
  Partition groups;
};

std::vector<Case> cases() {
  const System quintic = eigenvalues(5);
  return {
      {"a group for each unknown", {{2, 1}, {1, 3}}, {{0}, {1}}},
      {"one group", {{2}, {3}, {1}}, {{0, 1, 2}}},
      {"factors missing", {{2, 0, 1}, {0, 1, 1}, {1, 1, 0}, {1, 0, 2}}, {{1, 2}, {0}, {3}}},
      {"two groups of two", {{1, 1}, {2, 1}, {1, 2}, {1, 1}}, {{0, 2}, {1, 3}}},
      {"eigenvalues", group_degrees(quintic, {{0, 1, 2, 3}, {4}}), {{0, 1, 2, 3}, {4}}},
      {"cassou", group_degrees(cassou(), {{0}, {1, 2, 3}}), {{0}, {1, 2, 3}}},
  };
}

std::vector<std::string> names_of_unknowns(std::size_t n) {
  std::vector<std::string> result;
  for (std::size_t j = 0; j < n; ++j) result.push_back(std::string("x").append(std::to_string(j)));
  return result;
}

struct Values {
  Point f;
  std::vector<double> terms;  // of each equation, the sum of the sizes of its terms
};

Values values(const System& g, const Point& x) {
  Values result;
  for (const Polynomial& p : g.polynomials) {
    Complex sum = 0;
    double sizes = 0;
    for (const Term& term : p.terms) {
      Complex value = to_complex(term.coefficient);
      for (const Power& power : term.monomial) value *= std::pow(x[power.variable], power.exponent);
      sum += value;
      sizes += std::abs(value);
    }
    result.f.push_back(sum);
    result.terms.push_back(sizes);
  }
  return result;
}

double distance(const Point& a, const Point& b) {
  double largest = 0;
  for (std::size_t j = 0; j < a.size(); ++j) largest = std::max(largest, std::abs(a[j] - b[j]));
  return largest;
}

/// Condition of the Jacobian of G at x, rows scaled.
double condition(const System& g, const Point& x) {
  const std::size_t n = x.size();
  Lu lu(n);
  std::fill(lu.matrix().begin(), lu.matrix().end(), Complex(0));
  for (std::size_t i = 0; i < n; ++i) {
    for (const Term& term : g.polynomials[i].terms) {
      for (const Power& by : term.monomial) {
        Complex value = to_complex(term.coefficient) * static_cast<double>(by.exponent);
        for (const Power& power : term.monomial) {
          const auto e = power.exponent - (power.variable == by.variable ? 1U : 0U);
          value *= std::pow(x[power.variable], e);
        }
        lu.matrix()[i * n + by.variable] += value;
      }
    }
  }
  lu.factor();
  return lu.condition();
}

TEST(LinearProduct, EveryStartPointIsARegularRootOfTheStartSystem) {
  for (const Case& c : cases()) {
    for (const std::uint64_t seed : {1UL, 2UL, 12345UL}) {
      const LinearProductStart start = linear_product_start(c.degrees, c.groups, seed);
      const System g = start_system(start, names_of_unknowns(c.degrees.size())).value();
      for (std::uint64_t number = 0; number < start.paths; ++number) {
        Point x = start_point(start, number);
        ASSERT_EQ(x.size(), c.degrees.size() + 1);
        EXPECT_EQ(x.back(), 1.0);
        x.pop_back();
        const Values at = values(g, x);
        for (std::size_t i = 0; i < at.f.size(); ++i) {
          EXPECT_LT(std::abs(at.f[i]), 1e3 * kRounding * at.terms[i]) << c.name << number;
        }
        EXPECT_LT(condition(g, x), 1e6) << c.name << ' ' << number;
      }
    }
  }
}

TEST(LinearProduct, TheStartPointsAreDistinctAndAsManyAsTheGroupsSay) {
  for (const Case& c : cases()) {
    const LinearProductStart start = linear_product_start(c.degrees, c.groups, 7);
    EXPECT_EQ(start.paths, multihomogeneous_number(c.degrees, c.groups)) << c.name;
    std::vector<Point> points;
    for (std::uint64_t k = 0; k < start.paths; ++k) points.push_back(start_point(start, k));
    for (std::size_t a = 0; a < points.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) EXPECT_GT(distance(points[a], points[b]), 1e-3) << c.name;
    }
    EXPECT_THROW(start_point(start, start.paths), std::invalid_argument);
  }
}

TEST(LinearProduct, MultipliedOutItHasTheDegreesAndTheTermsForetold) {
  for (const Case& c : cases()) {
    const LinearProductStart start = linear_product_start(c.degrees, c.groups, 3);
    const System g = start_system(start, names_of_unknowns(c.degrees.size())).value();
    EXPECT_EQ(group_degrees(g, c.groups), c.degrees) << c.name;
    EXPECT_EQ(term_count(g), linear_product_terms(c.degrees, c.groups)) << c.name;
  }
}

TEST(LinearProduct, IsMultipliedOutExactly) {
  const LinearProductStart start =
      linear_product_start(GroupDegrees{{2, 1}, {2, 1}, {1, 1}}, {{0, 1}, {2}}, 1);
  const System g = start_system(start, names_of_unknowns(3)).value();
  const auto exact = [](Complex z) { return Coefficient{Rational(z.real()), Rational(z.imag())}; };
  const std::vector<Point>& forms = start.factors[0][0].forms;
  ASSERT_EQ(forms.size(), 2U);
  // The constant term: b b' times that of the other group's binomial.
  EXPECT_EQ(g.polynomials[0].terms.back().coefficient,
            exact(forms[0][2]) * exact(forms[1][2]) * exact(start.factors[0][1].forms[0][1]));
  for (const Point& form : forms) {
    for (const Complex& a : form) {
      EXPECT_EQ(std::ldexp(a.real(), kConstantBits),
                std::rint(std::ldexp(a.real(), kConstantBits)));
    }
  }
}

TEST(LinearProduct, NeighbouringNumbersAreChoicesOfFactors) {
  // Both equations hold both unknowns: 2 * 3 + 1 * 1 choices, a root of each unknown's binomial
  // taken from either equation.
  const LinearProductStart start =
      linear_product_start(GroupDegrees{{2, 1}, {1, 3}}, {{0}, {1}}, 1);
  ASSERT_EQ(start.paths, 7U);
  std::vector<Complex> xs;
  for (std::uint64_t number = 0; number < 7; ++number) xs.push_back(start_point(start, number)[0]);
  EXPECT_EQ(xs[0], xs[1]);
  EXPECT_EQ(xs[0], xs[2]);
  EXPECT_NE(xs[2], xs[3]);
  EXPECT_EQ(xs[3], xs[5]);
  EXPECT_EQ(start_point(start, 0)[1], start_point(start, 3)[1]);
  EXPECT_NE(xs[5], xs[6]);
}

TEST(LinearProduct, TheSeedAloneDecidesTheStartSystem) {
  const auto system = [](std::uint64_t seed) {
    const Case c = cases()[3];
    return start_system(linear_product_start(c.degrees, c.groups, seed), names_of_unknowns(4))
        .value();
  };
  EXPECT_EQ(system(1), system(1));
  EXPECT_NE(system(1), system(2));
}

TEST(LinearProduct, AnExpansionThatIsTooLongIsForetoldAndNotBegun) {
  // 12 equations of degree 12 in 12 unknowns: C(24, 12) terms each.
  const GroupDegrees d(12, {12});
  const Partition groups = one_group(12);
  EXPECT_EQ(linear_product_terms(d, groups), 12U * 2704156U);
  EXPECT_EQ(start_system(linear_product_start(d, groups, 1), names_of_unknowns(12)), std::nullopt);
  const std::uint64_t half = std::uint64_t{1} << 40;
  EXPECT_EQ(linear_product_terms(GroupDegrees{{half}, {half}}, one_group(2)),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(linear_product_terms(GroupDegrees{{3, 0}, {0, 5}}, {{0}, {1}}), 4U);
}

TEST(LinearProduct, ManyFactorsInOneUnknownHaveRootsApart) {
  const std::uint64_t d = 4;
  const GroupDegrees degrees(8, std::vector<std::uint64_t>(8, d));
  Partition own;
  for (std::uint32_t v = 0; v < 8; ++v) own.push_back({v});
  for (const std::uint64_t seed : {1UL, 2UL, 3UL}) {
    const LinearProductStart start = linear_product_start(degrees, own, seed);
    EXPECT_EQ(start.paths, 40320U * 65536U);
    for (std::size_t j = 0; j < 8; ++j) {
      std::vector<Complex> roots;
      for (const auto& row : start.factors) {
        const Point& form = row[j].forms[0];
        for (std::uint64_t k = 0; k < d; ++k) {
          roots.push_back(de_moivre_root(-form[1] / form[0], d, k));
        }
      }
      // 32 roots in a ring of area 2.2; purely random ones come closer than 0.01.
      for (std::size_t a = 0; a < roots.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) EXPECT_GT(std::abs(roots[a] - roots[b]), 0.03) << seed;
      }
    }
  }
}

TEST(LinearProduct, RefusesConstantsAndNumbersBeyond64Bits) {
  EXPECT_THROW(linear_product_start(GroupDegrees{{1, 1}, {0, 0}}, {{0}, {1}}, 1),
               std::invalid_argument);
  EXPECT_THROW(linear_product_start(GroupDegrees{{1, 1}}, {{0}, {1}}, 1), std::invalid_argument);
  const std::uint64_t half = std::uint64_t{1} << 32;
  EXPECT_THROW(linear_product_start(GroupDegrees{{half, 1}, {1, half}}, {{0}, {1}}, 1),
               std::overflow_error);
}

}  // namespace
}  // namespace moivre
