// SPDX-License-Identifier: MIT
// Are roots given the digits that were asked for, and is what cannot have them refused by the
// library itself?
#include "moivre/solver/digits.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <string>

#include "moivre/tracker_cvode/cvode_tracker.h"
#include "problem_set.h"

namespace moivre {
namespace {

using test::read;

const std::atomic<bool> kGoOn{false};

TEST(Digits, AreThoseOfTheRoot) {
  const System f = read("1\n x^2 - 2;\n");
  SolveResult result = solve(f, *make_cvode_tracker());
  give_digits(f, 30, result, kGoOn);
  ASSERT_EQ(result.solutions.size(), 2U);
  for (const Solution& root : result.solutions) {
    const std::string sign = root.x[0].real() < 0 ? "-" : "";
    EXPECT_EQ(root.x_digits[0].re, sign + "1.41421356237309504880168872421");
  }
}

TEST(Digits, AreRefusedOutOfRange) {
  const System f = read("1\n x^2 - 2;\n");
  SolveResult result = solve(f, *make_cvode_tracker());
  for (const int digits : {0, -3, 1001}) {
    EXPECT_THROW(give_digits(f, digits, result, kGoOn), std::invalid_argument);
  }
  EXPECT_FALSE(result.digits.has_value());
}

TEST(Digits, AreRefusedWhereEquationsAreMoreThanUnknowns) {
  const System f = read("2 1\n x^2 - 1;\n x - 1;\n");
  SolveResult result = solve(f, *make_cvode_tracker());
  EXPECT_THROW(give_digits(f, 30, result, kGoOn), std::invalid_argument);
}

/// Newton's method begins at the proofs' midpoints: at 70 itself it knows no way. Of the last three
/// seeds a midpoint has an imaginary part that is less than its digits beyond double.
TEST(Digits, PartRootsThatAreOneInDouble) {
  const System f = read("1\n u^2 - 140*u + 4900 - 7e-36;\n");
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U, 36U, 103U}) {
    SolveOptions options;
    options.seed = seed;
    SolveResult result = solve(f, *make_cvode_tracker(), options);
    const int digits = digits_that_part(f, result);
    EXPECT_GE(digits, 20);
    EXPECT_LE(digits, 25);
    give_digits(f, digits, result, kGoOn);
    ASSERT_EQ(result.solutions.size(), 2U);
    std::set<std::string> texts;
    for (const Solution& root : result.solutions) {
      ASSERT_EQ(root.x_digits.size(), 1U);
      texts.insert(root.x_digits[0].re.substr(0, 22));
    }
    EXPECT_EQ(texts, (std::set<std::string>{"69.9999999999999999973", "70.0000000000000000026"}));
  }
}

TEST(Digits, AreNotAskedForWhereDoublePartsAllRoots) {
  const System f = read("1\n x^2 - 2;\n");
  EXPECT_EQ(digits_that_part(f, solve(f, *make_cvode_tracker())), 0);
}

}  // namespace
}  // namespace moivre
