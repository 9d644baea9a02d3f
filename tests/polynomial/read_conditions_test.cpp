// SPDX-License-Identifier: MIT
// Are inequalities among the equations read as conditions, and refused where they cannot be meant?
#include "build.h"
#include "moivre/polynomial/read.h"
#include "read_support.h"

namespace moivre {
namespace {

const auto [x, y] = unknowns<2>();

TEST(Conditions, StandAmongTheEquationsAndAreNone) {
  const System f = system_of("x^2 + y^2 = 4\nx > 0   # the right half\nx*y = 1\nx + y <= 3\n");
  EXPECT_EQ(f, system_of("x^2 + y^2 = 4;\nx*y = 1;\n"));
  ASSERT_EQ(f.conditions.size(), 2U);
  EXPECT_EQ(f.conditions[0].p, x);
  EXPECT_TRUE(f.conditions[0].is_strict);
  EXPECT_EQ(f.conditions[0].text, "x > 0");
  EXPECT_EQ(f.conditions[1].p, 3 - x - y);
  EXPECT_FALSE(f.conditions[1].is_strict);
  EXPECT_EQ(f.conditions[1].text, "x + y <= 3");
}

TEST(Conditions, OfAChainAreOneForEachSign) {
  const System f = system_of("x^2 - y; y - 2;\n0 < x*y\n <= 2^(1/2)*2^(1/2);");
  ASSERT_EQ(f.conditions.size(), 2U);
  EXPECT_EQ(f.conditions[0].p, x * y);
  EXPECT_EQ(f.conditions[0].text, "0 < x*y");
  EXPECT_FALSE(f.conditions[1].is_strict);
  EXPECT_EQ(f.conditions[1].text, "x*y <= 2^(1/2)*2^(1/2)");
}

TEST(Conditions, AreNotCountedByTheCountLine) {
  EXPECT_EQ(system_of("2\nx^2 - 1;\nx > 0;\nx*y - 1;\n").conditions.size(), 1U);
  expect_faults("3\nx^2 - 1;\nx > 0;\nx*y - 1;\n",
                {{1, 1, "expected 3 polynomials, found 2"}, {1, 1, "expected 3 unknowns"}});
}

TEST(Conditions, WithoutTheirSemicolonAreNotPassedOver) {
  expect_faults("1\nx^2 - 1;\nx > 0\n", {{3, 1, "this condition has no `;` behind it"}});
  expect_faults("x^2 - 1;\nx > 0\nTITLE : t\n", {{2, 1, "this condition has no `;` behind it"}});
  EXPECT_TRUE(system_of("x^2 - 1;\nthe roots are < 2 and real\n").conditions.empty());
}

TEST(Conditions, AreRefusedWhereTheyCannotBeMeant) {
  expect_faults("x^2 - 1; z > 0;", {{1, 10, "`z` occurs in this condition and in no equation"}});
  expect_faults("x^2 - 1; i*x > 0;", {{1, 10, "a condition has real coefficients"}});
  expect_faults("x^2 - 1; 1/x > 2;", {{1, 10, "a condition does not divide by unknowns"}});
  expect_faults("x^2 - 1; x > ;", {{1, 12, "a side of this `>` is missing"}});
  expect_faults("x^2 - 1; > 0;", {{1, 10, "a side of this `>` is missing"}});
  expect_faults("x^2 - 1; x => 0;", {{1, 13, "`=>` is no sign; type `>=`"}});
  expect_faults("x^2 - 1; x =< 0;", {{1, 13, "`=<` is no sign; type `<=`"}});
  expect_faults("x^2 - 1; x + > 0;", {{1, 14, ""}});
  expect_faults("x > 0;",
                {{1, 1, "`x` occurs in this condition"}, {1, 7, "the file has conditions alone"}});
  expect_faults("x^2 - 1; z > 1 + ; x^z > 1;", {{1, 10, "`z` occurs in this condition"},
                                                {1, 17, "expected a number"},
                                                {1, 22, "`z` occurs in this condition"},
                                                {1, 22, "the exponent is not a number"}});
  expect_faults("x^2 - 1; x \u2264 2;", {{1, 12, "type `<=` for it"}});
  expect_faults("x^2 = 1\nx \u2264 2\n", {{2, 3, "type `<=` for it"}});
  expect_faults("x^2 = 1\nx \u2260 1\n", {{2, 3, "conditions have `<`"}});
  expect_faults("x^2 - 1;\nx \u2264 2\n", {{2, 1, "this condition has no `;` behind it"}});
}

TEST(Conditions, LeaveNoDenominatorInTheSystem) {
  const System f = system_of("x/(y - 1) = 2; x*y = 3; x/2 > y;");
  EXPECT_EQ(f.denominators.size(), 1U);
  EXPECT_EQ(f.conditions[0].p, x / 2 - y);
}

TEST(Conditions, AreTypedBesideASystemInItsUnknowns) {
  const std::vector<Condition> read =
      read_conditions({"--where", "y > 1; 0 < x <= pi"}, {"x", "y"});
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[0].p, y - 1);
  EXPECT_EQ(read[1].p, x);
  for (const char* wrong : {"z > 0", "x", "x = 1", "x >", "x > 1; y", "x/y > 1"}) {
    EXPECT_THROW(read_conditions({"--where", wrong}, {"x", "y"}), ParseError) << wrong;
  }
}

TEST(Conditions, PutTogetherInCodeKeepTheRulesOfReaders) {
  System f = make_system({"x"}, {x * x - 1});
  f.conditions = {{y, true, "y > 0"}};
  EXPECT_FALSE(broken_rules(f).empty());
  f.conditions = {{Coefficient(0, 1) * x, true, "i*x > 0"}};
  EXPECT_FALSE(broken_rules(f).empty());
  f.conditions = {{x - 1, false, "x >= 1"}};
  EXPECT_TRUE(broken_rules(f).empty());
}

}  // namespace
}  // namespace moivre
