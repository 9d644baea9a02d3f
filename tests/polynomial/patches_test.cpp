// SPDX-License-Identifier: MIT
// Does a patch make a homogeneous system square, with the same roots, and do scaled points not
// depend on it?
#include "moivre/polynomial/patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "build.h"
#include "moivre/polynomial/eliminate.h"
#include "read_support.h"

namespace moivre {
namespace {

/// Two lines of P^1 x P^1 in x, y and u, v: bidegrees (1, 1) and (2, 1).
System two_planes() {
  return system_of(
      "hom_variable_group x, y;\nhom_variable_group u, v;\nfunction f, g;\n"
      "f = x*v - 2*y*u;\ng = x^2*u - y^2*v;\n");
}

TEST(Patches, AddOneLinearEquationAHomogeneousGroup) {
  const System f = two_planes();
  ASSERT_TRUE(has_homogeneous_groups(f));
  for (const std::uint64_t seed : {1UL, 2UL, 3UL}) {
    const System g = with_patches(f, seed);
    ASSERT_EQ(g.polynomials.size(), 4U);
    EXPECT_EQ(g.polynomials[0], f.polynomials[0]);
    EXPECT_EQ(g.polynomials[1], f.polynomials[1]);
    EXPECT_FALSE(has_homogeneous_groups(g));
    EXPECT_EQ(g.groups[1].variables, f.groups[1].variables);
    for (std::uint32_t k = 0; k < 2; ++k) {
      const std::vector<Term>& terms = g.polynomials[2 + k].terms;
      ASSERT_EQ(terms.size(), 3U);
      EXPECT_EQ(terms[0].monomial, (Monomial{{2 * k, 1}}));
      EXPECT_EQ(terms[1].monomial, (Monomial{{2 * k + 1, 1}}));
      EXPECT_EQ(terms[2].coefficient, (Coefficient{-1, 0}));
      for (std::size_t j = 0; j < 2; ++j) {
        EXPECT_TRUE(is_real(terms[j].coefficient));
        EXPECT_GE(abs(terms[j].coefficient.re), Rational(1, 2));
        EXPECT_LE(abs(terms[j].coefficient.re), Rational(3, 2));
      }
    }
    EXPECT_EQ(g, with_patches(f, seed));
    EXPECT_EQ(with_patches(g, seed), g);
  }
  EXPECT_NE(with_patches(f, 1), with_patches(f, 2));
}

TEST(Patches, LeaveASystemWithoutHomogeneousGroupsAlone) {
  const System f = system_of("variable_group x, y;\nfunction f, g;\nf = x^2 - y;\ng = y^2 - 1;\n");
  EXPECT_FALSE(has_homogeneous_groups(f));
  EXPECT_EQ(with_patches(f, 1), f);
}

TEST(Patches, RefuseAPolynomialThatIsNotHomogeneousInItsGroup) {
  System f = two_planes();
  f.polynomials[1] = f.polynomials[1] + unknown(0);
  EXPECT_THROW(with_patches(f, 1), std::invalid_argument);
}

TEST(Patches, DegreesInAGroupCountItsVariablesOnly) {
  const Polynomial p = two_planes().polynomials[1];
  EXPECT_EQ(degrees_in(p, {0, 1}), (std::set<std::uint64_t>{2}));
  EXPECT_EQ(degrees_in(p, {0}), (std::set<std::uint64_t>{0, 2}));
  EXPECT_TRUE(is_homogeneous(p, {2, 3}));
  EXPECT_FALSE(is_homogeneous(p, {0}));
  EXPECT_TRUE(is_homogeneous(Polynomial{}, {0}));
}

// x v = 2 y u and x^2 u = y^2 v: y = 0 or v = 0 leaves no point; with y = v = 1, x = 2u and 4u^3 =
// 1.
TEST(Patches, NormalizedPointsDoNotDependOnThePatch) {
  const System f = two_planes();
  const double u = std::cbrt(0.25);
  const Point expected{1, 1 / (2 * u), u, 1};
  for (const Complex scale : {Complex(1, 0), Complex(-3, 2), Complex(0, 1e-8), Complex(1e9, -1)}) {
    const Point x = normalized(f.groups, {2 * u * scale, scale, u * scale, scale});
    for (std::size_t j = 0; j < 4; ++j) EXPECT_LT(std::abs(x[j] - expected[j]), 1e-14) << scale;
    EXPECT_EQ(x[0], 1.0);
  }
}

TEST(Patches, OfCoordinatesOfOneSizeTheFirstBecomesOne) {
  const std::vector<VariableGroup> groups{{{0, 1, 2}, true}, {{3}, false}};
  const Point x = normalized(groups, {Complex(0, 1), Complex(1 + 1e-15, 0), 0.1, 7});
  EXPECT_EQ(x[0], 1.0);
  EXPECT_LT(std::abs(x[1] - Complex(0, -1)), 1e-14);
  EXPECT_EQ(x[3], 7.0);
  EXPECT_EQ(normalized(groups, {0, 0, 0, 2}), (Point{0, 0, 0, 2}));
}

TEST(Groups, FollowTheirUnknownsThroughElimination) {
  const System f = system_of(
      "variable_group w, a;\nvariable_group x, y;\nvariable_group b;\nvariable_group z;\n"
      "function f1, f2, f3, f4, f5, f6;\nf1 = w - 3;\nf2 = b + 2;\nf3 = a^2 + w*x*y + 1;\n"
      "f4 = x^2*b - z;\nf5 = y^2 + a*z + 5;\nf6 = z^2 - x*y + a;\n");
  const System reduced = eliminate(f).system;
  ASSERT_EQ(reduced.variables, (std::vector<std::string>{"a", "x", "y", "z"}));
  EXPECT_EQ(reduced.groups,
            (std::vector<VariableGroup>{{{0}, false}, {{1, 2}, false}, {{3}, false}}));
}

}  // namespace
}  // namespace moivre
