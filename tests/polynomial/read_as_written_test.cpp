// SPDX-License-Identifier: MIT
// Are systems read as people write them: divisions, roots of numbers, equations, 2x, comments,
// Greek names?
#include <gtest/gtest.h>

#include <cmath>

#include "build.h"
#include "moivre/polynomial/digits.h"
#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

System read_text(const std::string& text) { return read_system({"text", text}); }

const auto [x, y] = unknowns<2>();

TEST(AsWritten, DenominatorsAreClearedAndKept) {
  const System f = read_text("x/(y - 1) + 2; x*y - 3;");
  EXPECT_EQ(f.polynomials[0], x + 2 * (y - 1));
  EXPECT_EQ(f.polynomials[1], x * y - 3);
  EXPECT_EQ(f.denominators, std::vector{y - 1});
}

TEST(AsWritten, NegativePowersAndNestedFractionsAreOfOneDenominatorEach) {
  const System f = read_text("x^(-2) + 1/x - 3*y; 1/(1 + 1/(2*x - 2*y)) - y;");
  EXPECT_EQ(f.polynomials[0], 1 + x - 3 * pow(x, 2) * y);
  EXPECT_EQ(f.polynomials[1], x - y - y * (x - y + Rational(1, 2)));
  EXPECT_EQ(f.denominators, (std::vector{x, x - y, x - y + Rational(1, 2)}));
}

TEST(AsWritten, TheSameDenominatorIsClearedOnce) {
  const System f = read_text("x/(1 + x^2) + y/(1 + x^2) - 1; x^3/(2 + 2*x^2) - y;");
  EXPECT_EQ(f.polynomials[0], x + y - 1 - x * x);
  EXPECT_EQ(f.polynomials[1], x * x * x / 2 - y * (1 + x * x));
  EXPECT_EQ(f.denominators, std::vector{1 + x * x});
}

TEST(AsWritten, BertinisSubfunctionsMayDivide) {
  const System f =
      read_text("variable_group x, y;\nfunction f, g;\ns = 1/y;\nf = x*s - 2;\ng = s + x;\n");
  EXPECT_EQ(f.polynomials[0], x - 2 * y);
  EXPECT_EQ(f.polynomials[1], 1 + x * y);
  EXPECT_EQ(f.denominators, std::vector{y});
}

/// The constant term of x - text.
double number_of(const std::string& text) {
  const System f = read_text("x - (" + text + ");");
  return -to_double(f.polynomials[0].terms[1].coefficient.re);
}

