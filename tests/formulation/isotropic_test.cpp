// SPDX-License-Identifier: MIT
// Do the closure polynomials and Phi state the same mechanism?
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "../mechanism/files.h"
#include "moivre/formulation/exact.h"
#include "moivre/formulation/formulation.h"
#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(Exact, ReadsTheDecimalThatWasTyped) {
  EXPECT_EQ(typed_decimal(0.7), Rational(7, 10));
  EXPECT_EQ(typed_decimal(-1.25e-3), Rational(-1, 800));
  EXPECT_EQ(typed_decimal(1200), Rational(1200));
  EXPECT_EQ(typed_decimal(0), Rational(0));
  EXPECT_EQ(typed_decimal(-0.08), Rational(-2, 25));
  EXPECT_EQ(typed_decimal(-0.0), Rational(0));
  EXPECT_EQ(typed_decimal(1.7976931348623157e308),
            Rational(17976931348623157) * ratio(pow(Integer(10), 292)));
  EXPECT_EQ(typed_decimal(5e-324), Rational(5) / ratio(pow(Integer(10), 324)));
  EXPECT_EQ(typed_decimal(3.141592653589793), Rational(3141592653589793, 1000000000000000));
  EXPECT_THROW(typed_decimal(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(Exact, DirectionsLieOnTheUnitCircleExactly) {
  for (int degrees = -720; degrees <= 720; degrees += 7) {
    const EnclosedUnit c = unit_at({Rational(degrees), {}, 0});
    EXPECT_EQ(c.value * conjugate(c.value), (Coefficient{1, 0})) << degrees;
    EXPECT_NEAR(std::abs(to_complex(c.value) - std::polar(1.0, degrees * kDegree)), 0, 4e-15)
        << degrees;
  }
}

TEST(Exact, ADirectionTimesAnotherIsThatOfTheSumOfAnglesToTheirErrors) {
  const EnclosedUnit step = unit_at({Rational(-37, 3), {}, 0});
  EnclosedUnit turned = unit_at({Rational(500), {}, 0});
  for (int k = 1; k <= 60; ++k) {
    turned = turned * step;
    const EnclosedUnit whole = unit_at({Rational(500) - k * Rational(37, 3), {}, 0});
    const Coefficient apart = turned.value - whole.value;
    const double error = turned.error + whole.error;
    EXPECT_LT(error, 0x1p-118);
    EXPECT_LE(to_double(abs(apart.re)), error) << k;
    EXPECT_LE(to_double(abs(apart.im)), error) << k;
  }
}

TEST(Exact, QuarterTurnsAreExact) {
  const auto at = [](int degrees) { return unit_at({Rational(degrees), {}, 0}); };
  EXPECT_EQ(at(90).value, (Coefficient{0, 1}));
  EXPECT_EQ(at(180).value, (Coefficient{-1, 0}));
  EXPECT_EQ(at(270).value, (Coefficient{0, -1}));
  EXPECT_EQ(at(-90).value, (Coefficient{0, -1}));
  EXPECT_EQ(at(360).value, (Coefficient{1, 0}));
  EXPECT_EQ(at(90).error, 0);
}

TEST(Exact, RadiansOfAQuarterTurnAreOneToTheirRounding) {
  const EnclosedUnit c = unit_at({{}, Rational(90 * kDegree), 0});
  EXPECT_EQ(c.value, (Coefficient{0, 1}));
  EXPECT_GT(c.error, 0);
  EXPECT_LT(c.error, 1e-15);
}

TEST(Exact, TheCosineOfADegreeIsKnownToItsError) {
  // cos 60 deg = 1/2, sin 30 deg = 1/2.
  const double error = to_double(abs(unit_at({60, {}, 0}).value.re - Rational(1, 2)));
  EXPECT_LE(error, kUnitError);
  EXPECT_LE(to_double(abs(unit_at({30, {}, 0}).value.im - Rational(1, 2))), kUnitError);
  EXPECT_EQ(unit_at({60, {}, 0}).error, kUnitError);
}

TEST(Isotropic, TheFourBarHasAsManyPolynomialsAsUnknowns) {
  const Formulation formulation = formulate(test::example("four-bar"), 0);
  EXPECT_EQ(formulation.system.polynomials.size(), formulation.system.variables.size());
  EXPECT_EQ(formulation.system.variables.size(), 10u);  // p, pb of three bodies; t, u of two
}

TEST(Isotropic, AnEquationThatSaysNothingIsNoAngleHeldTwice) {
  const Formulation formulation =
      formulate(test::typed("[unknowns]\nangles = [\"a\"]\n"
                            "[equations]\nidle = \"cos(a) - cos(a)\"\nrest = \"cos(a) - 0.5\"\n"),
                0);
  ASSERT_EQ(formulation.left_out.size(), 1U);
  EXPECT_EQ(formulation.left_out.front().first, "idle");
  EXPECT_EQ(formulation.left_out.front().second, "with the angles that are held it is 0 = 0");
}

std::string refusal(const std::string& equation) {
  try {
    formulate(test::typed("[unknowns]\nangles = [\"a\", \"b\"]\nlengths = [\"d\"]\n"
                          "[equations]\nloop = \"" +
                          equation + "\"\nrest = \"cos(a) + cos(b) + d\"\n"),
              0);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string refusal_because(const std::string& reason) {
  return "equation loop is no polynomial: " + reason +
         "; newton, mobility and motion take it as it is";
}

TEST(Isotropic, RefusesTypedEquationsThatAreNoPolynomials) {
  EXPECT_EQ(refusal("cos(a/2) - d + b"),
            refusal_because("the angle a is multiplied by a number that is not whole"));
  EXPECT_EQ(refusal("a - d"), refusal_because("the angle a stands outside cos and sin"));
  EXPECT_EQ(refusal("cos(d) - cos(a)"), refusal_because("the length d stands inside cos or sin"));
  EXPECT_EQ(refusal("sqrt(d) - cos(a)"),
            refusal_because("tan, asin, acos, atan, sqrt, exp and log stand over unknowns"));
  EXPECT_EQ(refusal("1/d - cos(a)"),
            refusal_because("it divides by unknowns; multiply the equation by them"));
  EXPECT_EQ(refusal("d^0.5 - cos(a)"),
            refusal_because("an exponent over unknowns must be a whole number from 0 to 64"));
  EXPECT_EQ(refusal("cos(2*a - b + 0.3)*d^2/3 - sqrt(2)*sin(3*b) - pi"), "");
}

TEST(Isotropic, MultiplesOfAnglesAreAsTheCosineSays) {
  const Formulation formulation =
      formulate(test::typed("[unknowns]\nangles = [\"a\", \"b\"]\n[equations]\n"
                            "f = \"cos(2*a - b + 0.3) + 2*sin(3*b)\"\ng = \"sin(a)\"\n"),
                0);
  const double a = 0.7;
  const double b = -1.1;
  const Point x{std::polar(1.0, a), std::polar(1.0, -a), std::polar(1.0, b), std::polar(1.0, -b)};
  Complex sum = 0;
  for (std::size_t e = 0; e < formulation.system.polynomials.size(); ++e) {
    if (formulation.equation_names[e] != "f") continue;
    for (const Term& term : formulation.system.polynomials[e].terms) {
      Complex product = to_complex(term.coefficient);
      for (const Power& p : term.monomial) product *= std::pow(x[p.variable], double(p.exponent));
      sum += product;
    }
  }
  EXPECT_NEAR(std::abs(sum - (std::cos(2 * a - b + 0.3) + 2 * std::sin(3 * b))), 0, 1e-14);
}

}  // namespace
}  // namespace moivre
