// SPDX-License-Identifier: MIT
// sqrt(2) and pi are known to 40 digits: do roots that the digits behind them decide stay in doubt,
// and are the others proved as before?
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "moivre/polynomial/read.h"
#include "moivre/solver/digits.h"
#include "problem_set.h"

namespace moivre::test {
namespace {

SolveResult solved_text(const std::string& text) {
  return solve_with_cvode(read_system({"test", text}));
}

TEST(NumbersOfFortyDigits, LeaveInDoubtWhatTheDigitsBehindThemDecide) {
  for (const char* text :
       {"sqrt(2)*x + y = 1\n2*x + sqrt(2)*y = 3\n",        // they contradict each other
        "sqrt(2)*x + y = 1\n2*x + sqrt(2)*y = sqrt(2)\n",  // one is the other
        "x^2 + y^2 = 1\nx + y = sqrt(2)\n",                // it touches
        "x^2 - 2*sqrt(2)*x + 2 = 0\n", "x^3 - 3*2^(1/3)*x^2 + 3*2^(2/3)*x = 2\n",
        "sin(pi)*x^2 + x = 1\n", "(sqrt(8) - 2*sqrt(2))*x^2 + x = 1\n"}) {
    SCOPED_TRACE(text);
    const SolveResult result = solved_text(text);
    EXPECT_FALSE(result.complete);
    EXPECT_EQ(result.completeness, RootCompleteness::open);
    EXPECT_TRUE(std::any_of(result.solutions.begin(), result.solutions.end(),
                            [](const Solution& root) { return root.certified == false; }));
    EXPECT_NE(result.message.find("sqrt(2), pi"), std::string::npos) << result.message;
  }
}

TEST(NumbersOfFortyDigits, DecideNothingWhereRootsStandAlone) {
  for (const char* text :
       {"x/(y - 1) = 2\nx^2 + y^2 = sqrt(2)\n", "x^2 + y^2 = sqrt(5)\nx*y = cos(0.3)\n",
        "x^2 + sqrt(3)*x - pi = 0\n", "x = sqrt(2)*sqrt(2) - 2\n"}) {
    SCOPED_TRACE(text);
    const SolveResult result = solved_text(text);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.completeness, RootCompleteness::proved);
    for (const Solution& root : result.solutions) EXPECT_EQ(root.certified, true);
  }
}

TEST(NumbersOfFortyDigits, MakeAPowerNoLessThanOne) {
  const SolveResult result = solved_text("(x - sqrt(2))^2*(x - 3) = 0\n");
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.solutions.size(), 2U);
  EXPECT_EQ(sum_of_multiplicities(result), 3U);
}

TEST(NumbersOfFortyDigits, GiveRootsThirtyDigits) {
  const System f = read_system({"test", "x = pi\n"});
  SolveResult result = solve_with_cvode(f);
  give_digits(f, 120, result, std::atomic<bool>{false});
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_EQ(result.digits, 30);
  EXPECT_EQ(result.solutions.front().x_digits[0].re, "3.14159265358979323846264338328");
  EXPECT_EQ(result.left_out.back().what, "digits behind the 30th");
}

}  // namespace
}  // namespace moivre::test
