// SPDX-License-Identifier: MIT
// Is the tree the one that the text means, with exact numbers, and does the first fault say where
// and what?
#include "moivre/expression/expression.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace moivre {
namespace {

/// The tree in prefix form, to compare whole trees by one string.
std::string prefix(const Expression& e) {
  const auto wrapped = [&](const std::string& head) {
    std::string text = '(' + head;
    for (const Expression& operand : e.operands) text.append(" ").append(prefix(operand));
    return text + ')';
  };
  switch (e.kind) {
    case Expression::Kind::number: {
      std::ostringstream text;
      text << e.number;
      return text.str();
    }
    case Expression::Kind::name:
      return e.name;
    case Expression::Kind::sum:
      return wrapped("+");
    case Expression::Kind::product:
      return wrapped("*");
    case Expression::Kind::negate:
      return wrapped("-");
    case Expression::Kind::reciprocal:
      return wrapped("1/");
    case Expression::Kind::power:
      return wrapped("^");
    case Expression::Kind::call:
      return wrapped(e.name);
  }
  return {};
}

std::string tree(const std::string& text) {
  std::vector<Diagnostic> faults;
  const Expression e = parse_expression(text, {}, faults);
  return faults.empty() ? prefix(e) : "fault: " + faults.front().message;
}

Diagnostic fault(const std::string& text) {
  std::vector<Diagnostic> faults;
  parse_expression(text, {}, faults);
  EXPECT_EQ(faults.size(), 1U);
  return faults.empty() ? Diagnostic{} : faults.front();
}

TEST(Expression, KeepsSumsAndProductsFlat) {
  EXPECT_EQ(tree("a + b - c*d/e"), "(+ a b (- (* c d (1/ e))))");
  EXPECT_EQ(tree("((a))"), "a");
}

TEST(Expression, BindsPowersTighterThanSignsAndToTheRight) {
  EXPECT_EQ(tree("-x^2"), "(- (^ x 2))");
  EXPECT_EQ(tree("x^2^3"), "(^ x (^ 2 3))");
  EXPECT_EQ(tree("x**-2*y"), "(* (^ x (- 2)) y)");
  EXPECT_EQ(tree("+a*-b"), "(* a (- b))");
}

TEST(Expression, ReadsNumbersExactly) {
  EXPECT_EQ(tree("3.1"), "31/10");
  EXPECT_EQ(tree("1.25E-02"), "1/80");
  EXPECT_EQ(tree("007.50e1"), "75");
  EXPECT_EQ(tree("0.0e999999999999"), "0");
}

TEST(Expression, ReadsCallsAndIndexedNames) {
  EXPECT_EQ(tree("b*cos(phi1) + atan2(y, x[2])"), "(+ (* b (cos phi1)) (atan2 y x[2]))");
  EXPECT_EQ(tree("f ( a+b , g(c) )"), "(f (+ a b) (g c))");
}

TEST(Expression, RemembersWhereEachNodeStands) {
  std::vector<Diagnostic> faults;
  const SourcePosition begin{.offset = 100, .line = 7, .column = 5};
  const Expression e = parse_expression("a +\n  b*c", begin, faults);
  EXPECT_EQ(e.at, begin);
  EXPECT_EQ(e.operands[1].at, (SourcePosition{.offset = 106, .line = 8, .column = 3}));
  EXPECT_EQ(e.operands[1].operands[1].at, (SourcePosition{.offset = 108, .line = 8, .column = 5}));
}

TEST(Expression, PointsAtTheFault) {
  const Diagnostic stray = fault("x\n + * y");
  EXPECT_EQ(stray.at, (SourcePosition{.offset = 5, .line = 2, .column = 4}));
  EXPECT_EQ(stray.message, "expected a number, a name or `(`, found the operator `*`");
  EXPECT_EQ(fault("f(a, )").at.column, 6U);
  EXPECT_EQ(fault("f(a").message, "unbalanced parenthesis: this `(` is never closed");
  EXPECT_EQ(fault("f(a").at.column, 2U);
  EXPECT_EQ(fault("").message, "expected a number, a name or `(`, but the expression ends here");
  EXPECT_EQ(fault("a, b").message, "unexpected character: `,`");
  EXPECT_EQ(fault("a \u2212 b").message, "unexpected character: `\u2212`; type `-` for it");
  EXPECT_EQ(fault("a\u00B2").message, "unexpected character: `\u00B2`; type `^2` for it");
  const auto advice = [](const char* text) {
    const std::string message = fault(text).message;
    return message.substr(std::min(message.find("; "), message.size()));
  };
  EXPECT_EQ(advice("\u221A2*a"), "; type `sqrt(2)` for `\u221A2`");
  EXPECT_EQ(advice("a - \u00BD"), "; type `1/2` for it");
  EXPECT_EQ(advice("a \u2192 2"), "; type `=` for it");
  EXPECT_EQ(advice("a \u2260 0").substr(0, 17), "; conditions have");
  EXPECT_EQ(advice("a_{1} + b"), "; an index is typed `a_1`");
  EXPECT_EQ(advice("a^{2} + b"), "; an exponent is typed `x^2` or `x^(-2)`");
  for (const char* text : {"a // b", "// b", "a /* b */", "/* b */", "a % b", "% b"}) {
    EXPECT_EQ(advice(text).substr(0, 27), "; a comment begins with `#`") << text;
  }
  EXPECT_EQ(advice("a*/b"), "");
  EXPECT_EQ(fault("a \u2297 b").message, "unexpected character: `\u2297`");
  EXPECT_EQ(fault("a + \u00B7").message,
            "expected a number, a name or `(`, found `\u00B7`; type `*` for it");
  EXPECT_EQ(fault("a \xE2 b").message, "unexpected character: the byte 0xE2");
  EXPECT_EQ(fault("1.5.2").message,
            "an operator is missing before `.2` (a product is written with `*`)");
}

TEST(Expression, NamesEveryNumberOutOfRange) {
  std::vector<Diagnostic> faults;
  parse_expression("1e400 + x*1e-400", {}, faults);
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[1].at.column, 11U);
}

