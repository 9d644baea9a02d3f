// SPDX-License-Identifier: MIT
// The rows of each joint, and of the drivers, at q = 0.
#include "moivre/mechanism/drawn_pose.h"

#include <cstdio>

#include "constraint.h"
#include "moivre/mechanism/phi.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

// Of the mechanism's largest length: what is typed with three digits misses by less.
constexpr double kTyped = 1e-2;

VectorXd misfits_of_rows(const Phi& phi, double t) {
  return row_misfits(phi, VectorXd::Zero(phi.dimension()), t);
}

}  // namespace

std::vector<double> drawn_misfits(const Mechanism& mechanism) {
  const VectorXd rows = misfits_of_rows(Phi(mechanism).without_drivers(), 0);
  std::vector<double> misfits;
  auto first = static_cast<Eigen::Index>(mechanism.equations.size());
  for (const Joint& joint : mechanism.joints) {
    const auto count = static_cast<Eigen::Index>(joint_constraint(mechanism, joint)->labels.size());
    const auto own = rows.segment(first, count);
    misfits.push_back(count == 0 ? 0 : own.maxCoeff());
    first += count;
  }
  return misfits;
}

bool is_drawn(const Mechanism& mechanism) {
  if (is_typed(mechanism)) return false;
  const Phi joints = Phi(mechanism).without_drivers();
  const VectorXd rows = misfits_of_rows(joints, 0);
  return (rows.array() <= kTyped * joints.length()).all();
}

bool is_drawn_at(const Mechanism& mechanism, double t) {
  if (is_typed(mechanism)) return false;
  const Phi phi(mechanism);
  return (misfits_of_rows(phi, t).array() <= kTyped * phi.length()).all();
}

std::string drawn_miss(const Mechanism& mechanism, double t) {
  if (is_typed(mechanism)) return "typed equations have none";
  const Phi phi(mechanism);
  Eigen::Index worst = 0;
  const double miss = misfits_of_rows(phi, t).maxCoeff(&worst);
  const std::string unit = mechanism.units.length.empty() ? "" : ' ' + mechanism.units.length;
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", miss);
  return phi.row_names()[static_cast<std::size_t>(worst)] + " misses by " + text + unit;
}

}  // namespace moivre
