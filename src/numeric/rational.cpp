// SPDX-License-Identifier: MIT
// How do Gaussian rationals add and multiply, and which double is nearest to a rational?
#include "moivre/numeric/rational.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <ostream>

#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"

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

/// n > 0 as a double, where it is one and its quotient by another such is neither too large nor
/// denormal.
std::optional<double> as_double(const Integer& n) {
  constexpr auto kMostBits = static_cast<std::size_t>(Double::max_exponent / 2);
  // Nearly every number that was typed is that short.
  const auto& limbs = n.backend();
  if (limbs.size() == 1 && *limbs.limbs() >> Double::digits == 0) {
    return static_cast<double>(*limbs.limbs());
  }
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

using Number = Rational::Number;

Rational from(Number&& value) { return Rational(std::move(value)); }

/// What is there is overwritten: no memory is asked for.
void put(Number&& value, std::unique_ptr<Number>& place) {
  if (value.above.is_zero()) {
    place = nullptr;
  } else if (place) {
    *place = std::move(value);
  } else {
    place = std::make_unique<Number>(std::move(value));
  }
}

bool is_whole(const Number& x) { return x.below == 1; }

void require_divisor(bool is_zero) {
  if (is_zero) throw InvalidInput("division of an exact number by zero");
}

/// Numerator and denominator of a number that was typed nearly always fit a machine word: their
/// arithmetic takes a tenth of the time. What overflows is taken with integers of any length.
struct Short {
  std::int64_t above = 0;
  std::int64_t below = 1;
};

/// n, where |n| < 2^63.
bool fits(const Integer& n, std::int64_t& word) {
  const auto& limbs = n.backend();
  if (limbs.size() != 1 || *limbs.limbs() >> 63U != 0) return false;
  const auto size = static_cast<std::int64_t>(*limbs.limbs());
  word = limbs.sign() ? -size : size;
  return true;
}

bool fits(const Number& x, Short& both) {
  return fits(x.above, both.above) && fits(x.below, both.below);
}

bool has_53_bits(std::int64_t n) { return std::abs(n) >> Double::digits == 0; }

bool multiplied(std::int64_t a, std::int64_t b, std::int64_t& product) {
  return !__builtin_mul_overflow(a, b, &product) &&
         product != std::numeric_limits<std::int64_t>::min();
}

/// a + sign b; what both denominators have in common is looked at alone [Knuth98, 4.5.1].
bool added(const Short& a, const Short& b, int sign, Short& sum) {
  const std::int64_t common = a.below == b.below ? a.below : std::gcd(a.below, b.below);
  const std::int64_t a_rest = a.below / common;
  std::int64_t first = 0;
  std::int64_t second = 0;
  if (!multiplied(a.above, b.below / common, first) || !multiplied(b.above, a_rest, second) ||
      __builtin_add_overflow(first, sign * second, &sum.above) ||
      sum.above == std::numeric_limits<std::int64_t>::min()) {
    return false;
  }
  if (sum.above == 0) {
    sum.below = 1;
    return true;
  }
  const std::int64_t shared = common == 1 ? 1 : std::gcd(sum.above, common);
  sum.above /= shared;
  return multiplied(a_rest, b.below / shared, sum.below);
}

bool multiplied(const Short& a, const Short& b, Short& product) {
  const std::int64_t first = b.below == 1 ? 1 : std::gcd(a.above, b.below);
  const std::int64_t second = a.below == 1 ? 1 : std::gcd(b.above, a.below);
  return multiplied(a.above / first, b.above / second, product.above) &&
         multiplied(a.below / second, b.below / first, product.below);
}

/// In lowest terms.
Number fraction(Integer numerator, Integer denominator) {
  require_divisor(denominator.is_zero());
  Short z;
  if (fits(numerator, z.above) && fits(denominator, z.below)) {
    const std::int64_t common = std::gcd(z.above, z.below) * (z.below < 0 ? -1 : 1);
    return {z.above / common, z.below / common};
  }
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  const Integer common = denominator == 1 ? denominator : common_divisor(numerator, denominator);
  if (common != 1) {
    numerator /= common;
    denominator /= common;
  }
  return {std::move(numerator), std::move(denominator)};
}

/// a + sign b; what both denominators have in common is looked at alone [Knuth98, 4.5.1].
Number sum(const Number& a, const Number& b, int sign) {
  Short x;
  Short y;
  Short z;
  if (fits(a, x) && fits(b, y) && added(x, y, sign, z)) return {z.above, z.below};
  if (sign < 0 && a.above == b.above && a.below == b.below) return {};
  const Integer b_above = sign < 0 ? Integer(-b.above) : b.above;
  if (is_whole(a) && is_whole(b)) return {a.above + b_above, 1};
  const Integer common = common_divisor(a.below, b.below);
  if (common == 1) return {a.above * b.below + b_above * a.below, a.below * b.below};
  const Integer a_rest = a.below / common;
  Integer above = a.above * (b.below / common) + b_above * a_rest;
  if (above.is_zero()) return {};
  const Integer shared = common_divisor(above, common);
  if (shared == 1) return {std::move(above), a_rest * b.below};
  return {above / shared, a_rest * (b.below / shared)};
}

Number product(const Number& a, const Number& b) {
  Short x;
  Short y;
  Short z;
  if (fits(a, x) && fits(b, y) && multiplied(x, y, z)) return {z.above, z.below};
  if (is_whole(a) && is_whole(b)) return {a.above * b.above, 1};
  const Integer first = common_divisor(a.above, b.below);
  const Integer second = common_divisor(b.above, a.below);
  const auto rest = [](const Integer& n, const Integer& divisor) {
    return divisor == 1 ? n : Integer(n / divisor);
  };
  return {rest(a.above, first) * rest(b.above, second),
          rest(a.below, second) * rest(b.below, first)};
}

/// Of x, exactly: an odd mantissa has no divisor in common with a power of two.
Number number_of(double x) {
  if (x == 0) return {};
  int exponent = 0;
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), Double::digits));
  const int twos = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  mantissa >>= twos;
  exponent += twos - Double::digits;
  if (exponent >= 0) return {Integer(mantissa) << static_cast<unsigned>(exponent), 1};
  return {mantissa, Integer(1) << static_cast<unsigned>(-exponent)};
}

}  // namespace

