// SPDX-License-Identifier: MIT
// Which start has the paths that take the least time? A plan, the counts of all that were computed,
// and the reason.
//
//   total-degree       the product of the degrees; nothing needs to be searched
//   multihomogeneous   the best partition found (start/multihomogeneous.h), at most the total
//                      degree
//   polyhedral         the mixed volume with 0 added, at most any multihomogeneous number; two
//                      stages a path
//
// automatic: the least expected time, in units of one path of one stage to a finite root,
//
//     one stage:   M + kInfinityCost (paths - M)      M: mixed volume, which bounds the roots; the
//                  other paths go to infinity
//     polyhedral:  kPolyhedralCost M
//
// If a generic member has roots at infinity (start/infinity.h), mixed cells are sought until the
// search has cost as much as the paths of the best other start. The constants were fitted on a
// corpus (decision 18).
// Edges: a start that is not possible (a count beyond 64 bits, G with too many terms) is left out,
// with the reason. If none is possible: std::overflow_error. A start requested by name is refused
// with the reason (std::invalid_argument).
#pragma once

#include <atomic>
#include <functional>

#include "moivre/start/mixed_cells.h"
#include "moivre/start/start_kind.h"
#include "moivre/start/start_plan.h"

namespace moivre {

struct StartChoiceOptions {
  StartKind kind = StartKind::automatic;
  std::uint64_t seed = 1;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const CellSearchProgress&)> progress;
};

struct ChosenStart {
  std::optional<StartPlan> plan;  ///< nullopt where the search for cells was interrupted
  StartCounts counts;
  std::string why;
};

/// f: n polynomials in n variables (std::invalid_argument otherwise).
ChosenStart choose_start(const System& f, const StartChoiceOptions& options);

/// Multiply-adds that this number of paths is expected to cost.
double cost_of_paths(const System& f, std::uint64_t paths);

/// The number of search steps that cost as much as this number of paths
/// (CellSearchOptions::most_steps).
std::uint64_t search_steps_for(const System& f, std::uint64_t paths);

/// All counts, each as far as a bounded search gets.
StartCounts count_starts(const System& f, const StartChoiceOptions& options);

}  // namespace moivre
