// SPDX-License-Identifier: MIT
// Do printed numbers claim what is known, no more and no less?
#include "moivre/report/number_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace moivre::test {
namespace {

TEST(KnownDigits, EndAtTheErrorsPlace) {
  EXPECT_EQ(known_digits(1.0 / 3, 1e-4), "0.3333");
  EXPECT_EQ(known_digits(1000.0 / 3, 1e-4), "333.3333");
  EXPECT_EQ(known_digits(1.0 / 3, 3e-4), "0.333");
  EXPECT_EQ(known_digits(1e-6 / 3, 1e-8), "3.3e-07");
}

TEST(KnownDigits, AreAllOfThemWhereThereIsNoError) {
  EXPECT_EQ(std::stod(known_digits(0.1, 0)), 0.1);
  EXPECT_EQ(std::stod(known_digits(1.0 / 3, 0)), 1.0 / 3);
}

TEST(KnownDigits, SayZeroWhereNothingIsKnown) {
  EXPECT_EQ(known_digits(1e-9, 1e-8), "0");
  EXPECT_EQ(known_digits(0, 0), "0");
}

TEST(KnownDigits, SayUnknownForWhatIsNotANumber) {
  EXPECT_EQ(known_digits(std::numeric_limits<double>::quiet_NaN(), 1e-8), "unknown");
  EXPECT_EQ(known_digits(1, std::numeric_limits<double>::infinity()), "unknown");
}

TEST(KnownDigits, LeaveOutAnImaginaryPartThatIsNotThere) {
  EXPECT_EQ(known_digits(Complex(1, 1e-12), 1e-8), "1");
  EXPECT_EQ(known_digits(Complex(1, -0.5), 1e-8), "1 - 0.5 i");
}

TEST(Numbers, AreWrittenAsPrintfWritesThem) {
  std::mt19937_64 random(7);
  for (int k = 0; k < 2000; ++k) {
    const double x = std::bit_cast<double>(random());
    const double y = k % 7 == 0 ? 0.0 : std::ldexp(static_cast<double>(random() % 1000), k % 60);
    if (!std::isfinite(x)) continue;
    char text[128];
    std::snprintf(text, sizeof text, "%.*g", 1 + k % 17, x);
    EXPECT_EQ(short_text(x, 1 + k % 17), text);
    std::snprintf(text, sizeof text, "% .16E  % .16E", y, x);
    EXPECT_EQ(phc_text({y, x}), text);
  }
}

TEST(ExactText, ReadsBackAsTheSameDouble) {
  for (const double x : {0.1, 1.0 / 3, -1e300, 5e-324, 123456789.0}) {
    EXPECT_EQ(std::strtod(exact_text(x).c_str(), nullptr), x);
  }
}

}  // namespace
}  // namespace moivre::test
