// SPDX-License-Identifier: MIT
// Do two trackers agree, path by path? A difference shows that one of them has jumped. The second
// tracker is the witness.
//
// The same options give the same homotopy and the same numbering of paths. So a simple root has one
// path, and both trackers must find it there. Where they differ, both follow the path again with
// tighter tolerances. If they then agree, the tracker that had found another end has jumped.
// Edges: roots of higher multiplicity are compared as points, not by path. A witness with failed
// paths proves less.
#pragma once

#include "moivre/solver/solve.h"

namespace moivre {

/// Solves f again with `witness` and the options of `result`'s run, and enters the comparison in
/// `result`. A root that only the witness found makes the result incomplete. `tracker` is the one
/// that gave `result`.
void cross_check(const System& f, SolveResult& result, const Tracker& tracker,
                 const Tracker& witness, const SolveOptions& options,
                 const std::atomic<bool>& stop = std::atomic<bool>{false});

/// The comparison alone: nothing is tracked, no disagreement settled.
CrossCheck compare(const SolveResult& result, const SolveResult& witness);

}  // namespace moivre
