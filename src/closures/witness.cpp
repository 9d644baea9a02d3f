// SPDX-License-Identifier: MIT
// Starts of Newton-Raphson after the answer, and what they come to.
#include "witness.h"

#include <algorithm>

#include "closure_poses.h"
#include "fitted_poses.h"
#include "moivre/closures/drawn_closure.h"
#include "moivre/closures/same_pose.h"
#include "moivre/mechanism/drawn_pose.h"
#include "moivre/mechanism/pose.h"
#include "moving_pose.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

// A handful: what a wrong answer lacks is met by one of a few.
constexpr std::uint64_t kRandomStarts = 4;
constexpr std::uint64_t kNeighbours = 3;
// A run takes as long as so many steps of a tracker; all of them are to cost no more than a tenth
// of the answer.
constexpr std::uint64_t kStepsOfRun = 20;
constexpr std::uint64_t kShareOfRuns = 10;
// What comes to a closure at all does so in fewer iterations; the others wander.
constexpr int kMostIterations = 15;
// Of the size of the pose, and of half a turn: out of the closure's own neighbourhood, not yet
// anywhere.
constexpr double kBeside = 0.2;

/// Poses from which to look, the likeliest first: of an answer by formula one, of one that took
/// many steps more. Where a proof says that there is no other closure, what was drawn is looked at
/// alone: the proof is about polynomials.
std::vector<VectorXd> starts_of(const ClosureSearch& search) {
  const Phi& phi = search.phi;
  const double t = search.options.time;
  const std::uint64_t seed = search.options.solve.seed;
  if (search.result.completeness == RootCompleteness::proved) {
    if (!is_drawn_at(search.mechanism, t)) return {};
    return {VectorXd::Zero(phi.dimension())};
  }
  // The drawn pose is the guess, where it closes.
  const VectorXd guess = initial_guess(search.mechanism, t);
  std::vector<VectorXd> starts{guess};
  const std::uint64_t runs = search.result.work.accepted / (kStepsOfRun * kShareOfRuns);
  // Behind those of moving_pose().
  std::uint64_t number = kMovingStarts;
  const std::uint64_t random_starts = std::min(kRandomStarts, runs);
  for (std::uint64_t k = 0; k < random_starts; ++k) {
    starts.push_back(random_pose(phi, guess, seed, number++));
  }
  const auto& closures = search.result.closures;
  const std::uint64_t beside =
      std::min<std::uint64_t>({kNeighbours, runs - random_starts, closures.size()});
  for (std::uint64_t k = 0; k < beside; ++k) {
    const Closure& near = closures[k * closures.size() / beside];
    starts.push_back(random_pose(phi, near.q, seed, number++, kBeside));
  }
  return starts;
}

bool is_listed(const ClosureSearch& search, const VectorXd& q) {
  const auto& closures = search.result.closures;
  return std::any_of(closures.begin(), closures.end(), [&](const Closure& closure) {
    return is_same_pose(search.phi, closure.q, q);
  });
}

}  // namespace

void mark_drawn(ClosureSearch& search) {
  const auto drawn = drawn_closure(search.mechanism, search.phi, search.options.time);
  if (!drawn) return;
  for (Closure& closure : search.result.closures) {
    closure.is_drawn = is_same_pose(search.phi, closure.q, *drawn);
    if (closure.is_drawn) return;
  }
  if (!search.mechanism.fit) return;
  for (Closure& closure : search.result.closures) {
    closure.is_drawn = hang_together(search, *drawn, closure.q);
    if (closure.is_drawn) return;
  }
}

void look_for_witnesses(ClosureSearch& search) {
  const ClosureResult& result = search.result;
  if (search.stop || result.moves) return;
  look_for_fitted(search);
  letter(search.result.closures, search.phi);
  if (!result.complete) {
    // That something is missing is said already.
    search.rootless = 0;
    return;
  }
  // Of a set that was taken for isolated closures what is listed is singular.
  for (const Closure& closure : result.closures) {
    if (closure.singular && !search.mechanism.fit && lies_on_motion(search, closure.q)) return;
  }
  const bool has_found = result.counts.real + result.counts.fitted > 0;
  NewtonOptions options;
  options.maximum_iterations = kMostIterations;
  for (const VectorXd& start : starts_of(search)) {
    const NewtonResult pose = newton(search.phi, start, search.options.time, options);
    if (!pose.q.allFinite()) continue;
    const VectorXd q = search.phi.canonical(pose.q);
    if (is_listed(search, q)) continue;
    if (pose.status == NewtonStatus::no_solution && !has_found) {
      note_misfit(search, closure_at(search, pose));
    }
    if (pose.status != NewtonStatus::converged) continue;
    // Within a fit a pose is singular that stands alone as typed, unless it closes as typed.
    const bool may_move = !search.mechanism.fit || closes(search, pose);
    if (pose.is_singular && may_move && lies_on_motion(search, q)) return;
    if (!shows_a_loss(search, pose)) continue;
    ++search.rootless;
    return;
  }
}

}  // namespace moivre
