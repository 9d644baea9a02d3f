// SPDX-License-Identifier: MIT
// What is a disc of complex numbers, as a scalar of tapes? A midpoint in double or double-double,
// and a radius.
//
//   Disc(m, r) = {z : |z - m| <= r};  the result of an operation encloses the operation on all
//                                     members of its operands
//
//   product, double:         |fl(ab) - ab| <= sqrt(5) u |a||b|
//                            [BrentPercivalZimmermann07]
//   product, double-double:  each real sum and product to 2^-102 (double_double.h), so 2 sqrt(2)
//                            2^-102 |a||b| < 2^-100 |a||b|
//   sum:                     u, or 2^-102, of the result's size
// and what falls below the smallest normal number, less than 2^-1065 an operation, is covered by
// `raised`.
// A coefficient is a disc as well: the exact rational lies in it.
#pragma once

#include "moivre/numeric/double_double.h"
#include "upward.h"

namespace moivre {

/// Disc around a complex double.
struct Ball {
  double re = 0;
  double im = 0;
  double radius = 0;

  Ball() = default;
  explicit Ball(double value) : re(value) {}
  Ball(const Complex& middle, double r) : re(middle.real()), im(middle.imag()), radius(r) {}

  Complex middle() const { return {re, im}; }

  Ball& operator+=(const Ball& b) {
    constexpr double kSumError = 2 * kUnitRoundoff;
    re += b.re;
    im += b.im;
    radius = raised(radius + b.radius + kSumError * size_bound(re, im));
    return *this;
  }
};

/// Disc around a complex double-double.
struct FineBall {
  ComplexDoubleDouble middle;
  double radius = 0;

  FineBall() = default;
  explicit FineBall(double value) : middle(value) {}
  FineBall(const ComplexDoubleDouble& m, double r) : middle(m), radius(r) {}

  FineBall& operator+=(const FineBall& b) {
    constexpr double kSumError = 0x1p-101;
    middle += b.middle;
    radius = raised(radius + b.radius + kSumError * size_bound(middle.re.hi, middle.im.hi));
    return *this;
  }
};

/// A coefficient as a disc; what every product with it needs is worked out once.
template <class Middle>
struct CoefficientBall {
  Middle middle;
  double radius = 0;
  double size = 0;       ///< bound on the modulus of its members
  bool is_real = false;  ///< its middle is
};

namespace detail {

/// Radius of a product: sizes of the middles, radii, and the rounding of the middle as a share of
/// the sizes' product.
inline double product_radius(double size_a, double radius_a, double size_b, double radius_b,
                             double rounding) {
  return raised(size_a * (radius_b + rounding * size_b) + (size_b + radius_b) * radius_a);
}

inline constexpr double kProductError = 4 * kUnitRoundoff;
inline constexpr double kFineProductError = 0x1p-100;

}  // namespace detail

inline Ball product(const Ball& a, const Ball& b) {
  return {product(a.middle(), b.middle()),
          detail::product_radius(size_bound(a.re, a.im), a.radius, size_bound(b.re, b.im), b.radius,
                                 detail::kProductError)};
}

inline Ball product(const CoefficientBall<Complex>& c, const Ball& b) {
  return {c.is_real ? product(c.middle.real(), b.middle()) : product(c.middle, b.middle()),
          detail::product_radius(c.size, c.radius, size_bound(b.re, b.im), b.radius,
                                 detail::kProductError)};
}

inline FineBall product(const FineBall& a, const FineBall& b) {
  return {product(a.middle, b.middle),
          detail::product_radius(size_bound(a.middle.re.hi, a.middle.im.hi), a.radius,
                                 size_bound(b.middle.re.hi, b.middle.im.hi), b.radius,
                                 detail::kFineProductError)};
}

inline FineBall product(const CoefficientBall<ComplexDoubleDouble>& c, const FineBall& b) {
  return {c.is_real ? product(c.middle.re, b.middle) : product(c.middle, b.middle),
          detail::product_radius(c.size, c.radius, size_bound(b.middle.re.hi, b.middle.im.hi),
                                 b.radius, detail::kFineProductError)};
}

}  // namespace moivre
