// SPDX-License-Identifier: MIT
// In how many directions can the mechanism really go from this pose, drivers standing, and not only begin to?
//
// The null space of Phi_q (dimension k = n - rank) holds all directions in which poses may lie; at a singular pose they
// need not: a triangle at its fold has k = 1 and stands. So:
//   rank n            the pose is isolated: dimension 0
//   rank m (all rows) the poses around it form a set of dimension n - m, by the implicit function theorem
//   else              second random slices decide: d random planes are put a step away from the pose, and Gauss-Newton
//                     looks for a pose on them. Where the poses form a set of dimension d, such planes meet it;
//                     beside an isolated pose Phi stays as large as a power of the step. Three slices of five must agree.
// q: n coordinates, a pose (Phi = 0). Steps and planes are measured with lengths on the scale of the largest one.
// Not supported: isolated poses of multiplicity above 7, which are within rounding of a set.
// Source: [SommeseWampler05, ch. 13], local dimension by slicing.
#pragma once

#include <cstdint>
#include <string>

#include "moivre/mechanism/phi.h"

namespace moivre {

struct LocalDimension {
  Eigen::Index dimension = 0;
  std::string shown;  ///< how, as a clause: "a random plane ... meets ..."
};

/// Of the poses around q at the drivers' time t. The planes come from `seed`.
LocalDimension local_dimension(const Phi& phi, const Eigen::VectorXd& q, double t = 0,
                               std::uint64_t seed = 1);

}  // namespace moivre
