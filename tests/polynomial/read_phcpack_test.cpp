// SPDX-License-Identifier: MIT
// Does PHCpack's text give the exact system, and is every kind of fault named with line, column and
// reason?
#include <gtest/gtest.h>

#include "moivre/expression/expression.h"
#include "read_support.h"

namespace moivre {
namespace {

const Polynomial x = unknown(0);
const Polynomial y = unknown(1);
Polynomial number(const Rational& r) { return constant({r, 0}); }

TEST(PhcReader, ReadsPolynomialsWithTheirCountLine) {
  const System f = system_of("2\n x^2 + y**2 - 5;\n x*y - 2;\n");
  EXPECT_EQ(f.variables, (std::vector<std::string>{"x", "y"}));
  ASSERT_EQ(f.polynomials.size(), 2U);
  EXPECT_EQ(f.polynomials[0], (x * x + y * y + number(-5)));
  EXPECT_EQ(f.polynomials[1], (x * y + number(-2)));
}

TEST(PhcReader, ReadsTheSameTextWithoutTheCountLine) {
  EXPECT_EQ(system_of("x^2+y^2-5;x*y-2;\nTITLE : two; conics\n"),
            system_of("2\nx^2+y^2-5;x*y-2;\nTITLE : two; conics\n"));
}

TEST(PhcReader, OrdersVariablesByFirstAppearance) {
  EXPECT_EQ(system_of("2\nzeta - a;\na*zeta;\n").variables,
            (std::vector<std::string>{"zeta", "a"}));
}

TEST(PhcReader, KeepsDecimalsExactly) {
  EXPECT_EQ(system_of("1\n3.1*x - 1.25E-02;\n").polynomials[0],
            Coefficient(Rational(31, 10), 0) * x + number(Rational(-1, 80)));
  EXPECT_EQ(system_of("1\n.5*x+5.*x;\n").polynomials[0], Coefficient(Rational(11, 2), 0) * x);
}

TEST(PhcReader, TakesEitherLetterForTheImaginaryUnit) {
  EXPECT_EQ(system_of("1\n(1+2*i)*(1-2*I)*x + i^2 + i*I*i*I;\n").polynomials[0],
            Coefficient(5, 0) * x);
}

TEST(PhcReader, DividesByNumbersExactly) {
  EXPECT_EQ(system_of("1\n(1/2)*x + x/3 - 2/4/5;\n").polynomials[0],
            Coefficient(Rational(5, 6), 0) * x + number(Rational(-1, 10)));
  EXPECT_EQ(system_of("1\nx/(2*i);\n").polynomials[0], Coefficient(0, Rational(-1, 2)) * x);
}

TEST(PhcReader, MultipliesOutProductsAndPowers) {
  EXPECT_EQ(system_of("2\n(x-y)^3*(x+y);\ny;\n").polynomials[0],
            system_of("2\nx^4-2*x^3*y+2*x*y^3-y^4;\ny;\n").polynomials[0]);
  EXPECT_EQ(system_of("1\nx^2^3 - x^0;\n").polynomials[0], system_of("1\nx^8-1;\n").polynomials[0]);
  EXPECT_EQ(system_of("1\n-x^2 + -2*x - -3 + x*-4;\n").polynomials[0],
            system_of("1\n3-6*x-x^2;\n").polynomials[0]);
}

TEST(PhcReader, TakesAPowerOfFiveThousand) {
  EXPECT_EQ(degree(system_of("1\nx^5000 - 1;\n").polynomials[0]), 5000U);
}

TEST(PhcReader, ReadsMoreOrFewerPolynomialsThanUnknownsWhereTheFileSaysSo) {
  EXPECT_EQ(system_of("3 2\nx^2+y^2-5;x*y-2;x+y-1;\n").polynomials.size(), 3U);
  EXPECT_EQ(system_of("1 2\nx^2+y^2-5;\n").variables.size(), 2U);
  EXPECT_EQ(system_of("x^2+y^2-5;\n").variables.size(), 2U);
}

TEST(PhcReader, IgnoresTextBehindTheLastPolynomial) {
  const System f = system_of("1\nx^2-1;\n");
  EXPECT_EQ(system_of("1\nx^2-1;\n\nTITLE : a; b; c\nTHE SOLUTIONS :\n2 1\n====\n"), f);
  EXPECT_EQ(system_of("1\nx^2-1;\n\nROOT COUNTS :\n\n total degree : 2;\n"), f);
  EXPECT_EQ(system_of("1\nx^2-1;\n\nTHE SOLUTIONS :\n2 1\n====;\n"), f);
  EXPECT_EQ(system_of("1\nx^2-1;\n a remark without a heading\n"), f);
  EXPECT_EQ(system_of("x^2-1;\n a remark without a heading\n"), f);
}

TEST(PhcReader, AcceptsTheLineEndsOfOtherMachines) {
  EXPECT_EQ(system_of("2\r\nx-1;\r\n\ty-2;\r\n"), system_of("2\nx-1;\ny-2;\n"));
}

const std::string kIsOneMissing = ", which begins with a sign: is a `;` missing before it?";

TEST(PhcReader, NamesTheLineOfALostSemicolonThatStillParses) {
  const std::string text = "3\nx^2 + y^2 - 1\n-x + z;\nz - 1;\n";
  const std::vector<Diagnostic> faults = faults_of(text);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].at.line, 1U);
  EXPECT_EQ(faults[0].at.column, 1U);
  EXPECT_EQ(faults[0].message,
            "expected 3 polynomials, found 2:\n"
            "  polynomial 1 begins at line 2: x^2 + y^2 - 1\n"
            "  polynomial 2 begins at line 4: z - 1\n"
            "  polynomial 1 goes on at line 3" +
                kIsOneMissing);
}

