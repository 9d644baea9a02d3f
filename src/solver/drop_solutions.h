// SPDX-License-Identifier: MIT
// How are solutions and points of sets taken out of a result, so that its table still says which
// path leads to which solution?
#pragma once

#include <utility>
#include <vector>

#include "moivre/solver/solve.h"

namespace moivre {

/// Takes out the solutions k for which is_dropped[k]; points of sets stay. The number of solutions
/// that were dropped, with multiplicity.
inline std::uint64_t drop_solutions(SolveResult& result, const std::vector<bool>& is_dropped) {
  std::uint64_t dropped = 0;
  std::vector<std::uint32_t> place;
  std::vector<Solution> kept;
  for (std::size_t k = 0; k < result.solutions.size(); ++k) {
    Solution& solution = result.solutions[k];
    const bool is_kept = !is_dropped[k];
    if (!is_kept) dropped += solution.multiplicity;
    place.push_back(is_kept ? static_cast<std::uint32_t>(kept.size()) : PathRecord::kNoSolution);
    if (is_kept) kept.push_back(std::move(solution));
  }
  result.solutions = std::move(kept);
  for (PathRecord& path : result.ledger) {
    if (path.solution != PathRecord::kNoSolution) path.solution = place[path.solution];
  }
  return dropped;
}

/// Takes out those, and points of sets, for which is_dropped(solution) holds.
template <class Predicate>
std::uint64_t drop_solutions_where(SolveResult& result, Predicate is_dropped) {
  std::vector<bool> dropped;
  for (const Solution& solution : result.solutions) dropped.push_back(is_dropped(solution));
  std::erase_if(result.on_sets, is_dropped);
  return drop_solutions(result, dropped);
}

}  // namespace moivre
