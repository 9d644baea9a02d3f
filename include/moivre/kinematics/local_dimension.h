// SPDX-License-Identifier: MIT
// In how many directions can the mechanism really move from this pose with the drivers held, not
// only to first order?
//
// The null space of Phi_q (dimension k = n - rank) has all directions in which poses may lie. At a
// singular pose there may be none: a folded triangle has k = 1 and cannot move. So:
//   rank n            the pose is isolated: dimension 0
//   rank m (all rows) the poses around it form a set of dimension n - m, by the implicit function
//   theorem
//   else              random slices decide: d random planes are placed a step away from the pose,
//                     and Gauss-Newton looks for a pose on them. If the poses form a set of
//                     dimension d, such planes meet it. Near an isolated pose Phi stays as large as
//                     a power of the step. Three slices of five must agree.
// q: n coordinates, a pose (Phi = 0). Steps and planes are measured with lengths on the scale of
// the largest one.
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

/// A pose on the set of poses around q where Phi_q has the highest rank that slices find: q itself
/// where none of theirs has a higher one.
Eigen::VectorXd generic_pose(const Phi& phi, const Eigen::VectorXd& q, double t = 0,
                             std::uint64_t seed = 1);

}  // namespace moivre
