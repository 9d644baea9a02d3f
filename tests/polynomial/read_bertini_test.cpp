// SPDX-License-Identifier: MIT
// Do Bertini's input files give the exact system, and is every kind of fault named with line,
// column and reason?
#include <gtest/gtest.h>

#include "read_support.h"

namespace moivre {
namespace {

const std::string kConics =
    "% two conics\n"
    "CONFIG\n"
    "  TRACKTYPE: 0; % the default\n"
    "END;\n"
    "INPUT\n"
    "  variable_group x;\n"
    "  variable_group y; function f1, f2;\n"
    "  constant r;\n"
    "  r = 5; % radius squared\n"
    "  square = x^2;\n"
    "  f1 = square + y^2 - r;\n"
    "  f2 = x*y - 2*(1 + I)*(1 - I)/2;\n"
    "END;\n"
    "anything; behind\n";

TEST(BertiniReader, ReadsSectionsConstantsAndSubfunctions) {
  EXPECT_EQ(detect_format(kConics), PolynomialFormat::bertini);
  EXPECT_EQ(system_of(kConics), system_of("2\nx^2+y^2-5;\nx*y-2;\n"));
}

TEST(BertiniReader, KeepsTheDeclaredOrderOfVariablesAndFunctions) {
  const System f =
      system_of("variable_group b, a; variable unused; function g, f; f = a; g = b + 1;");
  EXPECT_EQ(f.variables, (std::vector<std::string>{"b", "a", "unused"}));
  EXPECT_EQ(f.polynomials[0], (unknown(0) + constant({1, 0})));
  EXPECT_EQ(f.polynomials[1], unknown(1));
}

TEST(BertiniReader, TakesTheSmallLetterIForAVariable) {
  const System f = system_of("variable_group i; function f; f = i^2 + I;");
  EXPECT_EQ(f.polynomials[0], (unknown(0) * unknown(0) + constant({0, 1})));
}

TEST(BertiniReader, IsToldFromPhcpackByContent) {
  EXPECT_EQ(detect_format("INPUT\nvariable_group x;"), PolynomialFormat::bertini);
  EXPECT_EQ(detect_format("\n% remark; with semicolon\nvariable_group x;"),
            PolynomialFormat::bertini);
  EXPECT_EQ(detect_format("a remark\nCONFIG\nEND;"), PolynomialFormat::bertini);
  EXPECT_EQ(detect_format("1\nx^2-1;\nTITLE : INPUT\nINPUT\n"), PolynomialFormat::phcpack);
  EXPECT_EQ(detect_format("function - 1;"), PolynomialFormat::phcpack);
  EXPECT_EQ(detect_format("INPUT*x - 1;"), PolynomialFormat::phcpack);
  EXPECT_EQ(detect_format("1\nCONFIG;\n"), PolynomialFormat::phcpack);
  EXPECT_EQ(detect_format("x\n-\nINPUT\n+ 1;\n"), PolynomialFormat::phcpack);
  EXPECT_EQ(detect_format(""), PolynomialFormat::phcpack);
}

TEST(BertiniReader, RefusesWhatIsNoPlainSystemWithTheReason) {
  expect_faults("variable x;\npathvariable t;\nparameter s;\nfunction f;\ns = t;\nf = x - s;",
                {{2, 1, "pathvariable: the file describes a homotopy"},
                 {3, 1, "parameter: the file describes a family of systems"}});
  expect_faults("variable_group x;\nfunction f;\nrandom a;\nf = x - a;",
                {{3, 1, "random: a number drawn at random"}});
}

TEST(BertiniReader, TellsTheGroupsInTheirOrder) {
  EXPECT_EQ(system_of(kConics).groups, (std::vector<VariableGroup>{{{0}, false}, {{1}, false}}));
  const System f = system_of(
      "variable u; hom_variable_group x, y;\nvariable_group z, w;\nvariable v;\nfunction f, g;\n"
      "f = (x^2 + 3*x*y)*z - y^2*w*v; g = x*u + y;");
  EXPECT_EQ(f.variables, (std::vector<std::string>{"u", "x", "y", "z", "w", "v"}));
  EXPECT_EQ(f.groups,
            (std::vector<VariableGroup>{{{1, 2}, true}, {{3, 4}, false}, {{0, 5}, false}}));
  EXPECT_TRUE(system_of("variable x, y; function f, g; f = x; g = y;").groups.empty());
  EXPECT_TRUE(system_of("1\nx^2-1;\n").groups.empty());
}

TEST(BertiniReader, WantsFunctionsHomogeneousInAHomogeneousGroup) {
  expect_faults(
      "hom_variable_group x, y;\nvariable_group z;\nfunction f, g;\nsquare = x^2 + 1;\n"
      "f = z*x*y - y*square;\n  g =  (x + y)^2 - z*x + 0*z;\n",
      {{5, 5,
        "`f` is not homogeneous in the hom_variable_group of line 1: it has terms of degree 3 and "
        "of degree 1"},
       {6, 8,
        "`g` is not homogeneous in the hom_variable_group of line 1: it has terms of degree 2 and "
        "of degree 1"}});
  expect_faults("hom_variable_group x;\nfunction f;\nf = x;",
                {{1, 1, "one homogeneous coordinate has only one point, `x` = 1"}});
}

TEST(BertiniReader, RefusesGroupsWithNamesThatAreTakenOrMissing) {
  expect_faults("variable_group x, y;\nhom_variable_group z, y;\nfunction f;\nf = x*z;",
                {{2, 23, "`y` is declared already, at line 1"}});
  expect_faults("function f;\nvariable_group x, f;\nf = x;",
                {{2, 19, "`f` is declared already, at line 1"}});
  expect_faults("hom_variable_group x, 2y;\nfunction f;\nf = x;",
                {{1, 23, "2y: this is not a name"}});
  expect_faults("variable_group x;\nvariable_group y;\nfunction f;\nf = x*y - z;",
                {{4, 11, "the name `z` is not declared"}});
}

TEST(BertiniReader, RefusesNamesBeforeTheyAreAssigned) {
  expect_faults("variable_group x;\nfunction f;\nf = x - a;\na = 2;",
                {{3, 9, "the name `a` is not declared"}});
}

TEST(BertiniReader, NamesEachFaultOnceAndNotItsConsequences) {
  expect_faults("variable_group x;\nfunction f, g;\na = 1/0;\nf = a + x;\ng = a*x^2.5;",
                {{3, 6, "division by zero"}, {5, 9, "the exponent is not an integer"}});
}

TEST(BertiniReader, RefusesDeclarationsThatCannotBe) {
  expect_faults("variable_group x, x;\nfunction f;\nf = x;",
                {{1, 19, "`x` is declared already, at line 1"}});
  expect_faults("variable_group x, I;\nfunction f;\nf = x;",
                {{1, 19, "`I` is the imaginary unit"}});
  expect_faults("variable_group x y;\nfunction f;\nf = 1;",
                {{1, 1, "no variable is declared"}, {1, 16, "x y: this is not a name"}});
  expect_faults("variable_group x,;\nfunction f;\nf = x;", {{1, 18, "a name is missing here"}});
}

TEST(BertiniReader, RefusesAssignmentsThatCannotBe) {
  expect_faults("variable_group x;\nfunction f;\nx = 1;\nf = x;\nf = 2;\nI = 3;",
                {{3, 1, "`x` is a variable"},
                 {5, 1, "`f` is assigned already"},
                 {6, 1, "`I` is the imaginary unit"}});
  expect_faults("variable_group x;\nconstant c;\nfunction f;\nc = x + 1;\nf = c;",
                {{4, 5, "the constant `c` holds a variable"}});
  expect_faults("variable_group x;\nconstant c;\nfunction f, g;\nf = x;",
                {{2, 10, "`c` is declared, but nothing is assigned"},
                 {3, 13, "`g` is declared, but nothing is assigned"}});
  expect_faults("variable_group x;\nfunction f;\nf = x;\nwhatever;",
                {{4, 1, "expected a declaration or `name = expression`, found: whatever"}});
}

TEST(BertiniReader, NamesALostSemicolon) {
  expect_faults(
      "variable_group x, y;\nfunction f, g;\nf = x\ng = y;\n",
      {{2, 13, "`g` is declared, but nothing is assigned"},
       {4, 1, "an operator is missing before `g`; or is a `;` missing at the end of line 3?"}});
  expect_faults("variable_group x;\nfunction f;\nf = x\n",
                {{3, 1, "this statement has no `;` behind it"}});
}

TEST(BertiniReader, RefusesSectionsThatAreNotClosed) {
  expect_faults("INPUT\nvariable_group x;\nfunction f;\nf = x;\n",
                {{1, 1, "INPUT is not closed by `END;`"}});
  expect_faults(
      "CONFIG\nTRACKTYPE: 0;\n",
      {{1, 1, "CONFIG is not closed by `END;`"}, {1, 1, "no variable"}, {1, 1, "no function"}});
}

TEST(BertiniReader, GoesOnAtInputBehindAConfigThatIsNotClosed) {
  expect_faults(
      "CONFIG\nTRACKTYPE: 0;\nEND\n INPUT\nvariable_group x;\nfunction f;\nf = x^y;\nEND;\n",
      {{1, 1, "CONFIG is not closed by `END;`"}, {7, 7, "the name `y` is not declared"}});
  expect_faults(
      "CONFIG\nINPUTS: 0;\n% INPUT\nEND\nINPUT\nvariable_group x;\nfunction f;\nf = x;\n",
      {{1, 1, "CONFIG is not closed by `END;`"}, {5, 1, "INPUT is not closed by `END;`"}});
}

TEST(BertiniReader, ShowsTheLineWithItsComment) {
  const std::string text = "variable_group x;\nfunction f;\nf = x ++ 1; % stray\n";
  try {
    system_of(text);
    FAIL();
  } catch (const ParseError& error) {
    EXPECT_STREQ(error.what(),
                 "file:3:8: error: expected a number, a name or `(`, found the operator `+`\n"
                 "    f = x ++ 1; % stray\n"
                 "           ^\n");
  }
}

}  // namespace
}  // namespace moivre
