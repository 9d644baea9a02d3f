// SPDX-License-Identifier: MIT
// The strata, largest first; what takes more than counting is looked at last.
#include "moivre/start/strata.h"

#include <algorithm>
#include <vector>

#include "moivre/algebra/torus_roots.h"
#include "moivre/start/mixed_volume.h"

namespace moivre {
namespace {

// 2^n strata.
constexpr std::size_t kMostCoordinates = 12;

/// Bit j: x_j = 0.
using Zeros = std::uint32_t;

bool vanishes(const Term& term, Zeros zeros) {
  return std::any_of(term.monomial.begin(), term.monomial.end(),
                     [&](const Power& factor) { return (zeros >> factor.variable & 1) != 0; });
}

/// F_Z in the unknowns that are left.
System on_stratum(const System& f, Zeros zeros) {
  System g;
  std::vector<std::uint32_t> number(f.variables.size());
  for (std::size_t j = 0; j < f.variables.size(); ++j) {
    number[j] = static_cast<std::uint32_t>(g.variables.size());
    if ((zeros >> j & 1) == 0) g.variables.push_back(f.variables[j]);
  }
  for (const Polynomial& p : f.polynomials) {
    Polynomial left;
    for (const Term& term : p.terms) {
      if (vanishes(term, zeros)) continue;
      left.terms.push_back(term);
      for (Power& factor : left.terms.back().monomial) factor.variable = number[factor.variable];
    }
    if (!left.terms.empty()) g.polynomials.push_back(std::move(left));
  }
  return g;
}

/// Where two liftings agree.
std::optional<std::uint64_t> volume_of(const System& f, std::uint64_t seed,
                                       const CellSearchOptions& options) {
  const std::vector<Support> supports = supports_of(f);
  const auto first = mixed_volume(supports, seed, options).value;
  return first && first == mixed_volume(supports, ~seed, options).value ? first : std::nullopt;
}

}  // namespace

bool lacks_origin(const System& f) {
  return std::any_of(f.polynomials.begin(), f.polynomials.end(), [](const Polynomial& p) {
    return std::none_of(p.terms.begin(), p.terms.end(),
                        [](const Term& term) { return term.monomial.empty(); });
  });
}

std::optional<std::uint64_t> most_isolated_points(const System& f, std::uint64_t seed,
                                                  const CellSearchOptions& options,
                                                  std::uint64_t most) {
  const std::size_t n = f.variables.size();
  if (n > kMostCoordinates) return std::nullopt;
  std::vector<Zeros> sets;    // fewer equations than unknowns: no root of the closure is isolated
  std::vector<System> spare;  // more equations than unknowns
  std::uint64_t sum = 0;
  for (Zeros zeros = 0; zeros < Zeros{1} << n; ++zeros) {
    const bool is_in_set =
        std::any_of(sets.begin(), sets.end(), [&](Zeros set) { return (set & zeros) == set; });
    if (is_in_set) continue;
    System here = on_stratum(f, zeros);
    const std::size_t k = here.variables.size();
    const std::size_t m = here.polynomials.size();
    if (m < k) {
      sets.push_back(zeros);
    } else if (m > k) {
      spare.push_back(std::move(here));
    } else if (k == 0) {
      ++sum;
    } else if (!has_no_torus_root(here)) {
      const auto volume = volume_of(here, seed, options);
      if (!volume) return std::nullopt;
      sum += *volume;
    }
    if (sum > most) return std::nullopt;
  }
  const bool are_empty = std::all_of(spare.begin(), spare.end(), has_no_torus_root);
  return are_empty ? std::optional(sum) : std::nullopt;
}

}  // namespace moivre
