// SPDX-License-Identifier: MIT
// How are complex numbers held, and multiplied in inner loops? By the textbook product, in which a
// NaN stays a NaN.
//
// std::complex's operator* looks for NaN after every product (C99 Annex G) and costs several times
// as much.
// `product` and `add_product` are what the tape, the LU and the homotopy multiply with; other
// scalars overload them.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace moivre {

using Complex = std::complex<double>;
/// A point of C^n.
using Point = std::vector<Complex>;

/// A number whose digits are beyond any machine number, as plain text: each part as "-1.2345e-7" or
/// "12.345"; every digit that stands there is right; "0" where none is known.
struct ComplexDecimal {
  std::string re;
  std::string im;

  friend bool operator==(const ComplexDecimal&, const ComplexDecimal&) = default;
};

inline Complex product(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
inline Complex product(const Complex& a, double b) { return {a.real() * b, a.imag() * b}; }
inline Complex product(double a, const Complex& b) { return product(b, a); }
inline double product(double a, double b) { return a * b; }

/// sum + a b.
inline Complex add_product(const Complex& a, const Complex& b, const Complex& sum) {
  return sum + product(a, b);
}
inline Complex add_product(double a, const Complex& b, const Complex& sum) {
  return sum + product(a, b);
}

/// conj(a) * b.
inline Complex conjugate_product(const Complex& a, const Complex& b) {
  return {a.real() * b.real() + a.imag() * b.imag(), a.real() * b.imag() - a.imag() * b.real()};
}

/// 1/a without scaling: overflows where |a|^2 does.
inline Complex reciprocal(const Complex& a) {
  const double scale = 1 / (a.real() * a.real() + a.imag() * a.imag());
  return {a.real() * scale, -a.imag() * scale};
}

/// |re| + |im|: between |a| and sqrt(2)|a|, without a root.
inline double magnitude1(const Complex& a) { return std::abs(a.real()) + std::abs(a.imag()); }

/// |a| without hypot's guard: overflows where |a|^2 does.
inline double modulus(const Complex& a) { return std::sqrt(std::norm(a)); }

inline bool is_finite(const Complex& a) {
  return std::isfinite(a.real()) && std::isfinite(a.imag());
}

/// max_i |x_i|; NaN where a coordinate is NaN.
inline double max_norm(const Point& x) {
  double squared = 0;
  for (const Complex& xi : x) {
    const double s = std::norm(xi);
    squared = s > squared || std::isnan(s) ? s : squared;
  }
  if (!std::isinf(squared)) return std::sqrt(squared);
  double largest = 0;  // a square may be beyond double where its root is not
  for (const Complex& xi : x) {
    const double size = std::abs(xi);
    largest = size > largest || std::isnan(size) ? size : largest;
  }
  return largest;
}

/// sqrt(sum |x_i|^2).
inline double euclidean_norm(const Point& x) {
  double squared = 0;
  for (const Complex& xi : x) squared += std::norm(xi);
  return std::sqrt(squared);
}

}  // namespace moivre
