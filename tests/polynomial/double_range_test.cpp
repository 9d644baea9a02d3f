// SPDX-License-Identifier: MIT
// Is an equation that double does not hold multiplied by a power of two, exactly, and refused only
// where none helps?
#include "moivre/polynomial/double_range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/digits.h"
#include "moivre/polynomial/read.h"
#include "read_support.h"

namespace moivre {
namespace {

const Polynomial x = unknown(0);
const Polynomial y = unknown(1);

Rational ten_to(int exponent) {
  const Integer power = pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? ratio(1, power) : ratio(power);
}

bool is_held(const Polynomial& p) {
  for (const Term& term : p.terms) {
    const double size = std::abs(to_double(term.coefficient.re));
    if (!std::isfinite(size) || size == 0) return false;
  }
  return true;
}

/// The system of a text whose one equation is to be 2^k p, k not 0.
System scaled_system(const std::string& text, const Polynomial& p) {
  System f = system_of(text);
  EXPECT_EQ(f.scaled_log2.size(), 1U) << text;
  if (f.scaled_log2.size() != 1) return f;
  EXPECT_NE(f.scaled_log2[0], 0) << text;
  EXPECT_TRUE(is_held(f.polynomials[0])) << text;
  EXPECT_EQ(times_power_of_two(f.polynomials[0], -f.scaled_log2[0]), p) << text;
  return f;
}

TEST(DoubleRange, LeavesAnEquationAloneThatDoubleHolds) {
  for (const char* text : {"1e300*x - 1e-300;", "4.9e-324*x - 1.7e308;", "x - x;",
                           "1e400*x*1e-400 - 1e5/1e3;", "10^400*x/10^399 - sqrt(1e400)/1e200;"}) {
    EXPECT_TRUE(system_of(text).scaled_log2.empty()) << text;
  }
  EXPECT_EQ(system_of("1e400*x*1e-400 - 1;").polynomials[0], x - 1);
}

TEST(DoubleRange, MultipliesTheWholeEquationExactly) {
  scaled_system("1e400*x^2 - 2e400;", ten_to(400) * (x * x - 2));
  scaled_system("1e-400*x^2 = 2e-400", ten_to(-400) * (x * x - 2));
  scaled_system("1e400*x - 1;", ten_to(400) * x - 1);
  scaled_system("x - 1e-400;", x - ten_to(-400));
  scaled_system("x, y\n0\n1e400*x - 1e300*y\n", ten_to(400) * x - ten_to(300) * y);
  scaled_system("variable_group x; function f; constant c; c = 1e400; f = c*x - 3*c;",
                ten_to(400) * (x - 3));
  scaled_system("@var x\nSystem([1e400*x - 3e400])", ten_to(400) * (x - 3));
  scaled_system("(1e200*x - 1e200)^2;", ten_to(400) * ((x - 1) * (x - 1)));
}

TEST(DoubleRange, ScalesNoOtherEquation) {
  const System f = system_of("x - y = 1\n1e400*x - 1e400*y = 2e400\nx*y = 1\n");
  ASSERT_EQ(f.scaled_log2.size(), 3U);
  EXPECT_EQ(f.scaled_log2[0], 0);
  EXPECT_LT(f.scaled_log2[1], 0);
  EXPECT_EQ(f.scaled_log2[2], 0);
  EXPECT_EQ(f.polynomials[2], x * y - 1);
}

TEST(DoubleRange, TakesAllThatSomePowerOfTwoBringsIntoIt) {
  // 2^1023 and 2^-1074 are the ends of double's range.
  const auto spread = [](unsigned bits) {
    return "x*2^5000*2^" + std::to_string(bits) + " - 2^5000;";
  };
  for (const unsigned bits : {1U, 1000U, 2045U, 2046U, 2097U}) {
    const System f = system_of(spread(bits));
    EXPECT_TRUE(is_held(f.polynomials[0])) << bits;
  }
  expect_faults(spread(2099),
                {{1, 1,
                  "multiplied out, a coefficient is out of the range of double (4.9e-324 to "
                  "1.8e308), whatever the whole is multiplied by"}});
}

TEST(DoubleRange, JudgesBothPartsOfAComplexCoefficient) {
  EXPECT_EQ(faults_of("(1e400 + 1e300*i)*x - 1e350;").size(), 0U);
  EXPECT_EQ(faults_of("(1e400 + 1e-300*i)*x - 1e350;").size(), 1U);
}

TEST(DoubleRange, HoldsDenominatorsAndConditions) {
  const System f = system_of("x/(1e400*x - 1) = 1\n1e400*x > 3e400\n");
  ASSERT_EQ(f.denominators.size(), 1U);
  EXPECT_TRUE(is_held(f.denominators[0]));
  ASSERT_EQ(f.conditions.size(), 1U);
  EXPECT_TRUE(is_held(f.conditions[0].p));
  EXPECT_EQ(faults_of("x = 1\n1e400*x > 3e-400\n").size(), 1U);
  EXPECT_EQ(faults_of("x/(1e400*x^2 - x - 1e-400) = 1\n").size(), 1U);
}

TEST(DoubleRange, LetsNumbersBeRoundedAsTheyWereTyped) {
  const auto relative_error = [](const std::string& power) {
    const std::string text = "3.14159265358979e" + power + "*x - 2e" + power + ";";
    const CoefficientErrors errors = coefficient_errors(system_of(text));
    return errors.empty() ? 0.0 : bound(errors.at(0).at(0));
  };
  EXPECT_GT(relative_error("-10"), 0);
  EXPECT_NEAR(relative_error("-400") / relative_error("-10"), 1, 1e-9);
  const CoefficientErrors beside =
      coefficient_errors(system_of("1e-400*x - 3.14159265358979e-400*y;1e400*x - 3e400*y^2;"));
  ASSERT_EQ(beside.size(), 2U);
  EXPECT_TRUE(beside[1][0].empty()) << "whole numbers are meant as they stand";
}

TEST(DoubleRange, IsWrittenAsAnEquationThatReadsBack) {
  const System f = system_of("1e400*x^2 - 3e400;1e-400*x*y - 1e-390;");
  for (const PolynomialFormat format : {PolynomialFormat::phcpack, PolynomialFormat::bertini}) {
    const System again = read_system({"again", to_text(f, format)});
    EXPECT_EQ(again, f);
    EXPECT_EQ(again.scaled_log2, f.scaled_log2) << "written as typed";
  }
}

TEST(DoubleRange, HoldsForSystemsThatArePutTogetherInCode) {
  const System f = make_system({"x"}, {ten_to(400) * (x - 3)});
  EXPECT_EQ(f, system_of("1e400*x - 3e400;"));
  try {
    make_system({"x", "y"}, {ten_to(400) * x - ten_to(-400) * y, x - y});
    FAIL() << "no power of two brings that into double's range";
  } catch (const InvalidInput& error) {
    ASSERT_EQ(error.broken_rules().size(), 1U);
    EXPECT_NE(error.broken_rules()[0].find("equation 1: a coefficient is out of the range"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace moivre
