// SPDX-License-Identifier: MIT
// What must a complex scalar offer so that tapes, homotopies and paths can be evaluated in it?
//
// Scalar<S> names its real type, rounds exact coefficients to S, and says how exact S is: `epsilon`
// bounds the relative error of a product. RealScalar<R> rounds to the real type. S itself needs
// S(double), S(Complex), S(R, R), +, -, +=, ==, product(S, S), product(R, S), add_product of the
// same, and for paths conj, reciprocal, magnitude1 and to_complex.
// Here double and double-double; multiprecision has more.
#pragma once

#include "moivre/numeric/double_double.h"

namespace moivre {

template <class R>
struct RealScalar;

template <>
struct RealScalar<double> {
  static double round(const Rational& r) { return to_double(r); }
};

template <>
struct RealScalar<DoubleDouble> {
  static DoubleDouble round(const Rational& r) { return to_double_double(r); }
};

template <class S>
struct Scalar;

template <>
struct Scalar<Complex> {
  using Real = double;
  static constexpr double epsilon = 0x1p-53;
  static Complex round(const Coefficient& c) { return to_complex(c); }
};

template <>
struct Scalar<ComplexDoubleDouble> {
  using Real = DoubleDouble;
  static constexpr double epsilon = 0x1p-104;
  static ComplexDoubleDouble round(const Coefficient& c) { return to_complex_double_double(c); }
};

}  // namespace moivre
