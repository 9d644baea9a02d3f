// SPDX-License-Identifier: MIT
// How do Gaussian rationals add and multiply, and which double is nearest to a rational?
#include "moivre/numeric/rational.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "moivre/numeric/integer.h"

namespace moivre {

namespace {

using Double = std::numeric_limits<double>;
static_assert(Double::is_iec559 && Double::digits == 53, "to_double rounds to IEEE binary64");

/// ulp of the smallest normal binade and of every denormal: 2^-1074.
constexpr long kLeastUlpExponent = Double::min_exponent - Double::digits;

long floor_log2_of_quotient(const Integer& n, const Integer& d) {
  const long e = static_cast<long>(msb(n)) - static_cast<long>(msb(d));
  const bool reaches =
      e >= 0 ? n >= (d << static_cast<unsigned>(e)) : (n << static_cast<unsigned>(-e)) >= d;
  return reaches ? e : e - 1;
}

/// n/d for positive n and d, rounded to the nearest multiple of 2^exponent, ties to even, over
/// 2^exponent.
Integer rounded_quotient(Integer n, Integer d, long exponent) {
  if (exponent < 0) {
    n <<= static_cast<unsigned>(-exponent);
  } else {
    d <<= static_cast<unsigned>(exponent);
  }
  Integer quotient;
  Integer remainder;
  divide_qr(n, d, quotient, remainder);
  remainder <<= 1;
  const bool up = remainder > d || (remainder == d && bit_test(quotient, 0));
  return up ? Integer(quotient + 1) : quotient;
}

/// n > 0 as a double, where it is one and its quotient by another such is neither too large nor denormal.
std::optional<double> as_double(const Integer& n) {
  constexpr auto kMostBits = static_cast<std::size_t>(Double::max_exponent / 2);
  const std::size_t high = msb(n);
  const std::size_t low = lsb(n);
  if (high - low >= Double::digits || high >= kMostBits) return std::nullopt;
  const Integer digits = n >> static_cast<unsigned>(low);
  return std::ldexp(static_cast<double>(static_cast<std::uint64_t>(digits)), static_cast<int>(low));
}

double positive_quotient_to_double(const Integer& n, const Integer& d) {
  // IEEE division of two doubles is rounded once: long division is left out.
  if (const auto a = as_double(n)) {
    if (const auto b = as_double(d)) return *a / *b;
  }
  const long magnitude = floor_log2_of_quotient(n, d);
  if (magnitude >= Double::max_exponent) return Double::infinity();
  if (magnitude < kLeastUlpExponent - 1) return 0.0;
  const long ulp_exponent = std::max(magnitude - (Double::digits - 1), kLeastUlpExponent);
  const Integer multiple = rounded_quotient(n, d, ulp_exponent);
  return std::ldexp(static_cast<double>(static_cast<std::uint64_t>(multiple)),
                    static_cast<int>(ulp_exponent));
}

using Fraction = decltype(Rational::Number::value);

Rational from(Fraction&& value) { return Rational(Rational::Number{std::move(value)}); }

bool is_whole(const Fraction& x) { return denominator(x) == 1; }

void require_divisor(bool is_zero) {
  if (is_zero) throw std::invalid_argument("division of an exact number by zero");
}

Fraction fraction(const Integer& numerator, const Integer& denominator) {
  require_divisor(denominator.is_zero());
  return {numerator, denominator};
}

}  // namespace

Rational::Rational() noexcept = default;
Rational::Rational(Rational&& other) noexcept = default;
Rational& Rational::operator=(Rational&& other) noexcept = default;
Rational::~Rational() = default;

Rational::Rational(double value) : Rational(from(Fraction(value))) {}
Rational::Rational(std::int64_t numerator, std::int64_t denominator)
    : Rational(from(fraction(numerator, denominator))) {}
Rational::Rational(Number&& number)
    : number_(number.value.is_zero() ? nullptr : std::make_unique<Number>(std::move(number))) {}
Rational::Rational(const Rational& other)
    : number_(other.is_zero() ? nullptr : std::make_unique<Number>(*other.number_)) {}
Rational& Rational::operator=(const Rational& other) { return *this = Rational(other); }

Rational Rational::whole(std::uint64_t value) { return from(Fraction(value)); }

const Rational::Number& Rational::number() const {
  static const Number kZero;
  return number_ ? *number_ : kZero;
}

template <class Step>
Rational& Rational::changed_by(const Step& step) {
  if (!number_) number_ = std::make_unique<Number>();
  step(number_->value);
  if (number_->value.is_zero()) number_.reset();
  return *this;
}

Rational& Rational::operator+=(const Rational& other) {
  if (other.is_zero()) return *this;
  return changed_by([&](Fraction& a) {
    const Fraction& b = other.number().value;
    // Boost looks for a common divisor with 1 as well, in most of the time that long integers take.
    if (is_whole(a) && is_whole(b)) {
      a = Fraction(Integer(numerator(a) + numerator(b)));
    } else {
      a += b;
    }
  });
}
Rational& Rational::operator-=(const Rational& other) {
  if (other.is_zero()) return *this;
  return changed_by([&](Fraction& value) { value -= other.number().value; });
}
Rational& Rational::operator*=(const Rational& other) {
  if (is_zero()) return *this;
  return changed_by([&](Fraction& a) {
    const Fraction& b = other.number().value;
    if (is_whole(a) && is_whole(b)) {
      a = Fraction(Integer(numerator(a) * numerator(b)));
    } else {
      a *= b;
    }
  });
}
Rational& Rational::operator/=(const Rational& other) {
  require_divisor(other.is_zero());
  return changed_by([&](Fraction& value) { value /= other.number().value; });
}

Rational operator-(const Rational& a) { return from(-a.number().value); }
Rational abs(const Rational& a) { return from(abs(a.number().value)); }
bool operator==(const Rational& a, const Rational& b) {
  return a.number().value == b.number().value;
}
std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  return a.number().value.compare(b.number().value) <=> 0;
}
std::ostream& operator<<(std::ostream& out, const Rational& a) { return out << a.number().value; }

