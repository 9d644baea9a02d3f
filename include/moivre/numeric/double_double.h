// SPDX-License-Identifier: MIT
// How has a number twice the digits of double? As an unevaluated sum hi + lo of two doubles (106
// bits).
//
//   |lo| <= ulp(hi)/2;  sums and products by error-free transformations [Dekker71], [Knuth98];
//   relative error of a sum or product at most 2^-102, of a quotient 2^-100. The exponent range is
//   double's: values below 1e-292 lose digits.
//   Complex products and sums of products gather their errors and add them once: at most 2^-100 of
//   the sum of the terms' magnitudes, as a scalar product in any floating arithmetic, and not of
//   the result where terms cancel.
// DoubleDouble is a real scalar of a tape; ComplexDoubleDouble the complex one. Not supported:
// square roots, transcendental functions, NaN payloads.
#pragma once

#include <cmath>

#include "moivre/numeric/complex.h"
#include "moivre/numeric/rational.h"

namespace moivre {

struct DoubleDouble {
  double hi = 0;
  double lo = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : hi(value) {}
  constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}

  friend bool operator==(const DoubleDouble&, const DoubleDouble&) = default;
};

namespace detail {

/// a + b = sum + error exactly.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}
/// As two_sum, for |a| >= |b|.
inline DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}
/// a * b = product + error exactly (fused multiply-add).
inline DoubleDouble two_product(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

}  // namespace detail

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  DoubleDouble s = detail::two_sum(a.hi, b.hi);
  const DoubleDouble t = detail::two_sum(a.lo, b.lo);
  s = detail::quick_two_sum(s.hi, s.lo + t.hi);
  return detail::quick_two_sum(s.hi, s.lo + t.lo);
}
inline DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }
inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + (-b); }
inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble p = detail::two_product(a.hi, b.hi);
  return detail::quick_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}
/// By long division, three digits of double each; relative error at most 2^-100.
inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double first = a.hi / b.hi;
  const DoubleDouble rest = a - b * first;
  const double second = rest.hi / b.hi;
  const double third = (rest - b * second).hi / b.hi;
  return detail::quick_two_sum(first, second) + DoubleDouble(third);
}
inline DoubleDouble& operator+=(DoubleDouble& a, DoubleDouble b) { return a = a + b; }
inline DoubleDouble product(DoubleDouble a, DoubleDouble b) { return a * b; }
/// a b + c d.
inline DoubleDouble sum_of_products(DoubleDouble a, DoubleDouble b, DoubleDouble c,
                                    DoubleDouble d) {
  const DoubleDouble p = detail::two_product(a.hi, b.hi);
  const DoubleDouble q = detail::two_product(c.hi, d.hi);
  const DoubleDouble all = detail::two_sum(p.hi, q.hi);
  const double left = p.lo + (a.hi * b.lo + a.lo * b.hi);
  const double right = q.lo + (c.hi * d.lo + c.lo * d.hi);
  return detail::quick_two_sum(all.hi, (left + right) + all.lo);
}
/// sum + a b.
inline DoubleDouble add_product(DoubleDouble a, DoubleDouble b, DoubleDouble sum) {
  const DoubleDouble p = detail::two_product(a.hi, b.hi);
  const DoubleDouble all = detail::two_sum(sum.hi, p.hi);
  const double low = p.lo + (a.hi * b.lo + a.lo * b.hi);
  return detail::quick_two_sum(all.hi, low + (all.lo + sum.lo));
}
/// sum + a b + c d.
inline DoubleDouble add_products(DoubleDouble a, DoubleDouble b, DoubleDouble c, DoubleDouble d,
                                 DoubleDouble sum) {
  const DoubleDouble p = detail::two_product(a.hi, b.hi);
  const DoubleDouble q = detail::two_product(c.hi, d.hi);
  const DoubleDouble pq = detail::two_sum(p.hi, q.hi);
  const DoubleDouble all = detail::two_sum(sum.hi, pq.hi);
  const double left = p.lo + (a.hi * b.lo + a.lo * b.hi);
  const double right = q.lo + (c.hi * d.lo + c.lo * d.hi);
  return detail::quick_two_sum(all.hi, (left + right) + (all.lo + (pq.lo + sum.lo)));
}
inline double to_double(DoubleDouble a) { return a.hi + a.lo; }

/// The double-double nearest to r (up to its last bit).
inline DoubleDouble to_double_double(const Rational& r) {
  const double hi = to_double(r);
  if (!std::isfinite(hi)) return {hi, 0};
  return {hi, to_double(r - Rational(hi))};
}

struct ComplexDoubleDouble {
  DoubleDouble re;
  DoubleDouble im;

  constexpr ComplexDoubleDouble() = default;
  constexpr ComplexDoubleDouble(double value) : re(value) {}
  constexpr ComplexDoubleDouble(DoubleDouble real, DoubleDouble imaginary)
      : re(real), im(imaginary) {}
  ComplexDoubleDouble(const Complex& value) : re(value.real()), im(value.imag()) {}

  friend bool operator==(const ComplexDoubleDouble&, const ComplexDoubleDouble&) = default;
};

inline ComplexDoubleDouble operator+(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return {a.re + b.re, a.im + b.im};
}
inline ComplexDoubleDouble operator-(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return {a.re - b.re, a.im - b.im};
}
inline ComplexDoubleDouble operator-(const ComplexDoubleDouble& a) { return {-a.re, -a.im}; }
inline ComplexDoubleDouble& operator+=(ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return a = a + b;
}
inline ComplexDoubleDouble product(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return {sum_of_products(a.re, b.re, -a.im, b.im), sum_of_products(a.re, b.im, a.im, b.re)};
}
inline ComplexDoubleDouble product(DoubleDouble a, const ComplexDoubleDouble& b) {
  return {a * b.re, a * b.im};
}
inline ComplexDoubleDouble operator*(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return product(a, b);
}
inline ComplexDoubleDouble add_product(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b,
                                       const ComplexDoubleDouble& sum) {
  return {add_products(a.re, b.re, -a.im, b.im, sum.re),
          add_products(a.re, b.im, a.im, b.re, sum.im)};
}
inline ComplexDoubleDouble add_product(DoubleDouble a, const ComplexDoubleDouble& b,
                                       const ComplexDoubleDouble& sum) {
  return {add_product(a, b.re, sum.re), add_product(a, b.im, sum.im)};
}
inline Complex to_complex(const ComplexDoubleDouble& a) {
  return {to_double(a.re), to_double(a.im)};
}
inline ComplexDoubleDouble conj(const ComplexDoubleDouble& a) { return {a.re, -a.im}; }
/// 1/a without scaling: overflows where |a|^2 does.
inline ComplexDoubleDouble reciprocal(const ComplexDoubleDouble& a) {
  const DoubleDouble size = a.re * a.re + a.im * a.im;
  return {a.re / size, -a.im / size};
}
/// |re| + |im|, rounded to double.
inline double magnitude1(const ComplexDoubleDouble& a) { return magnitude1(to_complex(a)); }
inline ComplexDoubleDouble to_complex_double_double(const Coefficient& c) {
  return {to_double_double(c.re), to_double_double(c.im)};
}

}  // namespace moivre
