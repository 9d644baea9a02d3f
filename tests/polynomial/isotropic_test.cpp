// SPDX-License-Identifier: MIT
// Is a system in isotropic unknowns the same system, with its errors, and are the pairs those whose
// squares belong together?
#include "moivre/polynomial/isotropic.h"

#include <gtest/gtest.h>

#include "moivre/polynomial/eliminate.h"
#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

System read(const std::string& text) { return read_system({"test", text}); }

Complex value(const Polynomial& p, const std::vector<Complex>& x) {
  Complex sum = 0;
  for (const Term& term : p.terms) {
    Complex product = to_complex(term.coefficient);
    for (const Power& power : term.monomial) {
      for (std::uint32_t k = 0; k < power.exponent; ++k) product *= x[power.variable];
    }
    sum += product;
  }
  return sum;
}

TEST(Isotropic, PairsHaveTheSquaresOfOneCoefficient) {
  using Pairs = std::vector<IsotropicPair>;
  EXPECT_EQ(isotropic_pairs(read("2\nx^2 + y^2 - 1;\nx*y - 2;\n")), (Pairs{{0, 1}}));
  EXPECT_EQ(isotropic_pairs(read("2\n3*x^2 + 3*y^2 + x - 1;\nx*y - 2;\n")), (Pairs{{0, 1}}));
  EXPECT_EQ(isotropic_pairs(read("2\nx^2 - y^2 - 1;\nx*y - 2;\n")), Pairs{});
  EXPECT_EQ(isotropic_pairs(read("3\nx^2 + y^2 + z^2 - 1;\nx*y - 2;\nz - x*y;\n")), Pairs{});
}

TEST(Isotropic, AnUnknownOfTwoPairsIsInNone) {
  const System f = read("4\nx^2 + y^2 - 1;\ny^2 + z^2 - 2;\nz*w - x;\nw^2 + x*y - 1;\n");
  EXPECT_TRUE(isotropic_pairs(f).empty());
}

TEST(Isotropic, ASumOfSquaresIsOneProduct) {
  const System f = read("2\nx^2 + y^2 - 1;\nx^3*y - 2*y + 5;\n");
  const System g = in_isotropic(f, isotropic_pairs(f));
  EXPECT_EQ(g.polynomials[0].terms.size(), 2U);
  EXPECT_EQ(degree(g.polynomials[0].terms[0].monomial), 2U);
  EXPECT_TRUE(broken_rules(System{{"u", "v"}, g.polynomials}).empty());
}

TEST(Isotropic, UnknownsGoThereAndBackWithTheValuesOfTheEquations) {
  const System f = read("3\nx^2 + y^2 - 1 + z;\nx^3*y - 2*y*z + 5;\nz^2*x - y;\n");
  const auto pairs = isotropic_pairs(f);
  ASSERT_EQ(pairs.size(), 1U);
  const System g = in_isotropic(f, pairs);
  const std::vector<Complex> x{{0.3, -1}, {2, 0.25}, {-1.5, 0.5}};
  std::vector<Complex> u = x;
  enter_isotropic(pairs, u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(std::abs(value(g.polynomials[k], u) - value(f.polynomials[k], x)), 0, 1e-13);
  }
  leave_isotropic(pairs, u, [](const Coefficient& c) { return to_complex(c); });
  for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(std::abs(u[j] - x[j]), 0, 1e-15);
}

// 1.23456789012 is rounded, and stands by x^2 alone: u v has half of it, u^2 and v^2 a quarter.
TEST(Isotropic, ErrorsOfNumbersGoOver) {
  const System f = read("2\n1.23456789012*x^2 + x*y - 1;\nx^2 + y^2 - 4;\n");
  const CoefficientErrors errors = coefficient_errors(f);
  ASSERT_FALSE(errors.empty());
  const auto pairs = isotropic_pairs(f);
  const System g = in_isotropic(f, pairs);
  const CoefficientErrors changed = errors_in_isotropic(f, errors, pairs);
  double before = 0, after = 0;
  for (std::size_t t = 0; t < f.polynomials[0].terms.size(); ++t) {
    before += bound(errors[0][t]) * std::abs(to_complex(f.polynomials[0].terms[t].coefficient));
  }
  for (std::size_t t = 0; t < g.polynomials[0].terms.size(); ++t) {
    after += bound(changed[0][t]) * std::abs(to_complex(g.polynomials[0].terms[t].coefficient));
  }
  EXPECT_NEAR(after, before, 1e-3 * before);  // 1/4 + 1/2 + 1/4
  for (const NumberErrors& exact : changed[1]) EXPECT_TRUE(exact.empty());
  EXPECT_TRUE(errors_in_isotropic(f, {}, pairs).empty());
}

TEST(Isotropic, AReductionLeavesThemFirst) {
  const System f = read("3\nx^2 + y^2 - z;\nx*y - 2;\nz - x - 4;\n");
  const Reduction plain = eliminate(f);
  const auto pairs = isotropic_pairs(plain.system);
  ASSERT_EQ(pairs.size(), 1U);
  const Reduction changed = in_isotropic(plain, pairs);
  const std::vector<Complex> x{{1, 1}, {1, -1}, {5, 1}};
  EXPECT_EQ(restore(changed, kept_of(changed, x)), restore(plain, kept_of(plain, x)));
}

}  // namespace
}  // namespace moivre::test
