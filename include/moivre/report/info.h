// SPDX-License-Identifier: MIT
// What is the structure of a system, and how many paths would a solve follow? Solves nothing.
//
// As solve() prepares it: eliminated, then scaled. Edges: a system that is not square has no start
// system's paths, but a verdict.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "moivre/solver/solve.h"
#include "moivre/start/mixed_cells.h"

namespace moivre {

/// A start system and what it would cost.
struct StartCost {
  StartSource source = StartSource::total_degree;
  std::optional<std::uint64_t> paths;  ///< nullopt: beyond 64 bits, or the system cannot be solved
  std::string why;
};

struct SystemInfo {
  SystemFacts system;
  std::uint64_t equations = 0;
  std::uint64_t terms = 0;
  bool real = false;                    ///< every coefficient is
  bool homogeneous = false;             ///< every polynomial is
  std::vector<std::string> conditions;  ///< that stand among the equations
  std::string verdict;  ///< of elimination: square, solved, inconsistent, dependent, ...
  SystemFacts reduced;  ///< what would be tracked
  std::uint64_t reduced_terms = 0;
  std::vector<int> variable_log2;  ///< scaling of what would be tracked
  std::vector<int> equation_log2;
  std::vector<StartCost> start_systems;
  StartCounts counts;  ///< of what would be tracked, where there is something
  std::vector<LeftOut> left_out;
};

/// stop: once set, what is not known yet is missing. progress: of the search for mixed cells; may
/// be empty.
struct InspectOptions {
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const CellSearchProgress&)> progress = {};
};

/// Any system, square or not.
SystemInfo inspect(const System& f, const InspectOptions& options = {});

std::string info_text(const SystemInfo& info, const std::string& file);
std::string info_json(const SystemInfo& info, const std::string& file);

}  // namespace moivre
