// SPDX-License-Identifier: MIT
// How are solutions and points of sets taken out of a result, so that its ledger still says which
// path leads to which solution?
#pragma once

#include <utility>
#include <vector>

#include "moivre/solver/solve.h"

namespace moivre {

/// Takes out those for which is_dropped(solution) holds. The number of solutions that were dropped,
/// with multiplicity.
template <class Predicate>
std::uint64_t drop_solutions(SolveResult& result, Predicate is_dropped) {
  std::uint64_t dropped = 0;
  std::vector<std::uint32_t> place;
  std::vector<Solution> kept;
  for (Solution& solution : result.solutions) {
    const bool is_kept = !is_dropped(solution);
    if (!is_kept) dropped += solution.multiplicity;
    place.push_back(is_kept ? static_cast<std::uint32_t>(kept.size()) : PathRecord::kNoSolution);
    if (is_kept) kept.push_back(std::move(solution));
  }
  result.solutions = std::move(kept);
  std::erase_if(result.on_sets, is_dropped);
  for (PathRecord& path : result.ledger) {
    if (path.solution != PathRecord::kNoSolution) path.solution = place[path.solution];
  }
  return dropped;
}

}  // namespace moivre
