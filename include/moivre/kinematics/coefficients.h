// SPDX-License-Identifier: MIT
// How far does each coordinate move for a step of one driver, the others standing? Kinematic coefficients, first and second order.
//
// With Phi(q, t) = 0 and the drivers' rows g_a(q) - f_a = 0, q is a function of the drivers' values f_1 .. f_d:
//   k_a  = dq / df_a            Phi_q k_a = e_a                     e_a: 1 in the row of driver a
//   k_ab = d2q / (df_a df_b)    Phi_q k_ab = -(Phi_q k_a)_q k_b
// They belong to the pose and not to the drivers' speed: q' = sum k_a f_a', q'' = sum k_a f_a'' + sum k_ab f_a' f_b'.
// Symbols: n coordinates, d drivers; angles in radians, lengths in the file's unit.
// Edges: where Phi_q has not full rank (a dead point) there are none: is_determined is false and all is NaN.
// Equations that name the time themselves are taken with the time standing.
// Source: [UickerPennockShigley17, ch. 3-4], first- and second-order kinematic coefficients.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "moivre/mechanism/phi.h"

namespace moivre {

struct KinematicCoefficients {
  bool is_determined = false;
  Eigen::MatrixXd first;                ///< n x d, column a = k_a
  std::vector<Eigen::MatrixXd> second;  ///< d of n x d, second[a].col(b) = k_ab
};

/// At the pose q, assembled at time t.
KinematicCoefficients kinematic_coefficients(const Phi& phi, const Eigen::VectorXd& q, double t);

}  // namespace moivre
