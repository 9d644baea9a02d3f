// SPDX-License-Identifier: MIT
// Are recurrences found, and roots that coincide told?
#include "moivre/polynomial/modular_line.h"

#include <gtest/gtest.h>

namespace moivre::test {
namespace {

constexpr PrimeField kField;
constexpr Residue kPrime = kField.prime();

TEST(ModularLine, TheShortestRecurrenceOfFibonaccisNumbersIsFound) {
  const std::vector<Residue> fibonacci{0, 1, 1, 2, 3, 5, 8, 13};
  EXPECT_EQ(minimal_polynomial(kField, fibonacci), (Line{kPrime - 1, kPrime - 1, 1}));
}

TEST(ModularLine, ASequenceOfZerosObeysTheConstantOne) {
  EXPECT_EQ(minimal_polynomial(kField, {0, 0, 0, 0}), Line{1});
}

TEST(ModularLine, ASequenceThatEndsInZerosObeysAPowerOfTheShift) {
  EXPECT_EQ(minimal_polynomial(kField, {7, 1, 0, 0, 0, 0}), (Line{0, 0, 1}));
}

TEST(ModularLine, RootsThatCoincideAreOne) {
  EXPECT_EQ(distinct_roots(kField, {4, kPrime - 4, 1}), 1U);  // (x - 2)^2
  EXPECT_EQ(distinct_roots(kField, {3, kPrime - 4, 1}), 2U);  // (x - 1)(x - 3)
  EXPECT_EQ(distinct_roots(kField, {1, 0, 2, 0, 1}), 2U);     // (x^2 + 1)^2
  EXPECT_EQ(distinct_roots(kField, {0, 0, 0, 1}), 1U);        // x^3
  EXPECT_EQ(distinct_roots(kField, {5}), 0U);
}

}  // namespace
}  // namespace moivre::test
