// SPDX-License-Identifier: MIT
// How fast does everything move at this pose? Velocity and acceleration with the drivers appended,
// or from chosen coordinates.
//
// Appended drivers: [Phi_q] q' = -Phi_t and [Phi_q] q'' = gamma, where Phi holds the joints and the
// drivers.
// Partitioned: q = [u, v], v independent (as many as degrees of freedom), with the joints' rows
// alone
//   position      Phi(u, v, t) = 0 for u at given v
//   velocity      Phi_u u' = -Phi_v v' - Phi_t
//   acceleration  Phi_u u'' = -Phi_v v'' + gamma
// Both use one factorization for velocity and acceleration. Redundant rows are solved in the
// least-squares sense; what is left over is reported (`velocity_residual`, `acceleration_residual`:
// largest entry).
#pragma once

#include <string>
#include <vector>

#include "moivre/kinematics/newton.h"

namespace moivre {

struct MotionState {
  Eigen::VectorXd q;
  Eigen::VectorXd velocity;      ///< q'
  Eigen::VectorXd acceleration;  ///< q''
  LinearMethod method = LinearMethod::lu;
  Eigen::Index rank = 0;
  bool is_determined = false;  ///< rank = number of dependent coordinates: no other motion fits
  double velocity_residual = 0;
  double acceleration_residual = 0;
  int factorizations = 0;
};

/// Velocity and acceleration at an assembled pose q, drivers appended. Where coordinates stay free
/// the shortest are given.
MotionState motion_state(const Phi& phi, const Eigen::VectorXd& q, double t,
                         const LinearOptions& options = {});

/// q split into dependent u and independent v: indices into q, each sorted.
struct Partition {
  std::vector<Eigen::Index> dependent;
  std::vector<Eigen::Index> independent;
  double smallest_pivot =
      0;  ///< of the equilibrated Phi_u, relative to its largest: a poor choice near 0
  std::string refusal;  ///< why this choice cannot be used at this pose; empty: it can

  bool is_usable() const { return refusal.empty(); }
};

/// The n - rank columns of Phi_q in own units (own_units.h) that pivoting leaves over, sorted.
std::vector<Eigen::Index> independent_columns(const Eigen::MatrixXd& J, Eigen::Index rank);

/// The n - rank independent coordinates that pivoting leaves over at q. Give the joints alone
/// (phi.without_drivers()).
Partition choose_partition(const Phi& joints, const Eigen::VectorXd& q, double t = 0);

/// A user's independent coordinates. Refused (with the reason) where Phi_u is singular or their
/// number is wrong.
/// Throws std::invalid_argument for an index that is no coordinate or comes twice.
Partition make_partition(const Phi& joints, const Eigen::VectorXd& q,
                         std::vector<Eigen::Index> independent, double t = 0);

/// Newton-Raphson on u alone; v keeps the values it has in `guess`. Requires a usable partition.
NewtonResult solve_positions(const Phi& joints, const Partition& partition,
                             const Eigen::VectorXd& guess, double t = 0,
                             const NewtonOptions& options = {});

/// Velocity and acceleration from those of the independent coordinates. Requires a usable
/// partition; throws std::invalid_argument where sizes do not fit, or numbers are not finite.
MotionState partitioned_state(const Phi& joints, const Partition& partition,
                              const Eigen::VectorXd& q, const Eigen::VectorXd& independent_velocity,
                              const Eigen::VectorXd& independent_acceleration, double t = 0);

}  // namespace moivre
