// SPDX-License-Identifier: MIT
// The guess, the pose as drawn, then random poses around the guess; the first that moves is the
// witness.
#include "moving_pose.h"

#include <algorithm>
#include <numbers>

#include "moivre/kinematics/local_dimension.h"
#include "moivre/kinematics/newton.h"
#include "moivre/kinematics/own_units.h"
#include "moivre/numeric/random.h"

namespace moivre {

Eigen::VectorXd random_pose(const Phi& phi, const Eigen::VectorXd& guess, std::uint64_t seed,
                            std::uint64_t start, double share) {
  Eigen::VectorXd q = guess;
  const Eigen::VectorXd unit = phi.own_units();
  const double size = std::max(1.0, largest_of(phi, guess));
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const auto n = static_cast<std::uint64_t>(q.size());
    const auto index = start * n + static_cast<std::uint64_t>(k);
    const double wander = share * (2 * random_unit(seed, RandomStream::slice, index) - 1);
    q[k] += wander * (is_length(phi, k) ? size * unit[k] : std::numbers::pi);
  }
  return q;
}

std::optional<Moves> moves_at(const Phi& phi, const Eigen::VectorXd& q, double t,
                              std::uint64_t seed) {
  const LocalDimension local = local_dimension(phi, q, t, seed);
  if (local.dimension == 0) return std::nullopt;
  return Moves{static_cast<std::uint64_t>(local.dimension), local.shown, q};
}

std::optional<Moves> moving_pose(const Mechanism& mechanism, const Phi& phi, double t,
                                 std::uint64_t seed) {
  const Eigen::VectorXd guess = initial_guess(mechanism, t);
  const auto begin = [&](std::uint64_t start) -> Eigen::VectorXd {
    if (start == 0) return guess;
    if (start == 1) return Eigen::VectorXd::Zero(phi.dimension());
    return random_pose(phi, guess, seed, start);
  };
  for (std::uint64_t start = 0; start < kMovingStarts; ++start) {
    const NewtonResult found = newton(phi, begin(start), t);
    if (found.status != NewtonStatus::converged) continue;
    if (auto moves = moves_at(phi, phi.canonical(found.q), t, seed)) return moves;
  }
  return std::nullopt;
}

}  // namespace moivre
