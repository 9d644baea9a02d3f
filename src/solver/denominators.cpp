// SPDX-License-Identifier: MIT
// Values of denominators at roots, and the count of exact algebra beside what is left.
#include "denominators.h"

#include <algorithm>
#include <cmath>

#include "account.h"
#include "drop_solutions.h"
#include "moivre/algebra/quotient_ring.h"
#include "moivre/polynomial/digits.h"
#include "moivre/polynomial/value.h"
#include "solver_sentences.h"

namespace moivre {
namespace {

/// How far the value may be from zero by rounding and by the root's error, as if every factor of
/// every term were off by it.
bool is_zero_at(const Polynomial& d, const Solution& root) {
  constexpr double kRoundingOfValue = 8 * 0x1p-53;  // of eight operations a factor
  const double of_root = root.accuracy * std::max(1.0, max_norm(root.x));
  double moved = 0;
  for (const Term& term : d.terms) {
    for (const Power& power : term.monomial) {
      Monomial rest = term.monomial;
      const auto one = std::find(rest.begin(), rest.end(), power);
      if (--one->exponent == 0) rest.erase(one);
      moved += std::abs(to_complex(term.coefficient) * static_cast<double>(power.exponent) *
                        value_at(rest, root.x));
    }
  }
  const double rounding =
      kRoundingOfValue * static_cast<double>(degree(d) + 1) * term_size(d, root.x);
  return std::abs(value_at(d, root.x)) <= rounding + 2 * of_root * moved;
}

/// The number of roots off the denominators, with multiplicity; nullopt where exact algebra does
/// not tell.
std::optional<std::uint64_t> count_off(const System& f) {
  if (!coefficient_errors(f).empty()) return std::nullopt;
  System off = f;
  Polynomial product = unknown(static_cast<std::uint32_t>(f.variables.size()));
  for (const Polynomial& d : f.denominators) product = product * d;
  off.variables.emplace_back("1/denominators");
  off.polynomials.push_back(product - 1);
  const QuotientRing ring = quotient_ring(off, {});
  if (ring.verdict != QuotientRing::Verdict::finite) return std::nullopt;
  return ring.dimension;
}

}  // namespace

void drop_on_denominators(const System& f, SolveResult& result) {
  if (f.denominators.empty()) return;
  result.on_denominators += drop_solutions_where(result, [&](const Solution& root) {
    return std::any_of(f.denominators.begin(), f.denominators.end(),
                       [&](const Polynomial& d) { return is_zero_at(d, root); });
  });
  result.left_out.push_back(roots_on_denominators_left_out(result.on_denominators));
  if (result.on_denominators == 0 || !result.complete) return;
  std::uint64_t kept = 0;
  for (const Solution& root : result.solutions) kept += root.multiplicity;
  const std::optional<std::uint64_t> off = count_off(f);
  if (off && *off != kept) {
    put_in_doubt(result, algebra_doubt(AlgebraCount::off_denominators, *off, kept));
  } else if (!off && result.completeness == RootCompleteness::proved) {
    result.completeness = RootCompleteness::shown;
    result.bound.reset();
  }
}

}  // namespace moivre
