// SPDX-License-Identifier: MIT
// What are all roots of a system that is solved block by block? A tree of partial roots, one solve
// a block and partial root.
//
// A lone linear equation is solved exactly; other blocks by solve(), with the known values put in
// as exact numbers. Paths are numbered through each stage, solve after solve.
// Edges: a block with a set of roots of positive dimension adds what is isolated in it, and `moves`
// says so.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "moivre/closures/closures.h"
#include "moivre/closures/root_proofs.h"
#include "moivre/formulation/block_structure.h"

namespace moivre {

/// A number that is known, and what it is in double.
struct Known {
  explicit Known(Coefficient value) : exact(std::move(value)), rounded(to_complex(exact)) {}

  Coefficient exact;
  Complex rounded;
};

/// Null where it is not known yet. Roots of a block have the values of the blocks before it in
/// common.
using KnownValue = std::shared_ptr<const Known>;

/// A root of the blocks solved so far; a value that needed no solve is exact.
struct PartialRoot {
  std::vector<KnownValue> value;  ///< of each variable
  std::uint64_t path = 0;         ///< of the last stage
  std::uint64_t multiplicity = 1;
  bool singular = false;
  bool cluster = false;  ///< so many roots nearby, or one as often
  bool isolated =
      true;  ///< each block had it as a proved root, and was of the formulation's own numbers
  double accuracy = 0;   ///< largest of its stages
  double condition = 1;  ///< largest of its stages
  KnownProof proof;      ///< that it is one root and no other
};

struct StageRun {
  std::vector<PartialRoot> roots;  ///< with all blocks solved, by path
  std::vector<Stage> stages;
  PathCounts paths;
  StartFacts largest_start;  ///< of all solves, the one with the most paths
  std::vector<FailedPath> failures;
  std::vector<LeftOut> left_out;
  StepCount work;
  SolveTime time;
  bool complete = true;
  bool moves = false;     ///< a block had a set of roots of positive dimension
  bool may_move = false;  ///< so it had, above a partial root that may be real
  std::map<std::string, std::uint64_t> excluded;  ///< roots that are no pose, by the reason
  std::uint64_t rejected = 0;  ///< roots of parts, at which an equation of the whole fails
  /// Every root, the excluded ones too, is simple and proved, and they are as many as there can be.
  bool is_proved = true;
};

// A root of all equations leaves no more than this on the scale of the terms; those of spare
// equations that do not hold are larger by far.
inline constexpr double kHolds = 1e-8;
// Of a multiple root, which is known to the square root of that at best.
inline constexpr double kHoldsSingular = 1e-5;

/// p with the known values put in; `place` maps the other variables to those of the result.
Polynomial substituted(const Polynomial& p, const std::vector<KnownValue>& value,
                       const std::vector<std::uint32_t>& place);

// From this condition on rounding of the coefficients moves a root as far as it likes: products of
// a dozen frames are right to 45 bits.
inline constexpr double kUndetermined = 0x1p45;

/// The most that a known value differs from its image, beside the largest of them and 1.
double distance_from_image(const Formulation& formulation, const PartialRoot& root);

/// False where the image of a value that is known differs from it.
bool may_be_real(const Formulation& formulation, const PartialRoot& root);

/// Rounding of frames, or in redundant equations of the file's numbers, moves roots.
bool is_rounded(const Formulation& formulation);

/// Whether a root's condition is that of a multiple root which rounding has parted: m roots within
/// a gap have a condition of its power m - 1, `product`. On a set rounding leaves roots anywhere.
bool is_of_parted(double condition, double product);

/// 0 where a value is not known.
Point known_values(const PartialRoot& root);

/// Those of the equations all of whose unknowns are known, in their order.
std::vector<std::size_t> of_known_alone(const Formulation& formulation, const PartialRoot& root,
                                        const std::vector<std::size_t>& equations);

/// Of the terms of an equation, at its roots: what rounding leaves of the solution alone, or of a
/// file's numbers and of what frames are made of.
double rounding_left(const Formulation& formulation);

/// Adds the seconds of starting, tracking and refining: what solves one after another have in
/// common.
void add_solving(const SolveTime& part, SolveTime& sum);

/// With what blocks are solved.
struct BlockSolving {
  const Tracker& tracker;
  const SolveOptions& options;
  KnownStarts* starts;  ///< ClosureOptions::starts
  const std::atomic<bool>& stop;
  bool with_fine_values = false;  ///< proved roots in more digits than double's, for blocks above
};

/// Solves the blocks in turn, and proves their roots where the prover does. `begun`: what is known
/// before. `whole`: of the same unknowns, all equations that a pose has to satisfy. A root of the
/// first blocks that is not real and at which one of them fails is taken away as soon as its
/// unknowns are known; with lengths that are off by much, as a fit allows, a pose may be near.
StageRun solve_blocks(const Formulation& formulation, const std::vector<Block>& blocks,
                      const BlockSolving& solving, RootProver& prover, PartialRoot begun = {},
                      const Formulation* whole = nullptr);

}  // namespace moivre
