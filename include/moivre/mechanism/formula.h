// SPDX-License-Identifier: MIT
// What is the value of a typed expression, and how does it change? A tree whose names are resolved,
// evaluated in Taylor arithmetic.
//
// Made from an Expression by `resolve`: each name is an unknown (its index), a constant (its
// value), pi, or the time t.
// Functions: sin cos tan asin acos atan sqrt exp log. x^p with a constant p keeps its sign rules;
// otherwise x^y = exp(y log x).
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "moivre/expression/expression.h"

namespace moivre {

struct Formula {
  enum class Kind {
    constant,  ///< `value`
    unknown,   ///< the coordinate `index`
    time,      ///< t
    sum,       ///< operands added
    product,   ///< operands multiplied
    negate,
    reciprocal,
    power,  ///< operands[0] to the operands[1]
    sin,
    cos,
    tan,
    asin,
    acos,
    atan,
    sqrt,
    exp,
    log
  };

  Kind kind = Kind::constant;
  double value = 0;
  std::size_t index = 0;
  std::vector<Formula> operands;
};

/// What the names in an expression stand for.
struct Names {
  std::map<std::string, std::size_t> unknowns;
  std::map<std::string, double> constants;
  bool has_time = true;  ///< whether t (unless declared otherwise) is the time
};

/// Every name that stands for nothing and every unknown function is appended to `faults`, with the
/// nearest known name.
Formula resolve(const Expression& expression, const Names& names, std::vector<Diagnostic>& faults);

/// Indices of the unknowns that occur, sorted, each once.
std::vector<std::size_t> unknowns_of(const Formula& formula);
bool depends_on_time(const Formula& formula);

/// Whether 2 pi more in the unknown change nothing: it stands in sin, cos and tan only, with whole
/// factors.
bool repeats_by_turns(const Formula& formula, std::size_t unknown);

/// The formula at q and t in the scalar S (Jet, Gradient or Magnitude).
template <class S>
S evaluate(const Formula& formula, std::span<const S> q, const S& t);

}  // namespace moivre
