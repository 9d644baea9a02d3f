// SPDX-License-Identifier: MIT
// Which exact number does a decimal text stand for, and is it one that may stand there?
#pragma once

#include <string>
#include <string_view>

#include "moivre/expression/expression.h"
#include "moivre/numeric/rational.h"

namespace moivre {

struct ParsedNumber {
  Rational value;
  /// Why the text is refused; empty when it is not.
  std::string refusal;
};

/// `text` is digits with an optional point and an optional exponent. The exponent is judged before
/// a power of ten is made, so 1e999999999 costs nothing.
ParsedNumber parse_number(std::string_view text, NumberRange range);

}  // namespace moivre
