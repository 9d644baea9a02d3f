// SPDX-License-Identifier: MIT
// Powers are found with their exact bases, and nothing else is taken for one.
#include "moivre/polynomial/powers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

Polynomial polynomial_of(const std::string& text) {
  return read_system({"test", "1 3\n" + text + " + 0*x + 0*y + 0*z;\n"}).polynomials.front();
}

/// The same but for a constant factor.
bool is_multiple(const Polynomial& a, const Polynomial& b) {
  const Coefficient one{Rational(1), Rational(0)};
  return (one / a.terms.front().coefficient) * a == (one / b.terms.front().coefficient) * b;
}

PowerFree of(const std::string& text) {
  return power_free({{"x", "y", "z"}, {polynomial_of(text)}});
}

TEST(PowerFree, FindsBaseAndExponent) {
  const struct {
    std::string base;
    std::uint64_t exponent;
  } cases[] = {{"x - 1", 2},
               {"x + 1", 100},
               {"2*x^2 - 3*x*y + 5/7", 3},
               {"x^3*y - 4*z + (1/3-2*i)*x", 4},
               {"x*y + y*z + z*x - 1", 6},
               {"0.1*x + i*y - 0.25*z^2", 5},
               {"x", 7},
               {"x^2 - y^3 + x - y", 2}};
  for (const auto& expected : cases) {
    const PowerFree result = of("(" + expected.base + ")^" + std::to_string(expected.exponent));
    EXPECT_EQ(result.exponents.front(), expected.exponent) << expected.base;
    EXPECT_EQ(result.sheets, expected.exponent);
    EXPECT_TRUE(is_multiple(result.system.polynomials.front(), polynomial_of(expected.base)))
        << expected.base;
  }
}

TEST(PowerFree, TakesOutAConstantFactor) {
  const PowerFree result = of("-3*(2*x - y)^2");
  EXPECT_EQ(result.sheets, 2U);
  EXPECT_TRUE(is_multiple(result.system.polynomials.front(), polynomial_of("2*x - y")));
}

TEST(PowerFree, LeavesWhatIsNoPower) {
  for (const char* text : {"x^2 - 1", "x^500 - 1", "x^2 + 2*x*y + y^2 + 1e-30", "x^2*y^2*(x - 1)",
                           "(x - 1)^2*(y - 2)^3", "x^2 + y^2 + z^2 + 2*x*y + 2*y*z + 2*x", "4",
                           "x^4 + 2*x^2*y + y^2 + y", "x*y"}) {
    const PowerFree result = of(text);
    EXPECT_EQ(result.sheets, 1U) << text;
    EXPECT_EQ(result.system.polynomials.front(), polynomial_of(text)) << text;
  }
}

TEST(PowerFree, MultipliesTheExponentsOfASystem) {
  const System f = read_system({"test", "3\n(x-1)^2; (x+y)^3 - 1; (x*y-z)^4;\n"});
  const PowerFree result = power_free(f);
  EXPECT_EQ(result.exponents, (std::vector<std::uint64_t>{2, 1, 4}));
  EXPECT_EQ(result.sheets, 8U);
  EXPECT_EQ(result.system.variables, f.variables);
}

TEST(PowerFree, GivesBasesThatDoubleHolds) {
  const System f = read_system({"test", "((10^400 + 7)*x - 10^400 - 9)^2;"});
  const PowerFree result = power_free(f);
  EXPECT_EQ(result.sheets, 2U);
  const Polynomial& base = result.system.polynomials.front();
  ASSERT_EQ(base.terms.size(), 2U);
  for (const Term& term : base.terms) EXPECT_TRUE(std::isnormal(to_double(term.coefficient.re)));
  EXPECT_TRUE(is_multiple(base * base, f.polynomials.front()));
  EXPECT_EQ(result.system.scaled_log2.size(), 1U);
}

TEST(PowerFree, IsQuickWherePowersAreLargeOrThereAreNone) {
  std::string random = "x^500";
  for (int k = 0; k < 500; ++k) {
    random += " + " + std::to_string((k * 7919) % 1009 + 1) + "." + std::to_string(k % 97) + "*x^" +
              std::to_string(k);
  }
  EXPECT_EQ(of(random).sheets, 1U);
  EXPECT_EQ(of("(x^2 + 3*x*y - 5*y^2 + 7*z^2 - x + 2*y - 11*z + 13)^4").sheets, 4U);
  EXPECT_EQ(of("(x^2 + 3*x*y - 5*y^2 + 7*z^2 - x + 2*y - 11*z + 13)^4 + 1").sheets, 1U);
}

TEST(PowerFree, LeavesZeroPolynomials) {
  const PowerFree result = power_free({{"x"}, {Polynomial{}}});
  EXPECT_EQ(result.sheets, 1U);
  EXPECT_TRUE(result.system.polynomials.front().terms.empty());
}

}  // namespace
}  // namespace moivre