TEST(Expression, NamesTheFaultOfEverySummand) {
  const auto columns = [](const std::string& text) {
    std::vector<Diagnostic> faults;
    parse_expression(text, {}, faults);
    std::vector<std::size_t> all;
    for (const Diagnostic& one : faults) all.push_back(one.at.column);
    return all;
  };
  using Columns = std::vector<std::size_t>;
  EXPECT_EQ(columns("2 x + 3 y - 1e400*z"), (Columns{3, 9, 13}));
  EXPECT_EQ(columns("2 x^1e-3 - 1e+5 y"), (Columns{3, 17}))
      << "the sign of a number begins no summand";
  EXPECT_EQ(columns("x*(y - 1 + 2 z"), (Columns{14, 3})) << "and the parenthesis is not closed";
  EXPECT_EQ(columns("(2 z + 3 y)*x) + 4 t + u)"), (Columns{4, 14, 20, 25}));
  EXPECT_EQ(columns("x y +"), (Columns{3, 6}));
  EXPECT_EQ(columns(std::string(257, '(') + "x" + std::string(257, ')') + "+ 2 y"),
            (Columns{257, 520}));
}

TEST(Expression, TakesANumberRightBeforeWhatItMultiplies) {
  EXPECT_EQ(tree("2x + 3(y - 1)"), tree("2*x + 3*(y - 1)"));
  EXPECT_EQ(tree("4x^2y"), tree("4*x^2*y"));
  EXPECT_EQ(fault("1/2x").at.column, 4U);
}

TEST(Expression, RefusesMoreDigitsThanAnyDataHas) {
  EXPECT_EQ(fault("0." + std::string(6000, '3')).message,
            "the number `0." + std::string(38, '3') + "...` has more than 5000 digits");
  EXPECT_EQ(tree("1." + std::string(100'000, '0')), "1");
}

TEST(Expression, MayNestAsDeepAsStatedAndNoDeeper) {
  const auto nested = [](std::size_t depth) {
    return tree(std::string(depth, '(') + "x" + std::string(depth, ')'));
  };
  const auto raised = [](std::size_t depth) {
    std::string text;
    for (std::size_t k = 0; k < depth; ++k) text += "x^";
    return tree(text + "2");
  };
  EXPECT_EQ(raised(256).substr(0, 6), "(^ x (");
  const std::string refusal =
      "fault: parentheses, calls and exponents stand more than 256 deep in one another";
  EXPECT_EQ(raised(257), refusal);
  EXPECT_EQ(nested(256), "x");
  EXPECT_EQ(nested(257), refusal);
}

TEST(Summands, AreHandedOnWithTheirSignsAndBehindAFaultAsWell) {
  const auto summands = [](const std::string& text) {
    std::vector<Diagnostic> faults;
    std::string trees;
    parse_summands(text, {}, faults, [&](const Expression& e) { trees += prefix(e) + '\n'; });
    return trees + (faults.empty() ? "" : "fault");
  };
  EXPECT_EQ(summands("-a*b + (c - d)^2 - 3"), "(- (* a b))\n(^ (+ c (- d)) 2)\n(- 3)\n");
  EXPECT_EQ(summands("+f(a + b, c)"), "(f (+ a b) c)\n");
  EXPECT_EQ(summands("a + b^(c + d) ++ e"), "a\n(^ b (+ c d))\ne\nfault");
}

TEST(NamesIn, FindsEveryNameEvenInTextThatDoesNotParse) {
  std::vector<std::string> names;
  for (const NamePlace& place : names_in("2x y1 + 1e5*e5) sin (z_)", {}))
    names.emplace_back(place.name);
  EXPECT_EQ(names, (std::vector<std::string>{"x", "y1", "e5", "z_"}));
}

}  // namespace
}  // namespace moivre
