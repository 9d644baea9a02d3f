// SPDX-License-Identifier: MIT
// How far does each coordinate move for a step of one driver, with the others held? Kinematic
// coefficients, first and second order.
//
// With Phi(q, t) = 0, where driver a's value f_a stands in its own row alone, q is a function of
// f_1 .. f_d:
//   k_a  = dq / df_a            Phi_q k_a = -dPhi/df_a              -1 in the row of a driven
//                               angle; -2 L of an actuator, whose row is
//                                                                   |D|^2 - L^2
//   k_ab = d2q / (df_a df_b)    Phi_q k_ab = -(Phi_q k_a)_q k_b - d2Phi/(df_a df_b)
// They belong to the pose and not to the drivers' speed: q' = sum k_a f_a', q'' = sum k_a f_a'' +
// sum k_ab f_a' f_b'.
// Symbols: n coordinates, d drivers; angles in radians, lengths in the file's unit.
// Edges: if Phi_q does not have full rank (a dead point), is_determined is false and all values are
// NaN.
// In equations that contain the time, the time is held.
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
