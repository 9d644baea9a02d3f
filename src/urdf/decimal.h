// SPDX-License-Identifier: MIT
// Which exact number is this word of a URDF? Decimals with an optional exponent; "1." and ".5" are
// numbers there.
#pragma once

#include <string>
#include <string_view>

#include "moivre/numeric/rational.h"

namespace moivre {

struct Decimal {
  Rational value;
  std::string refusal;  ///< why the word is refused, with what to do; empty when it is not
};

Decimal read_decimal(std::string_view word);

}  // namespace moivre
