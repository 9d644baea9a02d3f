// SPDX-License-Identifier: MIT
// Starts of Newton-Raphson after the answer, and what they come to.
#include "witness.h"

#include <algorithm>

#include "closure_poses.h"
#include "moivre/closures/drawn_closure.h"
#include "moivre/closures/same_pose.h"
#include "moivre/mechanism/drawn_pose.h"
#include "moivre/mechanism/pose.h"
#include "moving_pose.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

// A handful: what a wrong answer lacks is met by one of a few, and they cost less than a tenth of what it took.
constexpr std::uint64_t kRandomStarts = 4;
constexpr std::size_t kNeighbours = 3;
// Of the size of the pose, and of half a turn: out of the closure's own neighbourhood, not yet anywhere.
constexpr double kBeside = 0.2;

/// Poses from which to look, the likeliest first.
std::vector<VectorXd> starts_of(const ClosureSearch& search) {
  const Phi& phi = search.phi;
  const double t = search.options.time;
  const std::uint64_t seed = search.options.solve.seed;
  std::vector<VectorXd> starts;
  if (is_drawn_at(search.mechanism, t)) starts.emplace_back(VectorXd::Zero(phi.dimension()));
  const VectorXd guess = initial_guess(search.mechanism, t);
  starts.push_back(guess);
  // Behind those of moving_pose().
  std::uint64_t number = kMovingStarts;
  for (std::uint64_t k = 0; k < kRandomStarts; ++k) {
    starts.push_back(random_pose(phi, guess, seed, number++));
  }
  const auto& closures = search.result.closures;
  const std::size_t count = std::min(kNeighbours, closures.size());
  for (std::size_t k = 0; k < count; ++k) {
    const Closure& near = closures[k * closures.size() / count];
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

/// Whether least squares came to a pose that Mechanism::fit accepts.
bool fits(const ClosureSearch& search, const NewtonResult& pose, const VectorXd& q) {
  const auto& fit = search.mechanism.fit;
  return fit && pose.status == NewtonStatus::no_solution && !pose.is_singular &&
         misfit(search.phi, q, search.options.time) <= *fit && !broken_limit(search.mechanism, q);
}

}  // namespace

void mark_drawn(ClosureSearch& search) {
  const auto drawn = drawn_closure(search.mechanism, search.phi, search.options.time);
  if (!drawn) return;
  for (Closure& closure : search.result.closures) {
    closure.is_drawn = is_same_pose(search.phi, closure.q, *drawn);
    if (closure.is_drawn) return;
  }
}

void look_for_witnesses(ClosureSearch& search) {
  const ClosureResult& result = search.result;
  if (!result.complete || search.stop || result.moves) return;
  const bool has_found = result.counts.real + result.counts.fitted > 0;
  for (const VectorXd& start : starts_of(search)) {
    const NewtonResult pose = newton(search.phi, start, search.options.time);
    if (!pose.q.allFinite()) continue;
    const VectorXd q = search.phi.canonical(pose.q);
    if (is_listed(search, q)) continue;
    if (fits(search, pose, q)) {
      ++search.rootless;
      return;
    }
    if (pose.status == NewtonStatus::no_solution && !has_found) {
      note_misfit(search, closure_at(search, pose));
    }
    if (pose.status != NewtonStatus::converged) continue;
    if (pose.is_singular && !has_found && !search.mechanism.fit && lies_on_motion(search, q)) {
      return;
    }
    if (!shows_a_loss(search, pose)) continue;
    ++search.rootless;
    return;
  }
}

}  // namespace moivre
