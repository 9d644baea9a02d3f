// SPDX-License-Identifier: MIT
// Is a number that was rounded told from one that is meant as it stands, and by how much may it be
// off?
#include "moivre/polynomial/digits.h"

#include <gtest/gtest.h>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

double relative_error(const std::string& c) {
  const CoefficientErrors errors = coefficient_errors(read_system({"test", "1\n " + c + "*x;\n"}));
  return errors.empty() ? 0 : bound(errors.at(0).at(0));
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

TEST(Digits, EachCoefficientIsKnownAsWellAsItsOwnDigits) {
  const System f = read_system({"test", "1\n 0.5*x^2 + 0.3525981368114*x + 0.352598136811;\n"});
  const CoefficientErrors errors = coefficient_errors(f);
  ASSERT_EQ(errors.size(), 1);
  EXPECT_TRUE(errors[0][0].empty());
  EXPECT_NEAR(bound(errors[0][1]) / (0.5e-13 / 0.3525981368114), 1, 1e-9);
  EXPECT_NEAR(bound(errors[0][2]) / (0.5e-12 / 0.352598136811), 1, 1e-9);
}

TEST(Digits, BesideRoundedNumbersShorterOnesHaveLostTheirLastZeros) {
  const CoefficientErrors errors = coefficient_errors(
      read_system({"test", "1\n 0.29463726*x^3 + 1.08561*x^2 - 2.21583*x + 0.8110958214;\n"}));
  ASSERT_EQ(errors.size(), 1);
  EXPECT_NEAR(bound(errors[0][0]) / (0.5e-9 / 0.29463726), 1, 1e-9);
  EXPECT_TRUE(errors[0][1].empty());
  EXPECT_TRUE(errors[0][2].empty());
  EXPECT_EQ(relative_error("0.29463726"), 0);
}

TEST(Digits, WhatWasComputedFromDoublesIsKnownNoBetterHoweverManyBitsItHas) {
  const Rational cosine(0.8253356149096783);
  for (const Rational& c : {cosine, cosine * cosine, Rational(31, 100) * cosine * cosine}) {
    const System f{{"x"}, {{{{{c, 0}, {{0, 1}}}}}}};
    const CoefficientErrors errors = coefficient_errors(f);
    ASSERT_EQ(errors.size(), 1);
    EXPECT_NEAR(bound(errors[0][0]) * 0x1p49, 1, 1e-9);
  }
}

}  // namespace
}  // namespace moivre