TEST(PhcReader, AsksFirstWhereALineEndsWithANumberOrABlankLineFollows) {
  const std::string text = "3\nx*y\n + x*z\n + y*z - 7\n + z;\n x*y\n + z - 1\n\n- x;\n";
  const auto at_line = [](int polynomial, int line) {
    return "\n  polynomial " + std::to_string(polynomial) + " goes on at line " +
           std::to_string(line) + kIsOneMissing;
  };
  EXPECT_EQ(faults_of(text)[0].message,
            "expected 3 polynomials, found 2:\n"
            "  polynomial 1 begins at line 2: x*y\n"
            "  polynomial 2 begins at line 6: x*y" +
                at_line(1, 5) + at_line(2, 9) + at_line(1, 3) + at_line(1, 4) + at_line(2, 7));
}

TEST(PhcReader, AsksForNoSemicolonInsideParentheses) {
  EXPECT_EQ(faults_of("2\n(x\n + y)*x\n + 1;\n")[0].message,
            "expected 2 polynomials, found 1:\n"
            "  polynomial 1 begins at line 2: (x\n"
            "  polynomial 1 goes on at line 4" +
                kIsOneMissing);
}

TEST(PhcReader, FindsTheCountLineBelowBlankLines) {
  expect_faults("\n \n  2\nx - 1;\n",
                {{3, 3, "expected 2 polynomials, found 1"}, {3, 3, "expected 2 unknowns"}});
}

TEST(PhcReader, NamesTheLineOfALostSemicolonThatDoesNotParse) {
  expect_faults(
      "2\nx^2 - 1\n\nx*y - 1;\n",
      {{1, 1, "expected 2 polynomials, found 1"},
       {4, 1, "an operator is missing before `x`; or is a `;` missing at the end of line 2?"}});
}

TEST(PhcReader, TakesANameAboveAParenthesisForALostSemicolon) {
  expect_faults(
      "2\nx^2 - y\n(x + 1)*y;\n",
      {{1, 1, "expected 2 polynomials, found 1"},
       {3, 1, "an operator is missing before `(`; or is a `;` missing at the end of line 2?"}});
}

TEST(PhcReader, SaysThatTheLastPolynomialLacksItsSemicolon) {
  expect_faults("2\nx - y;\nx + y\nTITLE : two lines\n",
                {{1, 1, "the text at line 3 has no `;` behind it: x + y"}});
  expect_faults("x - y;\nx + y\nTITLE : two lines\n",
                {{2, 1, "this polynomial has no `;` behind it"}});
  expect_faults("x - 1", {{1, 1, "no equation found: one equation a line has one `=`"}});
}

TEST(PhcReader, TakesEquationsALineEachWithoutSemicolons) {
  const System typed = system_of("x^2 + y^2 = 4;\nx*y = 1;\n");
  EXPECT_EQ(system_of("x^2 + y^2 = 4\nx*y = 1"), typed);
  EXPECT_EQ(system_of("# two curves\n\n  x^2 + y^2 = 4   # a circle\r\n\nx*y = 1\nTITLE : two\n"),
            typed);
  expect_faults("x^2 + y^2 = 4\nx*y ! 1 = 0\n", {{2, 5, "unexpected character: `!`"}});
}

