// SPDX-License-Identifier: MIT
// Is Gaussian rational arithmetic exact, and is to_double the nearest double, ties to even?
#include "moivre/numeric/rational.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

using Double = std::numeric_limits<double>;

Rational power_of_two(int e) {
  const Integer p = Integer(1) << static_cast<unsigned>(std::abs(e));
  return e < 0 ? ratio(1, p) : ratio(p);
}

/// The rational that a double is.
Rational exactly(double x) {
  int e = 0;
  const double mantissa = std::frexp(x, &e);
  return Rational(static_cast<std::int64_t>(std::ldexp(mantissa, 53))) * power_of_two(e - 53);
}

TEST(Coefficient, MultipliesTheImaginaryUnitToMinusOne) {
  const Coefficient i{0, 1};
  EXPECT_EQ(i * i, (Coefficient{-1, 0}));
}

TEST(Coefficient, DivisionUndoesMultiplication) {
  const Coefficient a{Rational(3, 7), Rational(-2, 5)};
  const Coefficient b{Rational(-1, 3), Rational(11, 13)};
  EXPECT_EQ((a * b) / b, a);
  EXPECT_EQ((a + b) - b, a);
  EXPECT_EQ(a + (-a), Coefficient{});
  EXPECT_TRUE(is_zero(a - a));
  EXPECT_FALSE(is_real(a));
}

TEST(Coefficient, RefusesDivisionByZero) {
  EXPECT_THROW((Coefficient{1, 0} / Coefficient{}), std::invalid_argument);
}

TEST(CommonDivisor, IsThatOfBoostForIntegersOfAnyLength) {
  std::mt19937_64 random(7);
  const auto integer = [&](int words) {
    Integer n = 0;
    for (int k = 0; k < words; ++k) n = (n << 64U) + random();
    return n;
  };
  for (int k = 0; k < 500; ++k) {
    const Integer common = integer(k % 5) + 1;
    const Integer a = common * integer(k % 11) << static_cast<unsigned>(k % 70);
    const Integer b = common * integer(k % 7);
    EXPECT_EQ(common_divisor(a, -b), gcd(a, b));
    EXPECT_EQ(common_divisor(b, a), gcd(a, b));
  }
}

TEST(CommonDivisor, TakesFibonaccisNumbersWhoseQuotientsAreAllOne) {
  Integer a = 1;
  Integer b = 1;
  for (int k = 0; k < 1000; ++k) {
    a += b;
    swap(a, b);
  }
  EXPECT_EQ(common_divisor(a * 21, b * 21), 21);
  EXPECT_EQ(common_divisor(0, b), b);
  EXPECT_EQ(common_divisor(0, 0), 0);
}

TEST(Rational, KeepsWhatItWasMadeOfInLowestTerms) {
  const Rational a = ratio(Integer(-6), Integer(4));
  EXPECT_EQ(numerator(a), -3);
  EXPECT_EQ(denominator(a), 2);
  EXPECT_EQ(bit_length(a), 2U);
  EXPECT_EQ(numerator(Rational()), 0);
  EXPECT_EQ(denominator(Rational()), 1);
  EXPECT_EQ(Rational(~std::uint64_t{0}) + 1, ratio(Integer(1) << 64U));
  EXPECT_EQ(Rational(std::numeric_limits<std::int64_t>::min()), -ratio(Integer(1) << 63U));
  EXPECT_EQ(Rational(-0.375), Rational(-3, 8));
}

/// Integers on both sides of what a word holds, and their neighbours.
std::vector<Integer> around_a_word(std::mt19937_64& random) {
  std::vector<Integer> found;
  for (const unsigned bits : {1U, 2U, 31U, 32U, 33U, 53U, 62U, 63U, 64U, 65U, 127U}) {
    const Integer power = Integer(1) << bits;
    for (const Integer& n : {Integer(power - 1), power, Integer(power + 1)}) found.push_back(n);
    found.push_back(1 + random() % power);
  }
  return found;
}

TEST(Rational, AddsAndMultipliesWithoutOverflowAroundTheLengthOfAWord) {
  std::mt19937_64 random(11);
  const std::vector<Integer> integers = around_a_word(random);
  const auto any = [&] { return integers[random() % integers.size()]; };
  for (int k = 0; k < 20000; ++k) {
    const Integer a = any() * (k % 2 == 0 ? 1 : -1);
    const Integer c = any() * (k % 3 == 0 ? 1 : -1);
    const Integer b = any();
    const Integer d = k % 5 == 0 ? b : any();
    const Rational x = ratio(a, b);
    const Rational y = ratio(c, d);
    ASSERT_EQ(x + y, ratio(a * d + c * b, b * d)) << x << " + " << y;
    ASSERT_EQ(x - y, ratio(a * d - c * b, b * d)) << x << " - " << y;
    ASSERT_EQ(x * y, ratio(a * c, b * d)) << x << " * " << y;
    ASSERT_EQ(x / y, ratio(a * d, b * c)) << x << " / " << y;
    ASSERT_TRUE((x - x).is_zero());
    ASSERT_EQ(numerator(x) * b, a * denominator(x));
    ASSERT_EQ(common_divisor(numerator(x * y), denominator(x * y)), 1);
  }
}

