// SPDX-License-Identifier: MIT
// Where do all roots of a block come from, above one partial root? From the first of its sources
// that has an answer there:
//
//   formula        it comes down to one quadratic equation, or to linear ones (quadratic_block.h)
//   least_squares  its equations are linear and contradict each other (linear_block.h): no root,
//                  and a pose may be near
//   family         paths from a start that the caller knows (ClosureOptions::starts)
//   theorem        paths from a general member of a class whose poses a theorem counts
//   solve          any paths
//
// What a source has spent without an answer is added to the one that has it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "moivre/closures/stages.h"
#include "moivre/solver/given_start.h"
#include "quadratic_block.h"

namespace moivre {

enum class BlockSourceKind { formula, least_squares, family, theorem, solve };

/// Solutions are points of the block's variables, in its order.
struct BlockRoots {
  BlockSourceKind by = BlockSourceKind::solve;
  bool complete = false;
  std::vector<Solution> solutions;
  std::vector<Solution> on_sets;
  PathCounts paths;  ///< a formula counts its roots as paths
  StartFacts start;
  SystemFacts reduced;
  std::optional<MetBound> bound;
  std::vector<FailedPath> failures;
  std::vector<LeftOut> left_out;
  StepCount work;
  SolveTime time;
};

class BlockSource {
 public:
  virtual ~BlockSource() = default;
  /// Of an answer that is none only work and time are told.
  virtual bool answer(const PartialRoot& root, BlockRoots& roots) = 0;
};

/// How many of a block's solutions above a root are proved poses.
using ProvedPoses =
    std::function<std::ptrdiff_t(const PartialRoot& root, const std::vector<Solution>& solutions)>;

class BlockSources {
 public:
  /// All but the last must outlive it. proved_poses: empty where nothing is proved.
  BlockSources(const Formulation& formulation, const Block& block, const BlockSolving& solving,
               const QuadraticBlock& formula, ProvedPoses proved_poses);

  BlockRoots roots_above(const PartialRoot& root);

 private:
  std::vector<std::unique_ptr<BlockSource>> sources_;
};

/// The block's equations in its variables, numbered in its order, with the known values put in.
System system_at(const System& all, const Block& block, const PartialRoot& root);

/// No more isolated poses than this are roots of the block.
std::optional<Formulation::Bound> bound_of(const Formulation& formulation, const Block& block);

}  // namespace moivre
