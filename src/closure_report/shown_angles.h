// SPDX-License-Identifier: MIT
// How are a sample's coordinates shown: each angle in (-pi, pi], or going on from where the branch
// begins?
//
// A branch's own angles go on. Where they begin is a matter of whole turns: a body that a driver
// turns begins at the driver's value, turns included, so that branches which begin later lie on the
// same line; others begin in (-pi, pi].
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "moivre/closure_report/angles.h"
#include "moivre/motion/motion.h"

namespace moivre {

/// Whole turns, in radians, by coordinate: with them the angles of a branch that begins at q, t,
/// begin where they are to be shown.
inline Eigen::VectorXd turns_to_begin(const Mechanism& mechanism, const Eigen::VectorXd& q,
                                      double t) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const std::vector<Coordinate> all = coordinates(mechanism);
  const auto is_turned = [](const Driver& driver, std::size_t group) {
    if (driver.kind == DriverKind::unknown) return driver.unknown == group;
    return driver.kind == DriverKind::angle && driver.bodies[0] == 0 &&
           driver.bodies[1] == group + 1;
  };
  Eigen::VectorXd turns = Eigen::VectorXd::Zero(q.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!all[k].is_periodic) continue;
    const auto i = static_cast<Eigen::Index>(k);
    turns[i] = -kTurn * std::ceil((q[i] - std::numbers::pi) / kTurn);
    for (const Driver& driver : mechanism.drivers) {
      if (!is_turned(driver, all[k].group)) continue;
      turns[i] = kTurn * std::round((driver_state(driver.law, t).value - q[i]) / kTurn);
    }
  }
  return turns;
}

/// Of a branch; empty where it has no samples.
inline Eigen::VectorXd turns_to_begin(const Mechanism& mechanism, const MotionBranch& branch) {
  if (branch.samples.empty()) return {};
  return turns_to_begin(mechanism, branch.samples.front().q, branch.samples.front().time);
}

/// turns: turns_to_begin() of the sample's branch.
inline Eigen::VectorXd shown(const Phi& phi, const BranchSample& sample, const AngleForm& form,
                             const Eigen::VectorXd& turns) {
  return form.goes_on ? sample.q + turns : phi.canonical(sample.q);
}

}  // namespace moivre
