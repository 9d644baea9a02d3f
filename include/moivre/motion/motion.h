// SPDX-License-Identifier: MIT
// How does every closure of a mechanism move while the drivers move, and is no branch exchanged for
// another?
//
// All closures at `from` are followed along the drivers (kinematics/branch.h). At checkpoints the
// closures are solved again, and must match the branches one to one:
//   two branches at one closure   followed again with shorter steps, and so is a branch that has
//                                 another one's closure
//   a closure without a branch    a branch began since the last checkpoint: it is followed both
//                                 ways and gets a new id
//   a branch without a closure    the solver lost a closure; `failures` says so
// Two branches that were exchanged for each other would match too. So each one is followed back
// from its last checkpoint to where it was found, with other steps, and must pass through the same
// closures.
// If a branch ends at a dead point, the other branch there is found by following the curve around
// the fold.
// Ids do not change during the motion: A, B, ... as find_closures gives them at `from`, then new
// ones as branches begin.
// If closures are complex, a branch could begin and end unseen between two checkpoints. So closures
// are solved between any two neighbouring events, and complex ones are followed to where they
// become real, however briefly. Where they cannot be followed, or limits hide closures, these are
// solved 16 times between checkpoints. A pose that exists for an instant only is not a branch.
// `left_out` says of both. The scenes in between are checkpoints of the result, too.
// Sub-chains that share no more than what the drivers place (sub_chains.h) are followed each on its
// own: a branch of the whole is one of each, from where the last of them begins to where the first
// ends. They are listed up to kMostBranchesListed. Of more, one for each branch of a sub-chain is
// listed, and circuits are told of each sub-chain alone.
// Not supported: what find_closures does not support. follow_guesses takes those mechanisms and
// solves no polynomials.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "moivre/closures/closures.h"
#include "moivre/kinematics/branch.h"

namespace moivre {

/// The function that follows a branch: follow_branch, or another one in a test.
using FollowBranch =
    std::function<Branch(const Mechanism&, const Eigen::VectorXd&, const std::vector<double>&,
                         const BranchOptions&, const std::atomic<bool>&)>;

struct MotionOptions {
  double from = 0;      ///< seconds
  double to = 1;        ///< seconds; after `from`
  int steps = 100;      ///< samples are at from + k (to - from) / steps, k = 0 .. steps
  int checkpoints = 4;  ///< evenly spaced after `from`, the last at `to`; 0: none after `from`
  BranchOptions branch;
  FollowBranch follow = follow_branch;
  SolveOptions solve;  ///< of the closures, at `from` and at every checkpoint
  /// Closures of independent sub-chains that are listed in any case, though there are more than
  /// kMostBranchesListed: "G.H.C.B" has one of each. So is the one that was drawn.
  std::vector<std::string> asked;
  /// Called with the share of the work that is done, in [0, 1]; may be empty.
  std::function<void(double)> progress;
};

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const MotionOptions& options);

/// Throws std::invalid_argument with every broken rule, or where a driver has no value at `from` or
/// `to`.
void require_workable(const Mechanism& mechanism, const MotionOptions& options);

struct MotionBranch {
  std::string id;
  std::vector<BranchSample> samples;  ///< by time, at the output times within [begins, ends]
  double begins = 0;                  ///< seconds
  double ends = 0;
  Eigen::VectorXd begin_pose;  ///< q there; angles go on from it to the samples
  Eigen::VectorXd end_pose;
  /// Its curve from the pose in which it was found: back to its beginning, and forward to its end.
  std::array<std::vector<BranchPiece>, 2> ways;
  std::optional<std::size_t> begin_event;  ///< index into MotionResult::events; nullopt: at `from`
  std::optional<std::size_t> end_event;    ///< nullopt: at `to`, or not followed further
  bool complete = false;                   ///< followed to `to` or to an event
  std::string message;                     ///< how it ended, a sentence
  int steps = 0;                           ///< of the follower
  int retracked = 0;                       ///< how often it was followed again with shorter steps
  std::vector<std::string> of;  ///< of independent sub-chains: the id of each one's branch
};

/// Branches that end or begin at one place.
struct MotionEvent {
  BranchEvent at;
  std::vector<double> drivers;      ///< values, in the order of Mechanism::drivers
  std::vector<std::string> ending;  ///< ids
  std::vector<std::string> beginning;
};

/// The message of a checkpoint that was not reached before the run was stopped.
inline constexpr const char* kNotCompared = "interrupted before it was compared";

/// Closures solved again, and the branches that are there.
struct Checkpoint {
  double time = 0;
  std::vector<double> drivers;
  ClosureCounts counts;
  PathCounts paths;
  std::vector<std::string>
      branches;         ///< ids, one a real closure, in the closures' order; "" without a branch
  bool agrees = false;  ///< one to one; false also where it was not compared
  std::string message;
};

struct MotionSubChain;

struct MotionResult {
  bool complete = false;
  std::string message = "find_motion() was not run";
  std::uint64_t seed = 0;
  double from = 0;
  double to = 0;
  std::vector<double> times;  ///< of the samples
  std::string tracker;        ///< empty: no polynomials were solved
  OptionsInForce tracker_options;
  std::vector<MotionBranch> branches;   ///< in the order of their ids
  std::vector<MotionEvent> events;      ///< by time
  std::vector<Checkpoint> checkpoints;  ///< by time; the first is `from`
  PathCounts paths;                     ///< over all closures solved
  std::vector<std::string> failures;    ///< each a sentence
  std::vector<IdleJoint> idle;
  std::vector<LeftOut> left_out;
  std::vector<MotionSubChain> sub_chains;  ///< two or more, or none: then the whole was followed
  bool all_listed = true;                  ///< false: branches are more than kMostBranchesListed
  std::string drawn;  ///< id of the branch that is in the drawn pose at `from`; empty: none is
  int steps = 0;      ///< of the follower, all branches
  int rejected = 0;
  SolveTime time_s;
};

/// So many branches of independent sub-chains are put together, each with all its samples.
inline constexpr std::size_t kMostBranchesListed = 256;

/// One of several independent sub-chains, followed on its own.
struct MotionSubChain {
  IndependentChain chain;
  MotionResult motion;  ///< of chain.mechanism
};

/// Value of each driver.
std::vector<double> driver_values(const Mechanism& mechanism, double time);

/// The time that shows the whole motion from `from` on: one turn of the first driver if it turns by
/// a parabola, the rest of its table, else 1 s.
double natural_duration(const Mechanism& mechanism, double from = 0);

/// Throws std::invalid_argument where the mechanism or the options are not supported, before any
/// tracking.
MotionResult find_motion(const Mechanism& mechanism, const Tracker& tracker,
                         const MotionOptions& options = {},
                         const std::atomic<bool>& stop = std::atomic<bool>{false});

/// The same from given guesses at `from`, each assembled by Newton-Raphson first. Equations need
/// not be polynomials. No closures are solved, so there are no checkpoints.
MotionResult follow_guesses(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& guesses,
                            const MotionOptions& options = {},
                            const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
