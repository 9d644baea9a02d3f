// SPDX-License-Identifier: MIT
// What must a complex scalar offer so that tapes and homotopies can be evaluated in it?
//
// Scalar<S> names its real coefficient type and rounds exact coefficients to it. S itself needs S(double), +, -, +=
// product(S, S), product(Real, S) and add_product of the same.
#pragma once

#include "moivre/numeric/double_double.h"

namespace moivre {

template <class S>
struct Scalar;

template <>
struct Scalar<Complex> {
  using Real = double;
  static Complex round(const Coefficient& c) { return to_complex(c); }
  static double round_real(const Rational& r) { return to_double(r); }
};

template <>
struct Scalar<ComplexDoubleDouble> {
  using Real = DoubleDouble;
  static ComplexDoubleDouble round(const Coefficient& c) { return to_complex_double_double(c); }
  static DoubleDouble round_real(const Rational& r) { return to_double_double(r); }
};

}  // namespace moivre
