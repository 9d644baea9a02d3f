// SPDX-License-Identifier: MIT
// How are a sample's coordinates shown: each angle in (-pi, pi], or going on from where the branch's first sample has it?
#pragma once

#include "moivre/closure_report/angles.h"
#include "moivre/motion/motion.h"

namespace moivre {

inline Eigen::VectorXd shown(const Phi& phi, const MotionBranch& branch, const BranchSample& sample,
                             const AngleForm& form) {
  if (!form.goes_on) return phi.canonical(sample.q);
  const Eigen::VectorXd& first = branch.samples.front().q;
  Eigen::VectorXd q = sample.q;
  const Eigen::VectorXd shift = phi.canonical(first) - first;
  for (std::size_t k = 0; k < phi.coordinates().size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (phi.coordinates()[k].kind == CoordinateKind::angle) q[i] += shift[i];
  }
  return q;
}

}  // namespace moivre