Rational::Rational() noexcept = default;
Rational::Rational(Rational&& other) noexcept = default;
Rational& Rational::operator=(Rational&& other) noexcept = default;
Rational::~Rational() = default;

Rational Rational::of_double(double value) {
  if (!std::isfinite(value)) {
    throw InvalidInput("an exact number must be finite, not " + std::to_string(value));
  }
  return from(number_of(value));
}
Rational::Rational(std::int64_t numerator, std::int64_t denominator) {
  if (denominator == 1 && numerator == 0) return;
  *this = from(denominator == 1 ? Number{numerator, 1} : fraction(numerator, denominator));
}
Rational::Rational(Number&& number)
    : number_(number.above.is_zero() ? nullptr : std::make_unique<Number>(std::move(number))) {}
Rational::Rational(const Rational& other)
    : number_(other.is_zero() ? nullptr : std::make_unique<Number>(*other.number_)) {}
Rational& Rational::operator=(const Rational& other) { return *this = Rational(other); }

Rational Rational::whole(std::uint64_t value) { return from({value, 1}); }

const Rational::Number& Rational::number() const {
  static const Number kZero;
  return number_ ? *number_ : kZero;
}

Rational& Rational::operator+=(const Rational& other) {
  if (!other.is_zero()) put(sum(number(), other.number(), 1), number_);
  return *this;
}
Rational& Rational::operator-=(const Rational& other) {
  if (!other.is_zero()) put(sum(number(), other.number(), -1), number_);
  return *this;
}
Rational& Rational::operator*=(const Rational& other) {
  if (!is_zero()) put(product(number(), other.number()), number_);
  return *this;
}
Rational& Rational::operator/=(const Rational& other) {
  require_divisor(other.is_zero());
  if (is_zero()) return *this;
  const auto& [above, below] = other.number();
  put(product(number(), above < 0 ? Number{-below, -above} : Number{below, above}), number_);
  return *this;
}

Rational operator-(const Rational& a) { return from({-numerator(a), denominator(a)}); }
Rational abs(const Rational& a) { return from({abs(numerator(a)), denominator(a)}); }
bool operator==(const Rational& a, const Rational& b) {
  return numerator(a) == numerator(b) && denominator(a) == denominator(b);
}
std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  if (denominator(a) == denominator(b)) return numerator(a).compare(numerator(b)) <=> 0;
  return Integer(numerator(a) * denominator(b)).compare(numerator(b) * denominator(a)) <=> 0;
}
std::ostream& operator<<(std::ostream& out, const Rational& a) {
  out << numerator(a);
  return denominator(a) == 1 ? out : out << '/' << denominator(a);
}

Rational ratio(const Integer& numerator, const Integer& denominator) {
  return from(fraction(numerator, denominator));
}
const Integer& numerator(const Rational& a) { return a.number().above; }
const Integer& denominator(const Rational& a) { return a.number().below; }

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
  if (is_real(a) && is_real(b)) return {a.re * b.re, {}};
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
  Short words;
  if (fits(r.number(), words) && has_53_bits(words.above) && has_53_bits(words.below)) {
    return static_cast<double>(words.above) / static_cast<double>(words.below);
  }
  const Integer& n = numerator(r);
  const double magnitude = positive_quotient_to_double(abs(n), denominator(r));
  return n < 0 ? -magnitude : magnitude;
}

std::complex<double> to_complex(const Coefficient& a) { return {to_double(a.re), to_double(a.im)}; }

}  // namespace moivre
