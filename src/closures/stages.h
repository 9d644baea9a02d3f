// SPDX-License-Identifier: MIT
// What are all roots of a system that is solved block by block? A tree of branches, one solve a block and branch.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "block_structure.h"
#include "moivre/closures/closures.h"

namespace moivre {

/// A root of the blocks solved so far; a value that needed no solve is exact.
struct Branch {
  std::vector<std::optional<Coefficient>> value;  ///< of each variable
  std::uint64_t path = 0;                         ///< of the last stage
  std::uint64_t multiplicity = 1;
  bool singular = false;
  double accuracy = 0;   ///< largest of its stages
  double condition = 1;  ///< largest of its stages
};

struct StageRun {
  std::vector<Branch> branches;  ///< with all blocks solved, by path
  std::vector<Stage> stages;
  PathCounts paths;
  std::vector<FailedPath> failures;
  std::vector<LeftOut> left_out;
  StepCount work;
  SolveTime time;
  bool complete = true;
  bool moves = false;  ///< a block had a set of roots of positive dimension
};

/// Solves the blocks in turn.
StageRun solve_blocks(const IsotropicSystem& isotropic, const std::vector<Block>& blocks,
                      const Tracker& tracker, const SolveOptions& options,
                      const std::atomic<bool>& stop);

}  // namespace moivre