TEST(AsWritten, FunctionsAndRootsOfNumbersAreNumbers) {
  EXPECT_DOUBLE_EQ(number_of("sqrt(2)"), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(number_of("2^(1/3)"), std::cbrt(2.0));
  EXPECT_DOUBLE_EQ(number_of("pi"), std::acos(-1.0));
  EXPECT_DOUBLE_EQ(number_of("\u03c0"), std::acos(-1.0));
  EXPECT_DOUBLE_EQ(number_of("cos(0.3)"), std::cos(0.3));
  EXPECT_DOUBLE_EQ(number_of("tan(pi/8)"), std::tan(std::acos(-1.0) / 8));
  EXPECT_DOUBLE_EQ(number_of("exp(-100)"), std::exp(-100.0));
  EXPECT_DOUBLE_EQ(number_of("log(10)*atan(2)"), std::log(10.0) * std::atan(2.0));
  EXPECT_DOUBLE_EQ(number_of("0.5^1.5"), std::pow(0.5, 1.5));
}

TEST(AsWritten, WholeRootsAreExactAndOthersCountAsRounded) {
  EXPECT_TRUE(read_text("x - sqrt(4) - 8^(1/3) - cos(0) - sqrt(1/9);").is_exact);
  EXPECT_EQ(read_text("x - sqrt(4/9);").polynomials[0], x - Rational(2, 3));
  for (const char* number : {"sqrt(2)", "pi", "2^0.5", "sin(1)"}) {
    const System f = read_text(std::string("x - ") + number + ";");
    EXPECT_FALSE(f.is_exact) << number;
    EXPECT_FALSE(coefficient_errors(f).empty()) << number;
  }
}

TEST(AsWritten, AnEquationIsItsLeftSideLessItsRight) {
  const System f = read_text("x^2 + y^2 = 4; x = 1/y;");
  EXPECT_EQ(f.polynomials[0], x * x + y * y - 4);
  EXPECT_EQ(f.polynomials[1], x * y - 1);
}

TEST(AsWritten, ANumberRightBeforeWhatItMultipliesNeedsNoSign) {
  const System f = read_text("2x + 3(y - 1)*x - 4x^2y = 1.5x; x^2y/2 - 3i;");
  EXPECT_EQ(f.polynomials[0], 2 * x + 3 * (y - 1) * x - 4 * x * x * y - Rational(3, 2) * x);
  EXPECT_EQ(f.polynomials[1], x * x * y / 2 - Coefficient(0, 3));
}

TEST(AsWritten, CommentsRunFromTheirSignToTheEndOfTheLine) {
  const System f = read_text("# two curves; one circle\nx^2 + y^2 - 4; # a circle\nx*y - 1;\n#end");
  EXPECT_EQ(f.polynomials, (std::vector{x * x + y * y - 4, x * y - 1}));
}

TEST(AsWritten, NamesMayBeGreekAndNumbered) {
  const System f = read_text("\u03b8_1 + \u03b1\u2081 - 1; x[1]*\u03b8_1 - \u03b1\u2081 - x[1];");
  EXPECT_EQ(f.variables, (std::vector<std::string>{"\u03b8_1", "\u03b1\u2081", "x[1]"}));
}

TEST(AsWritten, WhatLooksLikeALetterAndIsNoneIsRefused) {
  EXPECT_THROW(read_text("x \u2212 1;"), ParseError);
  EXPECT_THROW(read_text("x \u00d7 y - 1;"), ParseError);
}

/// The faults as they are shown.
std::string refusal_of(const std::string& text) {
  try {
    read_text(text);
  } catch (const ParseError& refusal) {
    return refusal.what();
  }
  return "";
}

TEST(AsWritten, OtherLanguagesSignsOfACommentAreRefusedWithTheOneOfFiles) {
  const auto has = [](const std::string& text, const char* part) {
    return refusal_of(text).find(part) != std::string::npos;
  };
  for (const char* sign : {"//", "%", "/*"}) {
    const std::string comment = std::string(sign) + " two curves";
    for (const std::string& text :
         {comment + "\nx^2 + y^2 = 4\nx*y = 1\n", "x^2 + y^2 = 4 " + comment + "\nx*y = 1\n",
          comment + "\nx^2 + y^2 - 4;\nx*y - 1;\n", "x - 1; " + comment + "\ny - 1;\n",
          "x - 1; y - 1; " + comment + ", a = 2"}) {
      EXPECT_TRUE(has(text, "a comment begins with `#`")) << text << refusal_of(text);
      EXPECT_FALSE(has(text, "this line has no `=`")) << text << refusal_of(text);
    }
  }
  EXPECT_TRUE(has("x - 1;\nx\u00B7y \u2212 1\n", "no `;` behind it"));
}

TEST(AsWritten, DenominatorsAreWrittenAndReadBack) {
  for (const char* text :
       {"x/(y - 1) + 2; x*y - 3;", "1/x + 1/y - 3; x*y/(x + y) - 2/(x^2 - 3);"}) {
    const System f = read_text(text);
    for (const PolynomialFormat format : {PolynomialFormat::phcpack, PolynomialFormat::bertini}) {
      EXPECT_EQ(read_text(to_text(f, format)), f) << to_text(f, format);
    }
  }
}

TEST(AsWritten, MsolvesTextIsRead) {
  const System f = read_text("x, y\n0\nx^2 + y^2 - 4,\nx*y -\n1\n");
  EXPECT_EQ(f, make_system({"x", "y"}, {x * x + y * y - 4, x * y - 1}));
  EXPECT_EQ(detect_format("x, y\n0\nx,\ny\n"), PolynomialFormat::msolve);
  EXPECT_EQ(detect_format("2\nx;\ny;\n"), PolynomialFormat::phcpack);
  EXPECT_THROW(read_text("x\n65521\nx^2 - 1\n"), ParseError);
}

TEST(AsWritten, HomotopyContinuationsTextIsRead) {
  const System f = read_text(
      "using HomotopyContinuation\n@var y x # the unknowns\nc = 4\nf1 = x^2 + y^2 - c\n"
      "F = System([f1, 2x*y -\n 1//2*2], variables = [x, y])\nresult = solve(F)\n");
  EXPECT_EQ(f, make_system({"x", "y"}, {x * x + y * y - 4, 2 * x * y - 1}));
  const System g = read_text("@var z[1:2]\nF = [z[1] - im\n z[2]^2 - z[1]]\nsolve(System(F))\n");
  EXPECT_EQ(g.variables, (std::vector<std::string>{"z[1]", "z[2]"}));
  EXPECT_EQ(g.polynomials, (std::vector{x - Coefficient(0, 1), y * y - x}));
}

TEST(AsWritten, ParametersOfASystemAreThoseOfAFamily) {
  const std::string text = "@var x a\nF = System([x^2 - a], parameters=[a])\n";
  EXPECT_THROW(read_text(text), ParseError);
  const ParametricSystem read = read_parametric({"text", text}, {});
  EXPECT_EQ(read.declared, std::vector<std::string>{"a"});
  EXPECT_EQ(read.system, make_system({"x", "a"}, {x * x - y}));
}

}  // namespace
}  // namespace moivre
