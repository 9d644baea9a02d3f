// SPDX-License-Identifier: MIT
// How far are two poses apart? The largest difference of coordinates, angles to their nearest turn.
#pragma once

#include <Eigen/Core>

#include "moivre/mechanism/phi.h"

namespace moivre::test {

inline double gap(const Mechanism& mechanism, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return Phi(mechanism).canonical(a - b).lpNorm<Eigen::Infinity>();
}

}  // namespace moivre::test
