// SPDX-License-Identifier: MIT
// Squared up, sliced or patched, by the functions of polynomial.
#include "stand_in.h"

#include "moivre/polynomial/patches.h"
#include "moivre/polynomial/powers.h"
#include "moivre/polynomial/square_up.h"

namespace moivre {

StandIn make_stand_in(const System& f, std::uint64_t seed, bool counts_paths) {
  StandIn result;
  result.system = has_homogeneous_groups(f) ? with_patches(f, seed) : f;
  result.patches.assign(
      result.system.polynomials.begin() + static_cast<std::ptrdiff_t>(f.polynomials.size()),
      result.system.polynomials.end());
  const std::size_t m = result.system.polynomials.size();
  const std::size_t n = result.system.variables.size();
  if (result.has_patches()) result.name = "a patch for each homogeneous group";
  if (m > n) {
    // Other combinations than the solver's: a root that those added is none of these.
    result.system = square_up(result.system, ~seed);
    result.has_all_roots = result.proves_roots = false;
    result.name = "random combinations of the equations";
  } else if (m < n) {
    result.system = with_slices(result.system, seed);
    result.name = "random slices, those of the seed";
  } else if (counts_paths && !result.has_patches()) {
    PowerFree bases = power_free(f);
    result.sheets = bases.sheets;
    if (bases.sheets > 1) {
      result.system = std::move(bases.system);
      result.name = "the bases of equations that are powers";
    }
  }
  if (result.has_patches()) result.has_all_roots = false;
  return result;
}

Point on_patches(const StandIn& stand_in, Point x) {
  for (const Polynomial& patch : stand_in.patches) {
    Complex scale = 0;
    for (const Term& term : patch.terms) {
      if (!term.monomial.empty())
        scale += to_complex(term.coefficient) * x[term.monomial[0].variable];
    }
    for (const Term& term : patch.terms) {
      if (!term.monomial.empty()) x[term.monomial[0].variable] /= scale;
    }
  }
  return x;
}

}  // namespace moivre
