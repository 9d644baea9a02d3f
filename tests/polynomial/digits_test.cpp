// SPDX-License-Identifier: MIT
// Is a number that was rounded told from one that is meant as it stands, and by how much may it be off?
#include "moivre/polynomial/digits.h"

#include <gtest/gtest.h>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

double relative_error(const std::string& c) {
  return coefficient_error(read_system({"test", "1\n " + c + "*x;\n"}));
}

Coefficient real(const std::string& c) {
  return read_system({"test", "1\n " + c + "*x;\n"}).polynomials[0].terms[0].coefficient;
}

TEST(Digits, ShortDecimalsFractionsAndWholeNumbersAreMeantAsTheyStand) {
  for (const char* c : {"3.1", "1/3", "0.123456789", "12345678901234567890", "1e-30", "7"}) {
    EXPECT_EQ(relative_error(c), 0) << c;
  }
}

TEST(Digits, ALongDecimalIsKnownToHalfAUnitOfItsLastDigit) {
  EXPECT_NEAR(relative_error("0.352598136811") / (0.5e-12 / 0.352598136811), 1, 1e-9);
  EXPECT_NEAR(relative_error("-123.4567890123") / (0.5e-10 / 123.4567890123), 1, 1e-9);
}

TEST(Digits, WhatWasComputedInDoubleIsNotKnownBetter) {
  EXPECT_NEAR(relative_error("0.1234567890123456") * 0x1p49, 1, 1e-9);
  EXPECT_NEAR(relative_error("0.12345678901234567") * 0x1p49, 1, 1e-9);
  EXPECT_LT(relative_error("0.123456789012345678901234567890"), 1e-28);
}

TEST(Digits, AFileIsKnownAsWellAsItsWorstCoefficient) {
  const System f = read_system({"test", "1\n 0.5*x^2 + 0.3525981368114*x + 0.352598136811;\n"});
  EXPECT_NEAR(coefficient_error(f) / (0.5e-12 / 0.352598136811), 1, 1e-9);
}

TEST(Digits, WhatIsComputedFromLongNumbersIsLong) {
  const Coefficient c = real("0.352598136811");
  EXPECT_TRUE(is_computed(c));
  EXPECT_TRUE(is_computed(c * real("1/3")));
  EXPECT_TRUE(is_computed(c * Coefficient{Rational(0x1p-30), 0}));
  for (const char* plain : {"1/3", "3.1", "-2", "1e-9", "1267650600228229401496703205376"}) {
    EXPECT_FALSE(is_computed(real(plain))) << plain;
  }
}

}  // namespace
}  // namespace moivre
