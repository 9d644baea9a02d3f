// SPDX-License-Identifier: MIT
// How does an assembled pose move when a dimension changes? dq/dp by the implicit function theorem.
//
//   Phi(q(p), p) = 0  =>  Phi_q dq/dp_k = -Phi_p,k        one factorization of Phi_q for all
//                         dimensions
// Symbols: q (n coordinates), p dimensions (mechanism/dimensions.h), Phi_p (m x p,
// mechanism/dimension_rates.h), the drivers held.
// Edges, each an answer of its own:
//   dead point   rank Phi_q < n: the pose moves like the square root of a change. There is no
//                derivative, except by dimensions that enter no constraint
//   spare rows   m > rank: if -Phi_p,k is no combination of Phi_q's columns, the mechanism does not
//                close after p_k alone has changed. It has no derivative by p_k
//   spins        n - rank freedoms that hide no closure (a rod's body between two balls): dq/dp is
//                one of many, `free` has the others
// Not supported: poses that close by least squares only, whose derivative needs the curvature of
// Phi.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "moivre/mechanism/phi.h"

namespace moivre {

struct PoseSensitivity {
  bool is_singular = false;
  bool has_spare_rows = false;  ///< m > rank: a pose may close to first order only
  Eigen::MatrixXd rates;        ///< n x p, column k = dq/dp_k; NaN where there is none
  /// One per dimension: to first order it cannot change alone; false of a singular pose.
  std::vector<bool> breaks_closure;
  Eigen::MatrixXd free;  ///< n x spins, the ways in which q may move though no dimension does
};

/// What is known of a pose beside its coordinates.
struct PoseKind {
  Eigen::Index spins = 0;    ///< freedoms that it has though it is isolated
  bool is_multiple = false;  ///< a multiple root of closure equations: known to half the digits
};

/// At the pose q, assembled at time t. Throws std::invalid_argument where sizes do not fit, or
/// numbers are not finite.
PoseSensitivity pose_sensitivity(const Phi& phi, const Eigen::VectorXd& q, double t,
                                 const Eigen::MatrixXd& partial_p, const PoseKind& kind = {});

}  // namespace moivre
