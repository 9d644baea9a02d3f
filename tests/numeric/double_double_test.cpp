// SPDX-License-Identifier: MIT
// Are sums and products of double-doubles as near to the exact rational ones as their header says?
#include "moivre/numeric/double_double.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

const Rational kRelativeError = ratio(1, Integer(1) << 102U);
// Each part of a complex product is made of three operations on numbers of at most |a||b|.
const Rational kComplexError = 4 * kRelativeError;
constexpr int kCount = 2000;

Rational exact(DoubleDouble a) { return Rational(a.hi) + Rational(a.lo); }

bool is_normalized(DoubleDouble a) { return a.hi + a.lo == a.hi; }

class RandomDoubleDouble {
 public:
  DoubleDouble operator()() {
    const double hi = std::ldexp(part_(random_), exponent_(random_));
    const double half_ulp = std::ldexp(hi, -54);
    return detail::quick_two_sum(hi, half_ulp * part_(random_));
  }

 private:
  std::mt19937_64 random_{1};
  std::uniform_real_distribution<double> part_{-1, 1};
  std::uniform_int_distribution<int> exponent_{-60, 60};
};

void expect_within(DoubleDouble computed, const Rational& wanted, const Rational& bound) {
  EXPECT_TRUE(is_normalized(computed));
  EXPECT_LE(abs(Rational(exact(computed) - wanted)), bound);
}

TEST(DoubleDouble, ErrorFreeTransformationsLoseNothing) {
  RandomDoubleDouble next;
  for (int k = 0; k < kCount; ++k) {
    const double a = next().hi;
    const double b = next().hi;
    EXPECT_EQ(exact(detail::two_sum(a, b)), Rational(a) + Rational(b));
    EXPECT_EQ(exact(detail::two_product(a, b)), Rational(a) * Rational(b));
  }
}

TEST(DoubleDouble, SumsDifferencesAndProductsKeepTheirRelativeError) {
  RandomDoubleDouble next;
  for (int k = 0; k < kCount; ++k) {
    const DoubleDouble a = next();
    const DoubleDouble b = next();
    const Rational x = exact(a);
    const Rational y = exact(b);
    expect_within(a + b, x + y, abs(Rational(x + y)) * kRelativeError);
    expect_within(a - b, x - y, abs(Rational(x - y)) * kRelativeError);
    expect_within(a * b, x * y, abs(Rational(x * y)) * kRelativeError);
  }
}

TEST(DoubleDouble, QuotientsKeepTheirRelativeError) {
  const Rational bound = ratio(1, Integer(1) << 100U);
  RandomDoubleDouble next;
  for (int k = 0; k < kCount; ++k) {
    const DoubleDouble a = next();
    const DoubleDouble b = next();
    const Rational wanted = exact(a) / exact(b);
    expect_within(a / b, wanted, abs(wanted) * bound);
  }
}

TEST(DoubleDouble, KeepsItsRelativeErrorWhereLeadingDigitsCancel) {
  RandomDoubleDouble next;
  for (int k = 0; k < kCount; ++k) {
    const DoubleDouble a = next();
    const DoubleDouble near(a.hi, next().lo * std::ldexp(1.0, std::ilogb(a.hi) - 60));
    const DoubleDouble b = detail::quick_two_sum(near.hi, near.lo);
    const Rational difference = exact(a) - exact(b);
    expect_within(a - b, difference, abs(difference) * kRelativeError);
    EXPECT_EQ(exact(a - a), 0);
  }
}

TEST(DoubleDouble, RoundsARationalToTheLastBit) {
  RandomDoubleDouble next;
  const Rational half_last_bit = ratio(1, Integer(1) << 106U);
  for (int k = 0; k < kCount; ++k) {
    const Rational r = exact(next()) / (exact(next()) + Rational(1, 3));
    expect_within(to_double_double(r), r, abs(r) * half_last_bit);
    EXPECT_EQ(to_double_double(r).hi, to_double(r));
    const DoubleDouble a = next();
    EXPECT_EQ(exact(to_double_double(exact(a))), exact(a));
  }
}

TEST(DoubleDouble, BeyondTheRangeOfDoubleIsInfinite) {
  const DoubleDouble huge = to_double_double(ratio(Integer(1) << 2000U));
  EXPECT_EQ(to_double(huge), std::numeric_limits<double>::infinity());
}

TEST(ComplexDoubleDouble, ProductsAreExactToADozenUnitsOfTheirModulus) {
  RandomDoubleDouble next;
  for (int k = 0; k < kCount; ++k) {
    const ComplexDoubleDouble a(next(), next());
    const ComplexDoubleDouble b(next(), next());
    const Coefficient x{exact(a.re), exact(a.im)};
    const Coefficient y{exact(b.re), exact(b.im)};
    const Coefficient wanted = x * y;
    const Rational size = (abs(x.re) + abs(x.im)) * (abs(y.re) + abs(y.im));
    const ComplexDoubleDouble c = product(a, b);
    expect_within(c.re, wanted.re, size * kComplexError);
    expect_within(c.im, wanted.im, size * kComplexError);
  }
}

// Errors are gathered and added once: of the size of the terms, also where these cancel.
TEST(ComplexDoubleDouble, SumsOfProductsAreExactToADozenUnitsOfTheirTerms) {
  RandomDoubleDouble next;
  for (int k = 0; k < kCount; ++k) {
    const ComplexDoubleDouble a(next(), next());
    const ComplexDoubleDouble b(next(), next());
    const bool cancels = k % 2 == 0;
    const ComplexDoubleDouble sum = cancels ? -product(a, b) : ComplexDoubleDouble(next(), next());
    const Coefficient x{exact(a.re), exact(a.im)};
    const Coefficient y{exact(b.re), exact(b.im)};
    const Coefficient z{exact(sum.re), exact(sum.im)};
    const Coefficient wanted = z + x * y;
    const Rational size = abs(z.re) + abs(z.im) + (abs(x.re) + abs(x.im)) * (abs(y.re) + abs(y.im));
    const ComplexDoubleDouble all = add_product(a, b, sum);
    expect_within(all.re, wanted.re, size * kComplexError);
    expect_within(all.im, wanted.im, size * kComplexError);
    const Rational real_size = abs(z.re) + abs(z.im) + abs(x.re) * (abs(y.re) + abs(y.im));
    const ComplexDoubleDouble by_real = add_product(a.re, b, sum);
    expect_within(by_real.re, z.re + x.re * y.re, real_size * kComplexError);
    expect_within(by_real.im, z.im + x.re * y.im, real_size * kComplexError);
  }
}

TEST(ComplexDoubleDouble, TheReciprocalTimesTheNumberIsOne) {
  RandomDoubleDouble next;
  for (int k = 0; k < kCount; ++k) {
    const ComplexDoubleDouble a(next(), next());
    const ComplexDoubleDouble one = product(a, reciprocal(a));
    EXPECT_LT(magnitude1(one - ComplexDoubleDouble(1.0)), 0x1p-98);
  }
}

TEST(ComplexDoubleDouble, TakesAndGivesBackComplexNumbersUnchanged) {
  const Complex z(0.1, -7e-30);
  EXPECT_EQ(to_complex(ComplexDoubleDouble(z)), z);
  const Coefficient third{Rational(1, 3), Rational(-2, 7)};
  EXPECT_EQ(to_complex(to_complex_double_double(third)), to_complex(third));
}

}  // namespace
}  // namespace moivre
