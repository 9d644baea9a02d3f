// SPDX-License-Identifier: MIT
// Do sparse polynomials keep their canonical form?
// And are degrees and counts what the definition says?
#include "moivre/polynomial/system.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace moivre {
namespace {

const Polynomial x = unknown(0);
const Polynomial y = unknown(1);
const Polynomial one = constant({1, 0});

TEST(Monomial, ComesGradedFirstAndLexicographicThen) {
  const Monomial x2{{0, 2}};
  const Monomial xy{{0, 1}, {1, 1}};
  const Monomial y2{{1, 2}};
  const Monomial x1{{0, 1}};
  EXPECT_TRUE(precedes(x2, xy));
  EXPECT_TRUE(precedes(xy, y2));
  EXPECT_TRUE(precedes(y2, x1));
  EXPECT_TRUE(precedes(x1, {}));
  EXPECT_FALSE(precedes(xy, xy));
}

TEST(Monomial, MultipliesByAddingExponents) {
  EXPECT_EQ(product({{0, 2}, {3, 1}}, {{1, 1}, {3, 4}}), (Monomial{{0, 2}, {1, 1}, {3, 5}}));
  EXPECT_EQ(degree(product({{0, 2}}, {{1, 5}})), 7U);
}

TEST(Monomial, RefusesAnExponentBeyond32Bits) {
  const Monomial huge{{0, std::numeric_limits<std::uint32_t>::max()}};
  EXPECT_THROW(product(huge, {{0, 1}}), std::overflow_error);
}

TEST(Polynomial, DropsTermsThatCancel) {
  const Polynomial difference = x + Coefficient{-1, 0} * x;
  EXPECT_TRUE(difference.terms.empty());
  EXPECT_EQ((x + y) * (x + Coefficient{-1, 0} * y), (x * x + Coefficient{-1, 0} * (y * y)));
}

TEST(Polynomial, SumAndProductObeyTheRing) {
  const Polynomial p = x * x + Coefficient{Rational(1, 3), 2} * y + one;
  const Polynomial q = y * x + Coefficient{0, -1} * one;
  EXPECT_EQ(p * (q + x), p * q + p * x);
  EXPECT_EQ(p * q, q * p);
  EXPECT_EQ(p + q, q + p);
}

TEST(Polynomial, KnowsDegreeRealityAndHomogeneity) {
  EXPECT_EQ(degree(Polynomial{}), 0U);
  EXPECT_EQ(degree(x * x * y + one), 3U);
  EXPECT_TRUE(is_homogeneous(x * x + x * y));
  EXPECT_FALSE(is_homogeneous(x * x + y));
  EXPECT_TRUE(is_homogeneous(Polynomial{}));
  EXPECT_TRUE(is_real(x + y));
  EXPECT_FALSE(is_real(Coefficient{0, 1} * x));
}

TEST(System, CountsTermsAndPaths) {
  const System f{{"x", "y"}, {x * x + y, x * y + one}};
  EXPECT_EQ(degrees(f), (std::vector<std::uint64_t>{2, 2}));
  EXPECT_EQ(total_degree(degrees(f)), 4U);
  EXPECT_EQ(term_count(f), 4U);
  EXPECT_TRUE(is_real(f));
}

TEST(System, SaysThatTheBezoutNumberLeaves64Bits) {
  EXPECT_EQ(total_degree(std::vector<std::uint64_t>(63, 2)), std::uint64_t{1} << 63U);
  EXPECT_EQ(total_degree(std::vector<std::uint64_t>(64, 2)), std::nullopt);
  EXPECT_EQ(total_degree({0, std::numeric_limits<std::uint64_t>::max(), 7}), 0U);
}

}  // namespace
}  // namespace moivre
