// SPDX-License-Identifier: MIT
// Exact numbers: how a coefficient is kept as it was read, and rounded once, to the scalar that
// asks.
//
// A decimal such as 3.1 is the rational 31/10; rounding it to double before arithmetic would change
// the problem. Boost's cpp_rational carries the arithmetic.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <complex>

namespace moivre {

// Without expression templates: `auto c = a * b` is a number, not a formula that refers to a and b.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                               boost::multiprecision::et_off>;

/// Gaussian rational re + i*im: the exact complex coefficient.
struct Coefficient {
  Rational re;
  Rational im;

  friend bool operator==(const Coefficient&, const Coefficient&) = default;
};

Coefficient operator+(const Coefficient& a, const Coefficient& b);
Coefficient operator-(const Coefficient& a, const Coefficient& b);
Coefficient operator-(const Coefficient& a);
Coefficient operator*(const Coefficient& a, const Coefficient& b);
/// Requires b != 0 (std::invalid_argument).
Coefficient operator/(const Coefficient& a, const Coefficient& b);

bool is_zero(const Coefficient& a);
bool is_real(const Coefficient& a);

/// The double nearest to r (round to nearest, ties to even; overflow gives infinity).
double to_double(const Rational& r);
std::complex<double> to_complex(const Coefficient& a);

}  // namespace moivre