Rational ratio(const Integer& numerator, const Integer& denominator) {
  return from(fraction(numerator, denominator));
}
Integer numerator(const Rational& a) { return numerator(a.number().value); }
Integer denominator(const Rational& a) { return denominator(a.number().value); }

std::size_t bit_length(const Integer& a) {
  return a.is_zero() ? 0 : static_cast<std::size_t>(msb(Integer(abs(a)))) + 1;
}
std::size_t bit_length(const Rational& a) {
  return a.is_zero() ? 0 : std::max(bit_length(numerator(a)), bit_length(denominator(a)));
}

Coefficient operator+(const Coefficient& a, const Coefficient& b) {
  return {a.re + b.re, a.im + b.im};
}

Coefficient operator-(const Coefficient& a, const Coefficient& b) {
  return {a.re - b.re, a.im - b.im};
}

Coefficient operator-(const Coefficient& a) { return {-a.re, -a.im}; }

Coefficient operator*(const Coefficient& a, const Coefficient& b) {
  if (is_real(a) && is_real(b)) return {a.re * b.re, 0};
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

Coefficient operator/(const Coefficient& a, const Coefficient& b) {
  require_divisor(is_zero(b));
  if (is_real(b)) return {a.re / b.re, a.im / b.re};
  const Rational squared_modulus = b.re * b.re + b.im * b.im;
  return {(a.re * b.re + a.im * b.im) / squared_modulus,
          (a.im * b.re - a.re * b.im) / squared_modulus};
}

bool is_zero(const Coefficient& a) { return a.re.is_zero() && a.im.is_zero(); }

bool is_real(const Coefficient& a) { return a.im.is_zero(); }

double to_double(const Rational& r) {
  if (r.is_zero()) return 0.0;
  const Integer n = numerator(r);
  const double magnitude = positive_quotient_to_double(abs(n), denominator(r));
  return n < 0 ? -magnitude : magnitude;
}

std::complex<double> to_complex(const Coefficient& a) { return {to_double(a.re), to_double(a.im)}; }

}  // namespace moivre
