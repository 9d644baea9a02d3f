// SPDX-License-Identifier: MIT
// log(a / b) of two complex doubles in a complex scalar S of more digits than double.
//
//   2^e of both apart, p and q are left;  log(p / q) = 2 (z + z^3 / 3 + z^5 / 5 + ...), z = (p - q) / (p + q)
//
// On one ray |z| <= 1/3, and each term adds a digit; with an angle between p and q it takes more.
// Edges: a, b finite and not 0, in one half plane: an angle of a right one or more gives nonsense. S: numeric/scalar.h.
#pragma once

#include <algorithm>
#include <cmath>

#include "moivre/numeric/complex.h"
#include "moivre/numeric/scalar.h"

namespace moivre {

template <class S>
class LogRatio {
  using Real = typename Scalar<S>::Real;

 public:
  LogRatio() : log2_(log_of(S(2.0), S(1.0))) {}

  S operator()(const Complex& a, const Complex& b) const {
    const int ea = exponent(a);
    const int eb = exponent(b);
    const S powers = product(Real(static_cast<double>(ea - eb)), log2_);
    return powers + log_of(S(scaled(a, -ea)), S(scaled(b, -eb)));
  }

 private:
  static int exponent(const Complex& a) {
    int e = 0;
    std::frexp(std::max(std::abs(a.real()), std::abs(a.imag())), &e);
    return e;
  }
  static Complex scaled(const Complex& a, int e) {
    return {std::ldexp(a.real(), e), std::ldexp(a.imag(), e)};
  }

  static S log_of(const S& p, const S& q) {
    const S z = product(p - q, reciprocal(p + q));
    const S square = product(z, z);
    const double ratio = magnitude1(to_complex(square));
    S power = z + z;
    S sum = power;
    double odd = 1;
    for (double size = 1; size > Scalar<S>::epsilon && ratio < 1; size *= ratio) {
      power = product(power, square);
      odd += 2;
      sum += product(Real(1.0) / Real(odd), power);
    }
    return sum;
  }

  S log2_;
};

}  // namespace moivre
