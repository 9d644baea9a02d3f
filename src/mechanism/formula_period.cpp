// SPDX-License-Identifier: MIT
// Is an angle known by its place on the circle alone? Where an unknown stands in a formula, and
// with which factors.
#include <algorithm>
#include <cmath>
#include <optional>

#include "moivre/mechanism/formula.h"
#include "moivre/mechanism/jet.h"

namespace moivre {
namespace {

using Kind = Formula::Kind;

// Thirds and the like, multiplied back, miss whole numbers by rounding.
constexpr double kWhole = 1e-12;

bool contains(const Formula& formula, std::size_t unknown) {
  return (formula.kind == Kind::unknown && formula.index == unknown) ||
         std::any_of(formula.operands.begin(), formula.operands.end(),
                     [&](const Formula& operand) { return contains(operand, unknown); });
}

bool is_number(const Formula& formula) {
  return !depends_on_time(formula) && unknowns_of(formula).empty();
}

/// The factor of the unknown in a formula that is linear in it; nullopt where it is not.
std::optional<double> factor_of(const Formula& formula, std::size_t unknown) {
  if (!contains(formula, unknown)) return 0;
  if (formula.kind == Kind::unknown) return 1;
  const bool is_linear =
      formula.kind == Kind::sum || formula.kind == Kind::negate || formula.kind == Kind::product;
  if (!is_linear) return std::nullopt;
  double total = formula.kind == Kind::product ? 1 : 0;
  for (const Formula& operand : formula.operands) {
    if (formula.kind == Kind::product && is_number(operand)) {
      total *= evaluate<Jet>(operand, {}, Jet(0)).f;
      continue;
    }
    const std::optional<double> part = factor_of(operand, unknown);
    if (!part || (formula.kind == Kind::product && *part == 0)) return std::nullopt;
    total = formula.kind == Kind::product ? total * *part : total + *part;
  }
  return formula.kind == Kind::negate ? -total : total;
}

}  // namespace

bool repeats_by_turns(const Formula& formula, std::size_t unknown) {
  if (!contains(formula, unknown)) return true;
  if (formula.kind == Kind::unknown) return false;
  if (formula.kind == Kind::sin || formula.kind == Kind::cos || formula.kind == Kind::tan) {
    const std::optional<double> factor = factor_of(formula.operands[0], unknown);
    if (factor && std::abs(*factor - std::nearbyint(*factor)) <= kWhole) return true;
  }
  return std::all_of(formula.operands.begin(), formula.operands.end(),
                     [&](const Formula& operand) { return repeats_by_turns(operand, unknown); });
}

}  // namespace moivre
