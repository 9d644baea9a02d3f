// SPDX-License-Identifier: MIT
// Are recurrences found, and roots that coincide told?
#include "modular_line.h"

#include <gtest/gtest.h>

namespace moivre::test {
namespace {

TEST(ModularLine, TheShortestRecurrenceOfFibonaccisNumbersIsFound) {
  const std::vector<Residue> fibonacci{0, 1, 1, 2, 3, 5, 8, 13};
  EXPECT_EQ(minimal_polynomial(fibonacci), (Line{kPrime - 1, kPrime - 1, 1}));
}

TEST(ModularLine, ASequenceOfZerosObeysTheConstantOne) {
  EXPECT_EQ(minimal_polynomial({0, 0, 0, 0}), Line{1});
}

TEST(ModularLine, ASequenceThatEndsInZerosObeysAPowerOfTheShift) {
  EXPECT_EQ(minimal_polynomial({7, 1, 0, 0, 0, 0}), (Line{0, 0, 1}));
}

TEST(ModularLine, RootsThatCoincideAreOne) {
  EXPECT_EQ(distinct_roots({4, kPrime - 4, 1}), 1U);  // (x - 2)^2
  EXPECT_EQ(distinct_roots({3, kPrime - 4, 1}), 2U);  // (x - 1)(x - 3)
  EXPECT_EQ(distinct_roots({1, 0, 2, 0, 1}), 2U);     // (x^2 + 1)^2
  EXPECT_EQ(distinct_roots({0, 0, 0, 1}), 1U);        // x^3
  EXPECT_EQ(distinct_roots({5}), 0U);
}

TEST(ModularLine, ANumberTimesItsInverseIsOne) {
  for (const Residue a : {Residue{1}, Residue{2}, kPrime - 1, kPrime / 2, Residue{1} << 60}) {
    EXPECT_EQ(times(a, inverse(a)), 1U);
    EXPECT_EQ(plus(a, minus(a)), 0U);
  }
  EXPECT_EQ(times(kPrime - 1, kPrime - 1), 1U);
}

}  // namespace
}  // namespace moivre::test
