// SPDX-License-Identifier: MIT
// Closures by the ranks of their Jacobians; the mobility of one of each kind.
#include "moivre/closures/mobility_kinds.h"

#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include "moivre/kinematics/local_dimension.h"
#include "moivre/kinematics/own_units.h"

namespace moivre {
namespace {

/// Of the joints, and of joints and drivers.
using Ranks = std::pair<Eigen::Index, Eigen::Index>;

Ranks ranks_at(const Phi& phi, const Eigen::VectorXd& q, double t, double tolerance) {
  const Eigen::MatrixXd J = phi.jacobian(q, t);
  return {rank_of(phi, J.topRows(J.rows() - phi.driver_size()), tolerance),
          rank_of(phi, J, tolerance)};
}

/// Of the closures; none where the mechanism is spatial or has none by solving.
std::vector<MobilityKind> kinds_at(const Mechanism& mechanism, const Tracker& tracker, double t,
                                   const std::atomic<bool>& stop) {
  if (mechanism.space == Space::spatial) return {};
  ClosureOptions options;
  options.time = t;
  options.certify = false;
  try {
    return mobility_kinds(mechanism, find_closures(mechanism, tracker, options, stop));
  } catch (const std::invalid_argument&) {
    return {};  // equations that are no polynomials have Newton-Raphson's pose
  }
}

}  // namespace

std::vector<MobilityKind> mobility_kinds(const Mechanism& mechanism, const ClosureResult& result) {
  const Phi phi(mechanism);
  const double fit = mechanism.fit.value_or(0);
  const double tolerance = rank_tolerance(phi.without_drivers(), fit);
  std::map<Ranks, MobilityKind, std::greater<>> kinds;
  const auto enter = [&](const Eigen::VectorXd& q) -> MobilityKind& {
    const auto [entry, is_new] = kinds.try_emplace(ranks_at(phi, q, result.time, tolerance));
    if (is_new) entry->second.q = q;
    return entry->second;
  };
  for (const Closure& closure : result.closures) enter(closure.q).closures.push_back(closure.id);
  if (result.moves) {
    const Eigen::VectorXd& q = result.moves->pose;
    enter(generic_pose(phi, q, result.time, result.seed));
    enter(q);
  }
  std::vector<MobilityKind> found;
  for (auto& entry : kinds) {
    entry.second.mobility = mobility(phi, entry.second.q, result.time, fit);
    found.push_back(std::move(entry.second));
  }
  return found;
}

FoundMobility find_mobility(const Mechanism& mechanism, const Tracker& tracker, double t,
                            const std::optional<Eigen::VectorXd>& guess,
                            const std::atomic<bool>& stop) {
  FoundMobility found;
  if (!guess && mechanism.guess.empty()) {
    found.kinds = kinds_at(mechanism, tracker, t, stop);
  }
  const Phi phi(mechanism);
  const Eigen::VectorXd begin =
      found.kinds.empty() ? guess.value_or(initial_guess(mechanism, t)) : found.kinds.front().q;
  found.pose = newton(phi, begin, t);
  found.mobility = found.kinds.empty() ? mobility(phi, found.pose.q, t, mechanism.fit.value_or(0))
                                       : found.kinds.front().mobility;
  return found;
}

}  // namespace moivre
