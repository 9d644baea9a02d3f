// SPDX-License-Identifier: MIT
// Which integers is a rational made of? Exact ones of any length; how it is made of two of them and
// taken apart.
//
// Boost's cpp_int carries the arithmetic. Its headers are heavy: only sources that need numerators
// include this one.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>

#include "moivre/numeric/rational.h"

namespace moivre {

// Without expression templates: `auto c = a * b` is a number, not a formula that refers to a and b.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;

struct Rational::Number {
  Integer above;
  Integer below = 1;  ///< positive, without a divisor in common with `above`
};

/// Throws std::invalid_argument where the denominator is zero.
Rational ratio(const Integer& numerator, const Integer& denominator = 1);
/// Both live as long as the rational.
const Integer& numerator(const Rational& a);
/// Positive.
const Integer& denominator(const Rational& a);

/// The greatest common divisor, >= 0, of any two integers; of 0 and 0 it is 0. Lehmer's algorithm
/// [Knuth98, 4.5.2], which takes half a word of quotients at a time, where Boost's gcd takes a bit.
Integer common_divisor(Integer a, Integer b);

/// 0 for 0.
std::size_t bit_length(const Integer& a);

}  // namespace moivre
