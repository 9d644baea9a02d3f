// SPDX-License-Identifier: MIT
// What was typed? A mathematical expression, read into a tree.
// Its nodes are plain and remember their place in the file.
//
// Sums and products are n-ary, so that a line of a million terms is a wide tree, not a deep one.
// The reader limits the depth to kMaximumDepth; recursion over a tree is therefore safe.
// Numbers are exact (decimal and scientific notation become rationals). `x - y` is sum(x,
// negate(y)), `x / y` is product(x, reciprocal(y)). What a name stands for (an unknown, a constant,
// the imaginary unit) is the caller's to say.
//
//   sum      = [+|-] product { (+|-) [-] product }
//   product  = power { (*|/) [-] power }                and 2x, 3(x + 1): a number right before
//            what it multiplies
//   power    = operand [ (^|**) [-] power ]             -x^2 is -(x^2), x^2^3 is x^(2^3)
//   operand  = number | name | name ( sum {, sum} ) | ( sum )     name and ( on one line
//   number   = digits [. digits] [(e|E) [+|-] digits], also .5
//   name     = letter (Greek ones too) or _, then letters, digits, small digits below the line, _,
//            [ and ]
//
// Not supported: other products without their `*` (x y, 1/2x), signs in a row (++, +-+), relations,
// comments.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "moivre/expression/source.h"
#include "moivre/numeric/rational.h"

namespace moivre {

/// Parentheses, calls and exponents inside one another.
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

/// Which numbers may stand in an expression? None of more than 5000 digits.
enum class NumberRange {
  of_double,  ///< zero, and what rounds to neither zero nor infinity
  any         ///< written out, 1e400 has 401 digits and 1e-400 has 400
};

/// Parses all of `text` (a piece of a source that begins at `begin`) as one expression.
/// Appended to `faults`: the first fault of the grammar in each summand, every unmatched
/// parenthesis, and every number that may not stand there. Such a number is 1 in the tree. After a
/// fault the result must not be used.
Expression parse_expression(std::string_view text, SourcePosition begin,
                            std::vector<Diagnostic>& faults,
                            NumberRange range = NumberRange::of_double);

/// The same for a sum that may be long, of any numbers: each summand, with its sign, is handed on
/// as soon as it is read and then forgotten. After a summand with a fault, correct summands are
/// still handed on, without their signs.
void parse_summands(std::string_view text, SourcePosition begin, std::vector<Diagnostic>& faults,
                    const std::function<void(const Expression&)>& take);

struct NamePlace {
  std::string_view name;
  SourcePosition at;
};

/// Every name in `text` in its order, those before a `(` (calls) left out; the text need not parse.
std::vector<NamePlace> names_in(std::string_view text, SourcePosition begin);

}  // namespace moivre