TEST(PhcReader, NeedsSemicolonsWhereALineMayGoOn) {
  expect_faults("x^2 + y^2\n = 4\nx*y = 1\n",
                {{1, 1, "this line has no `=`"}, {2, 2, "a side of this `=` is missing"}});
  expect_faults("x = 3\nx*y +\n y^2\n2*z = 1\n",
                {{2, 1, "this line has no `=`"}, {3, 2, "every equation ends with `;`"}});
  expect_faults("x + 1\n- y\n", {{1, 1, "no equation found: one equation a line"}});
  expect_faults("x = 1, y = 2\n", {{1, 6, "unexpected character: `,`"}, {1, 10, "a second `=`"}});
  expect_faults("2\nx = 1\ny = 2\n", {{1, 1, "expected 2 polynomials, found 0"}});
}

TEST(PhcReader, SaysWhyThereIsNoEquation) {
  expect_faults("# a comment\n# alone\n", {{3, 1, "comments or headings alone"}});
  expect_faults("1.5 2.5\n-3 4e5\n", {{1, 1, "the file has numbers alone"}});
  expect_faults("1 2 3\n4 5 6\n", {{1, 1, "the count line holds 3 numbers"}});
  expect_faults("hello world\n", {{1, 1, "no equation found: one equation a line has one `=`"}});
  expect_faults("=\n", {{1, 1, "a side of this `=` is missing"}});
}

TEST(PhcReader, SaysThatOneSemicolonAsksForOthers) {
  expect_faults("x = 1;\ny = 2\n",
                {{2, 1, "no `;` behind it: where one equation has it (line 1), each needs it"}});
  expect_faults("x = 1\ny = 2;\n",
                {{1, 1, "no `;` behind it: where one equation has it (line 2), each needs it"}});
  expect_faults(
      "x + z = 1;\ny = 2\nx*z = 3\nz^2 = 1;\n",
      {{2, 1, "this equation has no `;` behind it"}, {3, 1, "this equation has no `;` behind it"}});
}

TEST(PhcReader, TakesTwoEqualsSignsTogetherForOne) {
  EXPECT_EQ(system_of("x^2 == 4\nx*y==1\n"), system_of("x^2 = 4;\nx*y = 1;\n"));
  EXPECT_EQ(system_of("x^2 == 4; y\n== 1;"), system_of("x^2 = 4; y = 1;"));
  expect_faults("x === 1\n", {{1, 5, "a second `=`"}});
  expect_faults("x = = 1\n", {{1, 5, "a second `=`"}});
  expect_faults("x + = 1 = 2 y\n", {{1, 5, "expected a number"}, {1, 9, "a second `=`"}});
}

TEST(PhcReader, CountsPolynomialsTooMany) {
  expect_faults("1\nx^2 - 1;\nx - 2;\n", {{1, 1, "expected 1 polynomial, found 2"}});
  expect_faults("1\nx^2-1;\nfrom a book; with a semicolon\nTITLE : t\n",
                {{1, 1, "expected 1 polynomial, found 2"}, {3, 6, "an operator is missing"}});
}

TEST(PhcReader, RefusesACountLineThatCannotBe) {
  expect_faults("2 2 2\nx;y;\n", {{1, 1, "the count line holds 3 numbers"}});
  expect_faults("0\n", {{1, 1, "the count line announces no polynomial, found 0"}});
  expect_faults("99999999999999999999999\nx;\n", {{1, 1, "found 1:"}, {1, 1, "found 1 name"}});
}

TEST(PhcReader, ListsAllNamesWhenTheyAreNotAsManyAsTheUnknowns) {
  expect_faults("2\nx*y - x1;\n i*x - 1;\n",
                {{1, 1,
                  "expected 2 unknowns, found 3 names: x (line 2, column 1), y (line 2, column 3), "
                  "x1 (line 2, column 7)"}});
  expect_faults("2\nx - 1;\nx + 1;\n", {{1, 1, "expected 2 unknowns, found 1 name: x (line 2"}});
  expect_faults("2 3\nx - 1;\ny + 1;\n", {{1, 1, "expected 3 unknowns, found 2 names"}});
}

