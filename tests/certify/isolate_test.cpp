// SPDX-License-Identifier: MIT
// Are all roots of one unknown told apart, however near they are, and multiple ones with their
// multiplicities?
#include "moivre/certify/isolate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

std::optional<std::vector<IsolatedRoot>> roots_of(const std::string& p, int bits = 256) {
  const auto isolated =
      isolated_roots(read_system({"test", "1\n" + p + ";\n"}).polynomials.front(), bits);
  return isolated ? std::optional(isolated->roots) : std::nullopt;
}

std::vector<std::uint64_t> multiplicities(const std::vector<IsolatedRoot>& roots) {
  std::vector<std::uint64_t> result;
  for (const IsolatedRoot& root : roots) result.push_back(root.multiplicity);
  std::sort(result.begin(), result.end());
  return result;
}

// Two roots near 1/3 are some 3^-61 apart.
TEST(IsolatedRoots, OfAMignottePolynomialAreAllSimple) {
  const auto roots = roots_of("x^120 - (3*x - 1)^2");
  ASSERT_TRUE(roots);
  EXPECT_EQ(roots->size(), 120U);
  EXPECT_EQ(multiplicities(*roots), std::vector<std::uint64_t>(120, 1));
  const auto near = std::count_if(roots->begin(), roots->end(), [](const IsolatedRoot& root) {
    return std::abs(root.parts.front() - 1.0 / 3) < 1e-15 && root.radius < 1e-28;
  });
  EXPECT_EQ(near, 2);
}

TEST(IsolatedRoots, HaveTheMultiplicitiesOfSquarefreeFactors) {
  const auto roots = roots_of("(x^2 - 2)^3*(x - 5)^2*(x^3 + x + 1)");
  ASSERT_TRUE(roots);
  EXPECT_EQ(multiplicities(*roots), (std::vector<std::uint64_t>{1, 1, 1, 2, 3, 3}));
}

// 70 +- 2.6e-23.
TEST(IsolatedRoots, AreSumsOfDoublesWhereOneDoubleDoesNotTellThemApart) {
  const auto roots = roots_of("x^2 - 140*x + 4900 - 7e-46");
  ASSERT_TRUE(roots);
  ASSERT_EQ(roots->size(), 2U);
  for (const IsolatedRoot& root : *roots) {
    EXPECT_EQ(root.parts.front(), 70.0);
    EXPECT_NEAR(std::abs(root.parts.at(1)), 2.6457513110645906e-23, 1e-37);
    EXPECT_LT(root.error, root.radius);
  }
}

TEST(IsolatedRoots, AreNotToldOfComplexCoefficients) {
  EXPECT_TRUE(roots_of("x^2 - 140*x + 4900 - 7e-200"));
  EXPECT_FALSE(roots_of("x^2 - i*x + 1"));
}

// The simple roots of a factor of degree 260 are counted, the multiple ones isolated.
TEST(IsolatedRoots, OfADegreeThatNoMemoryHoldsAreNotTold) {
  Polynomial p = pow(unknown(0), 2) - 1;
  p.terms[0].monomial = {{0, 4'294'967'295U}};
  EXPECT_FALSE(isolated_roots(p, 64).has_value());
}

TEST(IsolatedRoots, OfLargeFactorsAreCounted) {
  const auto isolated = isolated_roots(
      read_system({"test", "1\n(x^3 - x - 1)^2*(x^260 - 3);\n"}).polynomials.front(), 256);
  ASSERT_TRUE(isolated);
  EXPECT_EQ(isolated->other_simple, 260U);
  EXPECT_EQ(multiplicities(isolated->roots), (std::vector<std::uint64_t>{2, 2, 2}));
}

}  // namespace
}  // namespace moivre::test
