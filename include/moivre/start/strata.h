// SPDX-License-Identifier: MIT
// At how many points can a sparse system have isolated roots at most? Stratum by stratum: which
// coordinates are 0?
//
//   Z          the coordinates that are 0 there; F_Z: F on this stratum, m equations that do not
//              vanish on it in k = n - |Z| unknowns, none of which is 0
//   m < k      a root, there or in the closure, lies on a set of k - m dimensions at least: none is
//              isolated
//   m = k      the mixed volume of F_Z [Bernstein75]; 1 where k = 0
//   m > k      none, where exact algebra shows it (algebra/torus_roots.h); else nothing is known
//
// An isolated root of F is one of its stratum, so the sum bounds their number. A root counts once
// here, or as often as its stratum has it, whatever its multiplicity in F. So roots at 0 of high
// multiplicity, and curves on which coordinates vanish, do not keep it from being met.
// Edges: a mixed volume counts where two liftings agree. Not supported: more than a dozen unknowns.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "moivre/polynomial/system.h"
#include "moivre/start/mixed_cells.h"

namespace moivre {

/// Some equation vanishes at 0: there may be strata on which roots have coordinates that are 0.
bool lacks_origin(const System& f);

/// f: square. most: no sum above it is of interest, which saves the search for it. nullopt: nothing
/// is known, or it is above `most`.
std::optional<std::uint64_t> most_isolated_points(
    const System& f, std::uint64_t seed, const CellSearchOptions& options = {},
    std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

}  // namespace moivre
