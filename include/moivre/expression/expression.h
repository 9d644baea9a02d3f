// SPDX-License-Identifier: MIT
// What was typed? A mathematical expression as a tree of plain nodes that remember their place in the file.
//
// Sums and products are n-ary, so that a line of a million terms is a wide tree, not a deep one.
// The reader limits the depth to kMaximumDepth; recursion over a tree is therefore safe.
// Numbers are exact (decimal and scientific notation become rationals). `x - y` is sum(x, negate(y)),
// `x / y` is product(x, reciprocal(y)). What a name stands for (an unknown, a constant, the
// imaginary unit) is the caller's to say.
#pragma once

#include <string>
#include <vector>

#include "moivre/expression/source.h"
#include "moivre/numeric/rational.h"

namespace moivre {

inline constexpr int kMaximumDepth = 256;

struct Expression {
  enum class Kind {
    number,      ///< `number`
    name,        ///< `name`
    sum,         ///< operands added
    product,     ///< operands multiplied
    negate,      ///< minus the operand
    reciprocal,  ///< one over the operand
    power,       ///< operands[0] to the operands[1]
    call         ///< function `name` (sin, cos, ...) of the operands
  };

  Kind kind = Kind::number;
  SourcePosition at;
  Rational number;
  std::string name;
  std::vector<Expression> operands;
};

/// Parses all of `text` (a piece of `source` that begins at `begin`) as one expression:
///   + - * / ^ ** parentheses, numbers, names, calls f(a, b); ^ binds tighter than unary minus and to the right.
/// Every fault is appended to `faults`; when there was one the result is of no use.
Expression parse_expression(std::string_view text, SourcePosition begin,
                            std::vector<Diagnostic>& faults);

}  // namespace moivre
