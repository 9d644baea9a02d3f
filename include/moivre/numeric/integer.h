// SPDX-License-Identifier: MIT
// Which integers is a rational made of? Exact ones of any length; how it is made of two of them and taken apart.
//
// Boost's cpp_int carries the arithmetic. Its headers are heavy: only sources that need numerators include this one.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>

#include "moivre/numeric/rational.h"

namespace moivre {

// Without expression templates: `auto c = a * b` is a number, not a formula that refers to a and b.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;

struct Rational::Number {
  boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                boost::multiprecision::et_off>
      value;
};

/// Throws std::invalid_argument where the denominator is zero.
Rational ratio(const Integer& numerator, const Integer& denominator = 1);
Integer numerator(const Rational& a);
/// Positive.
Integer denominator(const Rational& a);

/// 0 for 0.
std::size_t bit_length(const Integer& a);

}  // namespace moivre
