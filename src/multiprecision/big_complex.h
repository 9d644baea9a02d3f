// SPDX-License-Identifier: MIT
// How are complex numbers of D decimal digits a scalar of tapes, of elimination and of paths?
#pragma once

#include <boost/multiprecision/mpfr.hpp>

#include "moivre/numeric/complex.h"
#include "moivre/numeric/integer.h"
#include "moivre/numeric/scalar.h"

namespace moivre {

template <unsigned D>
using BigBackend =
    boost::multiprecision::mpfr_float_backend<D, boost::multiprecision::allocate_stack>;
/// A number of D digits: its precision is part of its type, so threads share no setting.
template <unsigned D>
using BigReal = boost::multiprecision::number<BigBackend<D>, boost::multiprecision::et_off>;

template <unsigned D>
struct BigComplex {
  BigReal<D> re;
  BigReal<D> im;

  BigComplex() = default;
  explicit BigComplex(double value) : re(value) {}
  explicit BigComplex(const Complex& value) : re(value.real()), im(value.imag()) {}
  BigComplex(BigReal<D> real, BigReal<D> imaginary)
      : re(std::move(real)), im(std::move(imaginary)) {}
  template <unsigned E>
  explicit BigComplex(const BigComplex<E>& value) : re(value.re), im(value.im) {}

  friend bool operator==(const BigComplex& a, const BigComplex& b) {
    return a.re == b.re && a.im == b.im;
  }
};

/// result <- a op b, in place: what an operator of BigReal returns is copied with all its digits.
template <class Operation, unsigned D>
void set(Operation op, BigReal<D>& result, const BigReal<D>& a, const BigReal<D>& b) {
  op(result.backend().data(), a.backend().data(), b.backend().data(), MPFR_RNDN);
}

template <unsigned D>
BigComplex<D> operator+(const BigComplex<D>& a, const BigComplex<D>& b) {
  BigComplex<D> sum;
  set(mpfr_add, sum.re, a.re, b.re);
  set(mpfr_add, sum.im, a.im, b.im);
  return sum;
}
template <unsigned D>
BigComplex<D> operator-(const BigComplex<D>& a, const BigComplex<D>& b) {
  BigComplex<D> difference;
  set(mpfr_sub, difference.re, a.re, b.re);
  set(mpfr_sub, difference.im, a.im, b.im);
  return difference;
}
template <unsigned D>
BigComplex<D> operator-(const BigComplex<D>& a) {
  return {-a.re, -a.im};
}
template <unsigned D>
BigComplex<D>& operator+=(BigComplex<D>& a, const BigComplex<D>& b) {
  a.re += b.re;
  a.im += b.im;
  return a;
}
template <unsigned D>
BigComplex<D> product(const BigComplex<D>& a, const BigComplex<D>& b) {
  BigComplex<D> ab;
  BigReal<D> part;
  set(mpfr_mul, ab.re, a.re, b.re);
  set(mpfr_mul, part, a.im, b.im);
  ab.re -= part;
  set(mpfr_mul, ab.im, a.re, b.im);
  set(mpfr_mul, part, a.im, b.re);
  ab.im += part;
  return ab;
}
template <unsigned D>
BigComplex<D> product(const BigReal<D>& a, const BigComplex<D>& b) {
  BigComplex<D> ab;
  set(mpfr_mul, ab.re, a, b.re);
  set(mpfr_mul, ab.im, a, b.im);
  return ab;
}
template <unsigned D>
BigReal<D> product(const BigReal<D>& a, const BigReal<D>& b) {
  return a * b;
}
template <unsigned D>
BigComplex<D> add_product(const BigComplex<D>& a, const BigComplex<D>& b,
                          const BigComplex<D>& sum) {
  BigComplex<D> result = product(a, b);
  result += sum;
  return result;
}
template <unsigned D>
BigComplex<D> add_product(const BigReal<D>& a, const BigComplex<D>& b, const BigComplex<D>& sum) {
  BigComplex<D> result = product(a, b);
  result += sum;
  return result;
}
template <unsigned D>
BigComplex<D> conj(const BigComplex<D>& a) {
  return {a.re, -a.im};
}
template <unsigned D>
Complex to_complex(const BigComplex<D>& a) {
  return {static_cast<double>(a.re), static_cast<double>(a.im)};
}
/// |a|^2.
template <unsigned D>
BigReal<D> norm(const BigComplex<D>& a) {
  return a.re * a.re + a.im * a.im;
}
template <unsigned D>
BigReal<D> magnitude1(const BigComplex<D>& a) {
  return abs(a.re) + abs(a.im);
}
template <unsigned D>
BigComplex<D> reciprocal(const BigComplex<D>& a) {
  const BigReal<D> size = norm(a);
  return {a.re / size, -a.im / size};
}

template <unsigned D>
BigReal<D> to_big(const Rational& r) {
  return BigReal<D>(numerator(r)) / BigReal<D>(denominator(r));
}
template <unsigned D>
BigComplex<D> to_big(const Coefficient& c) {
  return {to_big<D>(c.re), to_big<D>(c.im)};
}

template <unsigned D>
struct RealScalar<boost::multiprecision::number<BigBackend<D>, boost::multiprecision::et_off>> {
  static BigReal<D> round(const Rational& r) { return to_big<D>(r); }
};

template <unsigned D>
struct Scalar<BigComplex<D>> {
  using Real = BigReal<D>;
  /// 10^-D: the arithmetic has a few bits more.
  static constexpr double epsilon = [] {
    double power = 1;
    for (unsigned k = 0; k < D; ++k) power /= 10;
    return power;
  }();
  static BigComplex<D> round(const Coefficient& c) { return to_big<D>(c); }
};

}  // namespace moivre
