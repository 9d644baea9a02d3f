// SPDX-License-Identifier: MIT
// How is a coefficient kept as it was read? As an exact number, rounded once, to the scalar that
// asks.
//
// A decimal such as 3.1 is the rational 31/10; rounding it to double before arithmetic would change
// the problem. Boost's cpp_int does the arithmetic. This header does not include it, since its
// headers take a second to compile. Include integer.h to work with numerators and denominators of
// any length.
#pragma once

#include <compare>
#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <utility>

namespace moivre {

/// A fraction of integers of any length, in lowest terms.
class Rational {
 public:
  Rational() noexcept;
  template <std::signed_integral I>
  Rational(I value) : Rational(std::int64_t{value}, 1) {}
  template <std::unsigned_integral I>
  Rational(I value) : Rational(whole(value)) {}
  /// The double itself: 0.1 is 3602879701896397/2^55, not 1/10. Throws InvalidInput where it is not
  /// finite.
  template <std::floating_point F>
  Rational(F value) : Rational(of_double(static_cast<double>(value))) {
    static_assert(sizeof(F) <= sizeof(double), "a longer number than double would be rounded");
  }
  /// Throws InvalidInput where the denominator is zero.
  Rational(std::int64_t numerator, std::int64_t denominator);

  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  bool is_zero() const { return number_ == nullptr; }

  Rational& operator+=(const Rational& other);
  Rational& operator-=(const Rational& other);
  Rational& operator*=(const Rational& other);
  /// Throws InvalidInput where `other` is zero.
  Rational& operator/=(const Rational& other);

  struct Number;  ///< Boost's number; complete where integer.h is included
  explicit Rational(Number&& number);
  const Number& number() const;

 private:
  static Rational whole(std::uint64_t value);
  static Rational of_double(double value);

  std::unique_ptr<Number> number_;  // null: zero, as nearly every imaginary part is
};

inline Rational operator+(Rational a, const Rational& b) { return std::move(a += b); }
inline Rational operator-(Rational a, const Rational& b) { return std::move(a -= b); }
inline Rational operator*(Rational a, const Rational& b) { return std::move(a *= b); }
inline Rational operator/(Rational a, const Rational& b) { return std::move(a /= b); }
Rational operator-(const Rational& a);
Rational abs(const Rational& a);
bool operator==(const Rational& a, const Rational& b);
std::strong_ordering operator<=>(const Rational& a, const Rational& b);
/// As "31/10", or "31".
std::ostream& operator<<(std::ostream& out, const Rational& a);

/// The bits of the longer of numerator and denominator.
std::size_t bit_length(const Rational& a);

/// Gaussian rational re + i*im: the exact complex coefficient. A number of any type is one: 2, 0.5,
/// Rational(1, 3).
struct Coefficient {
  Rational re;
  Rational im;

  Coefficient() noexcept = default;
  Coefficient(Rational real, Rational imaginary = {})
      : re(std::move(real)), im(std::move(imaginary)) {}
  template <class N>
  requires std::integral<N> || std::floating_point<N> Coefficient(N real) : re(real) {}
  /// Both doubles themselves. Throws InvalidInput where one is not finite.
  explicit Coefficient(const std::complex<double>& value) : re(value.real()), im(value.imag()) {}

  friend bool operator==(const Coefficient&, const Coefficient&) = default;
};

Coefficient operator+(const Coefficient& a, const Coefficient& b);
Coefficient operator-(const Coefficient& a, const Coefficient& b);
Coefficient operator-(const Coefficient& a);
Coefficient operator*(const Coefficient& a, const Coefficient& b);
/// Throws InvalidInput where b is zero.
Coefficient operator/(const Coefficient& a, const Coefficient& b);

bool is_zero(const Coefficient& a);
bool is_real(const Coefficient& a);

/// The double nearest to r (round to nearest, ties to even; overflow gives infinity).
double to_double(const Rational& r);
std::complex<double> to_complex(const Coefficient& a);

}  // namespace moivre
