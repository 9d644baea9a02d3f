// SPDX-License-Identifier: MIT
// In which poses can a mechanism be assembled? All closures at the drivers' time t, none missing,
// by homotopy continuation.
//
// Closure polynomials (formulation/formulation.h) -> blocks (Assur groups) solved one after
// another, once for every root of the blocks before -> roots that satisfy every equation -> the
// real ones -> q -> Newton-Raphson on Phi(q, t).
// The counts of paths add up in every stage, as in solver/solve.h. Roots that fail a redundant
// equation are `rejected`.
// "Cannot be assembled" (no real closure) and "moves" (a curve of closures with the drivers held)
// are possible answers. The former is not given where Newton-Raphson assembles the guess or the
// pose as drawn.
// A regular root is proved by certificates (src/closures/root_proofs.h): that it is one root, and
// that it is real. So is whether a root is no pose. Where there are more equations than unknowns
// the spare ones hold to some digits only, and there is no proof.
// An isolated multiple closure (a dead point) is singular and does not move.
// Sub-chains that share no more than what the drivers place (sub_chains.h) are solved each on its
// own: closures of the whole are one of each, and are listed up to kMostListed of them.
// Where a file is typed from one drawing, the closure that was drawn is marked, and it is always
// listed.
// After the answer a few local searches look for a closure that is not in it
// (src/closures/witness.h): one found is a contradiction.
// Closures get letters by their poses: larger first coordinate first, ties by the next one.
// In a block after a complex root of another block, conjugates come from the block's own unknowns
// pb and u.
// Not supported: typed equations that are not polynomials (std::invalid_argument with the reason).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "moivre/kinematics/mobility.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/solver/solve.h"

namespace moivre {

class KnownStarts;

struct ClosureOptions {
  double time = 0;  ///< of the drivers, seconds
  SolveOptions solve;
  /// Asked for the start of each group of bodies before another one is looked for. Not owned, may
  /// be nullptr.
  KnownStarts* starts = nullptr;
  /// Roots by proof, where solve.certify says so too and the program has digits beyond double.
  bool certify = true;
  bool with_mobility = false;  ///< ClosureResult::mobility
};

/// One group of bodies, solved once for every solution of the groups before it.
struct Stage {
  std::string group;
  std::uint64_t solves = 0;
  PathCounts paths;     ///< over all its solves
  SystemFacts reduced;  ///< what was tracked
};

/// A pose of the assembled mechanism.
struct Closure {
  std::string
      id;  ///< A, B, ..., Z, AA, ... by pose: the same for every seed, tracker and thread count
  Eigen::VectorXd q;
  double residual = 0;  ///< residual_by_size (mechanism/phi.h)
  double misfit = 0;    ///< by how much it does not close, in the file's unit of length
  bool is_fitted =
      false;  ///< it closes only within Mechanism::fit: least squares, no root of the polynomials
  /// Under Mechanism::fit: how far from q poses reach that are within it and hang together with q,
  /// in radians or of the pose's size.
  std::optional<double> play;
  int newton_iterations = 0;
  double smallest_singular_value = 0;  ///< of Phi_q
  std::uint64_t path = 0;              ///< of the last stage
  std::uint64_t multiplicity = 1;
  bool singular = false;
  bool cluster = false;  ///< so many closures nearby, or one as often: no exact algebra has told
  /// The root is proved to be one, a simple one, and real. nullopt: not asked for, or not possible
  /// since there are more equations than unknowns, or fewer.
  std::optional<bool> certified;
  std::vector<std::string> of;  ///< of independent sub-chains: the id of each one's closure
  bool is_drawn = false;        ///< Newton-Raphson comes to it from the drawn pose, q = 0
};

struct ClosureCounts {
  std::uint64_t complex = 0;  ///< isolated closures, the real ones among them
  std::uint64_t real = 0;
  std::uint64_t filtered = 0;  ///< of the real ones: outside a joint's limits
  std::uint64_t rejected = 0;  ///< roots of the solved equations that fail a redundant one
  std::uint64_t fitted =
      0;  ///< closures within limits and within Mechanism::fit only; none of the above
};

/// Of independent sub-chains: closures of the whole are one of each. Counts stop at 2^64 - 1.
ClosureCounts product_of(const std::vector<ClosureCounts>& parts);

/// A set of closures of positive dimension, with the drivers held.
struct Moves {
  std::uint64_t dimension = 0;  ///< at `pose`
  std::string shown;            ///< how (kinematics/local_dimension.h)
  Eigen::VectorXd pose;         ///< q of one of them
};

/// An idle degree of freedom: nothing else depends on it.
struct IdleJoint {
  std::string body;   ///< that moves alone, with everything that hangs on it
  std::string joint;  ///< across which it moves, by name
  std::string held;   ///< how it is held, a clause
};

/// A part that shares with the others only what the drivers place (sub_chains.h).
struct IndependentChain {
  Mechanism mechanism;  ///< its bodies behind the placed ones' places, in the order of the whole
  std::vector<std::string> bodies;  ///< its own, without the placed ones
  std::vector<Eigen::Index>
      coordinates;  ///< of each of its coordinates: which of the whole's it is
};

/// One of several independent sub-chains, solved on its own.
struct SubChain {
  IndependentChain chain;
  ClosureCounts counts;
  PathCounts paths;
  std::vector<Closure> closures;  ///< q: of chain.mechanism; ids of its own
};

/// So many closures of independent sub-chains are listed one by one. Of more, one for each closure
/// of a sub-chain is, the others standing in their first.
inline constexpr std::uint64_t kMostListed = 1024;

struct ClosureResult {
  bool complete = false;
  std::string message = "find_closures() was not run";
  std::uint64_t seed = 0;
  double time = 0;
  SystemFacts system;
  SystemFacts reduced;  ///< of all stages together
  StartFacts start;
  std::string tracker;
  OptionsInForce tracker_options;
  PathCounts paths;  ///< over all stages
  std::vector<Stage> stages;
  std::vector<Solution> solutions;  ///< complex closures in `system`'s variables; real: a pose
  ClosureCounts counts;
  /// proved: every root is, and each block has as many as a proved bound allows. shown: every path
  /// was decided, and every regular root is certified. nullopt: as for Closure::certified.
  std::optional<RootCompleteness> completeness;
  std::optional<Moves> moves;
  std::vector<Closure> closures;  ///< real, within limits, by id
  std::vector<SubChain>
      sub_chains;          ///< two or more, or none: then the mechanism was solved as a whole
  bool all_listed = true;  ///< false: closures or solutions are more than kMostListed
  /// Where it was asked for: at the first closure; where there is none at moves->pose, or where the
  /// rank is higher next to it on the set.
  std::optional<ConstraintRank> mobility;
  Eigen::Index coordinates = 0;  ///< n
  Eigen::Index constraints = 0;  ///< m, without drivers
  std::vector<FailedPath> failures;
  std::vector<LeftOut> left_out;
  std::vector<IdleJoint> idle;         ///< held, so that the others have isolated closures
  std::optional<double> least_misfit;  ///< of poses that do not close, in the file's unit of length
  std::string misses_most;             ///< the row of Phi that misses by this
  std::uint64_t fitted_beyond_limits = 0;  ///< poses within Mechanism::fit, in none of the counts
  StepCount work;
  SolveTime time_s;
};

/// Adds what is not yet said.
void add_left_out(const std::vector<LeftOut>& part, std::vector<LeftOut>& whole);

/// Throws std::invalid_argument where the mechanism is not supported, before any tracking.
ClosureResult find_closures(const Mechanism& mechanism, const Tracker& tracker,
                            const ClosureOptions& options = {},
                            const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