TEST(PhcReader, RefusesExponentsThatAreNoCounts) {
  expect_faults("1\nx^2.5 - 1;\n", {{2, 3, "the exponent is not an integer"}});
  expect_faults("1\nx^(1/2) - 1;\n", {{2, 4, "the exponent is not an integer"}});
  expect_faults("1\nx^i - 1;\n", {{2, 3, "the exponent is not an integer"}});
  expect_faults("1\nx^x - 1;\n", {{2, 3, "the exponent is not a number"}});
  expect_faults("1\nx^99999999999;\n", {{2, 3, "the exponent 99999999999 is beyond 4294967295"}});
  expect_faults("1\nx^4000000000*x^4000000000;\n", {{2, 14, "an exponent is beyond 4294967295"}});
  expect_faults("1\n(x^70000)^70000;\n", {{2, 11, "an exponent is beyond 4294967295"}});
  EXPECT_EQ(system_of("1\n2^-3*x;\n").polynomials[0], Coefficient(Rational(1, 8), 0) * x);
}

TEST(PhcReader, RefusesDivisionByZero) {
  expect_faults("1\nx/(x-x) - 1;\n", {{2, 2, "division by zero"}});
  expect_faults("1\nx/0 + 0^-1;\n", {{2, 2, "division by zero"}, {2, 7, "division by zero"}});
}

TEST(PhcReader, RefusesUnbalancedParentheses) {
  expect_faults("2\n(x + (y - 1);\nx - y;\n", {{2, 1, "this `(` is never closed"}});
  expect_faults("2\nx + y) - 1;\nx - y;\n", {{2, 6, "this `)` closes nothing"}});
  expect_faults("1\nx + ();\n", {{2, 6, "expected a number, a name or `(`, found `)`"}});
}

TEST(PhcReader, RefusesStrayAndMissingOperators) {
  expect_faults("2\nx^2 ++ *y - 1;\nx - y;\n",
                {{2, 6, "found the operator `+`"}, {2, 8, "found the operator `*`"}});
  expect_faults("2\nx y - 1;\nx - y;\n", {{2, 3, "an operator is missing before `y`"}});
  expect_faults("1\n1/2x - 1;\n", {{2, 4, "an operator is missing before `x`"}});
  expect_faults("1\n2 x - 1;\n", {{2, 3, "an operator is missing before `x`"}});
  expect_faults("1\nx(x - 1);\n", {{2, 1, "an operator is missing behind `x`"}});
  expect_faults("1\nx - ;\n", {{2, 4, "but the expression ends here"}});
  expect_faults("1\nx*/2;\n", {{2, 3, "found the operator `/`"}});
  expect_faults("1\nx***2;\n", {{2, 4, "found the operator `*`"}});
  expect_faults("1\nx^2 = 1 = 1;\n", {{2, 9, "a second `=`"}});
  expect_faults("1\nx^2 = ;\n", {{2, 5, "a side of this `=` is missing"}});
  expect_faults("1\nx^2 ! 1;\n", {{2, 5, "unexpected character: `!`"}});
  expect_faults("1\nx \xE2\x88\x92 1;\n",
                {{2, 3, "unexpected character: `\u2212`; type `-` for it"}});
  expect_faults("1\n;\n",
                {{1, 1, "expected 1 unknown, found 0 names"}, {2, 1, "a polynomial is missing"}});
}

TEST(PhcReader, NamesWhatStandsBehindAFaultOfTheSamePolynomial) {
  expect_faults("2\nx y + x^2.5 - 1e5001 + y/0 + (x;\n2 x - 3 y;\n",
                {{2, 3, "an operator is missing before `y`"},
                 {2, 9, "the exponent is not an integer"},
                 {2, 15, "`1e5001` has more than 5000 digits"},
                 {2, 25, "division by zero"},
                 {2, 30, "this `(` is never closed"},
                 {3, 3, "an operator is missing before `x`"},
                 {3, 9, "an operator is missing before `y`"}});
}

TEST(PhcReader, RefusesFunctionCalls) {
  expect_faults("1\nx - f(x);\n", {{2, 5, "`f(`: function calls are not polynomials"}});
  expect_faults("1\nx - sin(x);\n", {{2, 5, "`sin(` of an unknown is no polynomial"}});
  expect_faults("1\nx - sqrt(-2) - log(0);\n",
                {{2, 5, "`sqrt(` has no real value here"}, {2, 16, "`log(` has no real value"}});
  expect_faults("1\nx - (-8)^(1/3);\n", {{2, 11, "this root has no real value"}});
}

