// SPDX-License-Identifier: MIT
// What are sqrt(2), 2^(1/3), pi and cos(0.3)? Numbers of a text that no fraction is: the decimals
// of 40 digits nearest to them.
//
// Whole results are exact: sqrt(4) is 2. Others count as rounded (digits.h), to a double's error,
// as if their digits had been typed.
// While a NudgedNumbers lives in this thread each is another number, 1e-38 to 1e-37 of itself
// beside: what the two readings of a text have in common does not hang on the rounding.
#pragma once

#include <optional>
#include <string>

#include "moivre/numeric/rational.h"

namespace moivre {

/// nullopt where the function has no real value there, or one beyond double, or the angle is beyond
/// 1e6.
using NumberFunction = std::optional<Rational> (*)(const Rational& x);

/// sqrt, cbrt, exp, log, sin, cos, tan, asin, acos, atan; nullptr where there is none of that name.
NumberFunction number_function(const std::string& name);

/// The real number base^exponent.
std::optional<Rational> number_power(const Rational& base, const Rational& exponent);

Rational number_pi();

class NudgedNumbers {
 public:
  NudgedNumbers();
  ~NudgedNumbers();
  NudgedNumbers(const NudgedNumbers&) = delete;
  NudgedNumbers& operator=(const NudgedNumbers&) = delete;
};

}  // namespace moivre
