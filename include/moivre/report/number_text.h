// SPDX-License-Identifier: MIT
// How is a number written down: with every digit, with the digits that are known, or in PHCpack's
// columns?
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "moivre/numeric/complex.h"

namespace moivre {

/// The shortest text that reads back as the same double; "" where x is not finite.
std::string exact_text(double x);

/// x to the last digit that `error` (absolute, >= 0) leaves sure, 17 significant ones at most; "0"
/// where no digit is.
std::string known_digits(double x, double error);
/// "re + im i", both parts as known_digits.
std::string known_digits(Complex x, double error);

/// x to so many significant digits, without zeros at the end: 320.28, 1.5e-07.
std::string short_text(double x, int digits = 4);

/// Two significant digits, as in 2.2e-16; "unknown" where x is not finite.
std::string rough_text(double x);

/// "re im" in scientific notation with 17 digits, signs aligned, as PHCpack writes it.
std::string phc_text(Complex x);

}  // namespace moivre
