// SPDX-License-Identifier: MIT
// Closures by the ranks of their Jacobians; the mobility of one of each kind.
#include "moivre/closures/mobility_kinds.h"

#include <functional>
#include <map>
#include <utility>

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
  if (result.moves) enter(result.moves->pose);
  std::vector<MobilityKind> found;
  for (auto& entry : kinds) {
    entry.second.mobility = mobility(phi, entry.second.q, result.time, fit);
    found.push_back(std::move(entry.second));
  }
  return found;
}

}  // namespace moivre
