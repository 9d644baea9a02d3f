// SPDX-License-Identifier: MIT
// Is a number that was rounded told from one that is meant as it stands, and by how much may it be off?
#include "moivre/polynomial/digits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "moivre/polynomial/read.h"
#include "moivre/polynomial/scale.h"

namespace moivre {
namespace {

/// |c' - c| of the only coefficient of c * x, relative; 0 where there is no other reading.
double relative_error(const std::string& c) {
  const System f = read_system({"test", "1\n " + c + "*x;\n"});
  const auto other = other_reading(f, 1);
  if (!other) return 0;
  EXPECT_TRUE(has_terms_of(f, *other));
  const System difference = differences(*other, f);
  const Coefficient& error = difference.polynomials[0].terms[0].coefficient;
  return std::exp2(log2_size(error) - log2_size(f.polynomials[0].terms[0].coefficient));
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

TEST(Digits, PartsOfAComplexNumberCountEachForItself) {
  const System f = read_system({"test", "1\n (0.5 + 0.3525981368114*i)*x;\n"});
  const Coefficient error =
      differences(other_reading(f, 1).value(), f).polynomials[0].terms[0].coefficient;
  EXPECT_TRUE(error.re.is_zero());
  EXPECT_FALSE(error.im.is_zero());
}

TEST(Digits, SignsAreRandomAndAFunctionOfTheSeed) {
  std::string text = "1\n 0.1111111111111*x";
  for (int k = 2; k < 40; ++k) text += " + 0.1111111111111*x^" + std::to_string(k);
  const System f = read_system({"test", text + ";\n"});
  const System a = *other_reading(f, 1);
  EXPECT_EQ(a.polynomials, other_reading(f, 1)->polynomials);
  EXPECT_NE(a.polynomials, other_reading(f, 2)->polynomials);
}

}  // namespace
}  // namespace moivre
