// SPDX-License-Identifier: MIT
// Newton-Raphson from the drawn pose.
#include "moivre/closures/drawn_closure.h"

#include "moivre/kinematics/newton.h"
#include "moivre/mechanism/drawn_pose.h"

namespace moivre {

std::optional<Eigen::VectorXd> drawn_closure(const Mechanism& mechanism, const Phi& phi, double t) {
  if (!is_drawn_at(mechanism, t)) return std::nullopt;
  const NewtonResult pose = newton(phi, Eigen::VectorXd::Zero(phi.dimension()), t);
  if (!pose.q.allFinite()) return std::nullopt;
  return phi.canonical(pose.q);
}

}  // namespace moivre