TEST(PhcReader, RefusesNumbersThatAreTooLongOrTooFarApart) {
  expect_faults("1\nx - 1e999999999999999999999;\n",
                {{2, 5, "`1e999999999999999999999` has more than 5000 digits"}});
  expect_faults("1\nx - 1e-5001;\n", {{2, 5, "`1e-5001` has more than 5000 digits"}});
  expect_faults("1\n10^400*10^400*x - 1;\n",
                {{2, 1, "multiplied out, a coefficient is out of the range"}});
  expect_faults("1\n10^999999999*x - 1;\n", {{2, 4, "more than 17000 bits"}});
  EXPECT_EQ(system_of("1\n0e999999999*x + x - 0.000e-9999;\n").polynomials[0], x);
  EXPECT_EQ(system_of("1\n4.9e-324*x - 1.7e308;\n").polynomials[0].terms.size(), 2U);
}

TEST(PhcReader, NamesEveryFaultOfAFile) {
  expect_faults("4\nx^2 + y^2 - 1e5001;\n (x + y;\nx^1.5 - 1/0;\nx y + z + y;\n",
                {{1, 1, "expected 4 unknowns, found 3 names"},
                 {2, 13, "`1e5001`"},
                 {3, 2, "never closed"},
                 {4, 3, "not an integer"},
                 {4, 10, "division by zero"},
                 {5, 3, "an operator is missing"}});
}

TEST(PhcReader, NamesTheFaultsAroundAFaultOfTheGrammarToo) {
  expect_faults("1\nx^2.5 + 1/0 - 1/1e5001 ++ x^.5;\n", {{2, 3, "not an integer"},
                                                         {2, 10, "division by zero"},
                                                         {2, 17, "`1e5001`"},
                                                         {2, 25, "found the operator `+`"},
                                                         {2, 29, "not an integer"}});
}

TEST(PhcReader, RefusesEmptyAndBinaryFiles) {
  expect_faults("", {{1, 1, "the file is empty"}});
  expect_faults(" \n\t\n", {{1, 1, "the file is empty"}});
  expect_faults(std::string("1\nx \0- 1;\n", 10), {{2, 3, "the file is not text"}});
  expect_faults(
      "\x7F"
      "ELF;",
      {{1, 1, "the file is not text: it holds the control character 127"}});
}

TEST(PhcReader, LimitsTheDepthOfParentheses) {
  const auto nested = [](int depth) {
    const auto n = static_cast<std::size_t>(depth);
    return "1\n" + std::string(n, '(') + "x" + std::string(n, ')') + ";\n";
  };
  EXPECT_EQ(system_of(nested(kMaximumDepth)).polynomials[0], x);
  expect_faults(nested(kMaximumDepth + 1), {{2, 257, "more than 256 deep"}});
  expect_faults(nested(1'000'000), {{2, 257, "more than 256 deep"}});
}

TEST(PhcReader, LimitsTheDepthOfPowers) {
  std::string tower = "1\n";
  for (int k = 0; k < 100'000; ++k) tower += "x^";
  expect_faults(tower + "2;\n", {{2, 515, "more than 256 deep"}});
}

TEST(PhcReader, StopsAnExpansionAtAMillionTerms) {
  expect_faults("5 10\n(a+b+c+d+e+f+g+h+k+l)^50;\na;b;c;d;\n",
                {{2, 23, "more than 1000000 terms"}});
}

TEST(PhcReader, RefusesAPowerBeforeItsWorkBegins) {
  expect_faults("2\n(x^2+i*x+1)^66396 - y;\n(x+x^2+2)^4294967295 + y^1.5;\n",
                {{2, 13, "takes more than 50000000 products of terms"},
                 {3, 11, "takes more than 50000000 products of terms"},
                 {3, 26, "not an integer"}});
}

TEST(PhcReader, ShowsAWindowOfALongLine) {
  std::string text = "1\n";
  for (int k = 0; k < 1000; ++k) text += "x+";
  text += "+x;\n";
  try {
    system_of(text);
    FAIL();
  } catch (const ParseError& error) {
    std::string before;
    for (int k = 0; k < 46; ++k) before += "+x";
    EXPECT_EQ(std::string(error.what()),
              "file:2:2001: error: expected a number, a name or `(`, found the operator `+`\n"
              "    ..." +
                  before + "++x;\n" + std::string(100, ' ') + "^\n");
  }
}

TEST(PhcReader, ReadsALineOfAMegabyteWithEveryTerm) {
  std::string text = "1 2\n";
  constexpr int kTerms = 60'000;
  for (int k = 1; k <= kTerms; ++k) {
    text.append("+").append(std::to_string(k)).append("*x^").append(std::to_string(k % 300));
    text.append("*y^").append(std::to_string(k / 300));
  }
  EXPECT_EQ(system_of(text + ";\n").polynomials[0].terms.size(), std::size_t{kTerms});
}

}  // namespace
}  // namespace moivre
