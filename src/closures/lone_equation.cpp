// SPDX-License-Identifier: MIT
// The known values put in, and one division.
#include "lone_equation.h"

#include <algorithm>
#include <cmath>

#include "moivre/formulation/exact.h"

namespace moivre {
namespace {

// A coefficient that cancelled to this, beside the terms it was added from, is zero.
constexpr double kCancelled = 1e-13;

// An exact value is rounded once its fractions are this long (in bits): a chain of lengths and
// directions stays below.
constexpr std::size_t kLongFraction = 2048;

Coefficient shortened(const Coefficient& c) {
  return std::max(bit_length(c.re), bit_length(c.im)) > kLongFraction ? exactly(to_complex(c)) : c;
}

}  // namespace

bool LoneEquation::is_one(const System& all, const Block& block) {
  if (block.equations.size() != 1) return false;
  for (const Term& term : all.polynomials[block.equations.front()].terms) {
    for (const Power& power : term.monomial) {
      if (power.variable == block.variables.front() && power.exponent > 1) return false;
    }
  }
  return true;
}

LoneEquation::LoneEquation(const System& all, const Block& block)
    : equation_(all.polynomials[block.equations.front()]),
      place_(all.variables.size()),
      answers_(all, block) {
  for (const Term& term : equation_.terms) {
    size_ = std::max(size_, std::abs(to_complex(term.coefficient)));
  }
}

const LoneEquation::Answer& LoneEquation::above(const PartialRoot& root) {
  return answers_.above(root, [&] { return solved(root); });
}

LoneEquation::Answer LoneEquation::solved(const PartialRoot& root) const {
  Coefficient a;
  Coefficient b;
  for (const Term& term : substituted(equation_, root.value, place_).terms) {
    (term.monomial.empty() ? b : a) = term.coefficient;
  }
  const auto vanishes = [&](const Coefficient& c) {
    return std::abs(to_complex(c)) <= kCancelled * size_;
  };
  if (vanishes(a)) return {nullptr, vanishes(b)};
  return {std::make_shared<const Known>(shortened(-b / a)), false};
}

}  // namespace moivre