TEST(Rational, IsTheDoubleThatItWasMadeOf) {
  for (const double x : {0.1, -0.375, 3e300, 5e-324, -1.5, 0x1p62, 0x1p63, 1e-16}) {
    EXPECT_EQ(to_double(Rational(x)), x);
    EXPECT_EQ(Rational(x), exactly(x));
    EXPECT_EQ(common_divisor(numerator(Rational(x)), denominator(Rational(x))), 1);
  }
}

TEST(Rational, IsOrderedAndPrintedAsANumber) {
  EXPECT_LT(Rational(-1, 2), Rational(-1, 3));
  EXPECT_GT(Rational(1, 7), 0);
  EXPECT_LT(Rational(), Rational(1, 7));
  std::ostringstream text;
  text << Rational(-31, 10) << ' ' << Rational(5) << ' ' << Rational();
  EXPECT_EQ(text.str(), "-31/10 5 0");
}

TEST(Rational, RefusesAZeroDenominator) {
  EXPECT_THROW(Rational(1, 0), std::invalid_argument);
  EXPECT_THROW(ratio(Integer(1), Integer(0)), std::invalid_argument);
  EXPECT_THROW(Rational(1) / Rational(), std::invalid_argument);
}

TEST(Rational, IsNotChangedByWorkOnItsCopy) {
  const Rational a(1, 3);
  Rational b = a;
  b += 1;
  b = b * b - b;
  EXPECT_EQ(a, Rational(1, 3));
  EXPECT_EQ(b, Rational(4, 9));
  const Rational& self = b;
  b = self;
  EXPECT_EQ(b, Rational(4, 9));
}

TEST(ToDouble, GivesTheDoubleThatADecimalLiteralGives) {
  EXPECT_EQ(to_double(Rational(31, 10)), 3.1);
  EXPECT_EQ(to_double(Rational(-1, 3)), -1.0 / 3.0);
  EXPECT_EQ(to_double(Rational(0)), 0.0);
  EXPECT_EQ(to_complex({Rational(1, 10), Rational(-7, 5)}), std::complex<double>(0.1, -1.4));
}

TEST(ToDouble, BreaksTiesToTheEvenNeighbour) {
  const Rational half_ulp = power_of_two(-53);
  EXPECT_EQ(to_double(1 + half_ulp), 1.0);
  EXPECT_EQ(to_double(1 + 3 * half_ulp), 1.0 + 2 * Double::epsilon());
  EXPECT_EQ(to_double(1 + half_ulp + power_of_two(-2000)), 1.0 + Double::epsilon());
  EXPECT_EQ(to_double(2 - power_of_two(-54)), 2.0);
}

TEST(ToDouble, RoundsDenormalsToTheirCoarserGrid) {
  const double least = Double::denorm_min();
  const Rational ulp = power_of_two(-1074);
  EXPECT_EQ(to_double(ulp), least);
  EXPECT_EQ(to_double(ulp / 2), 0.0);
  EXPECT_EQ(to_double(ulp / 2 + power_of_two(-3000)), least);
  EXPECT_EQ(to_double(ulp * 3 / 2), 2 * least);
  EXPECT_EQ(to_double(ulp * 5 / 2), 2 * least);
  EXPECT_EQ(to_double(power_of_two(-1022) - ulp / 2), Double::min());
  EXPECT_EQ(to_double(-power_of_two(-5000)), 0.0);
}

TEST(ToDouble, OverflowsToInfinityOnlyBeyondHalfAnUlpOfTheGreatest) {
  const Rational greatest = exactly(Double::max());
  const Rational half_ulp = power_of_two(970);
  EXPECT_EQ(to_double(greatest), Double::max());
  EXPECT_EQ(to_double(greatest + half_ulp - 1), Double::max());
  EXPECT_EQ(to_double(greatest + half_ulp), Double::infinity());
  EXPECT_EQ(to_double(-power_of_two(90000)), -Double::infinity());
}

TEST(ToDouble, IsFiniteForAQuotientOfHugeNumbers) {
  const Integer huge = pow(Integer(10), 5000U);
  EXPECT_EQ(to_double(ratio(huge * 31, huge * 10 + 1)), 3.1);
}

TEST(ToDouble, ReturnsEveryDoubleToItself) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000; ++k) {
    const std::uint64_t bits = random();
    double x = 0;
    std::memcpy(&x, &bits, sizeof x);
    if (!std::isfinite(x)) continue;
    EXPECT_EQ(to_double(exactly(x)), x);
  }
}

TEST(ToDouble, LiesWithinHalfAnUlpOfRandomQuotients) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 2000; ++k) {
    // Every other one has so few digits that numerator and denominator are doubles themselves.
    Rational r = random() >> (k % 2 == 0 ? 0 : 11);
    if (k % 2 == 0) r *= random();
    r /= (random() >> (11 + k % 50)) + 1;
    const double x = to_double(r);
    const Rational error = abs(Rational(exactly(x) - r));
    const Rational gap_above = exactly(std::nextafter(x, Double::infinity())) - exactly(x);
    const Rational gap_below = exactly(x) - exactly(std::nextafter(x, 0.0));
    EXPECT_LE(error * 2, exactly(x) > r ? gap_below : gap_above);
  }
}

}  // namespace
}  // namespace moivre
