// SPDX-License-Identifier: MIT
// How are solutions taken out of a result, so that its ledger still says which path leads to which?
#pragma once

#include <utility>
#include <vector>

#include "moivre/solver/solve.h"

namespace moivre {

/// Takes out those for which is_dropped(solution) holds; it is asked once of each.
template <class Predicate>
void drop_solutions(SolveResult& result, Predicate is_dropped) {
  std::vector<std::uint32_t> place;
  std::vector<Solution> kept;
  for (Solution& solution : result.solutions) {
    const bool is_kept = !is_dropped(solution);
    place.push_back(is_kept ? static_cast<std::uint32_t>(kept.size()) : PathRecord::kNoSolution);
    if (is_kept) kept.push_back(std::move(solution));
  }
  result.solutions = std::move(kept);
  for (PathRecord& path : result.ledger) {
    if (path.solution != PathRecord::kNoSolution) path.solution = place[path.solution];
  }
}

}  // namespace moivre
