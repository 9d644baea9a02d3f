// SPDX-License-Identifier: MIT
// How many degrees of freedom has the mechanism at this pose, which rows are redundant, and where
// do constraints push?
//
//   degrees of freedom = n - rank Phi_q;  Gruebler's count = n - m
//   R: n x (n - rank), Phi_q R = 0, orthonormal: the allowable velocities q' = R z'
//   a redundant row is a combination of rows before it; left null vectors c with c^T Phi_q = 0 say
//   which constraint i pushes along -lambda_i (Phi_q^T) column i
// The rank comes from column-pivoted QR, and singular values confirm it; both are of the
// equilibrated Phi_q.
// With `fit` (Mechanism::fit, in the file's unit of length) a motion is one during which
// constraints miss by no more than fit: singular values up to sqrt(m) fit / phi.length() count as
// zero, and a pose that misses by no more than fit, drivers included, as assembled.
// A singular pose (a dead point, a bifurcation) has a lower rank than the poses near it. It is
// found by stepping along R and correcting back to the constraints. A pose near a singular one
// gives a warning. There R is what constraints see nothing of to first order: not all of it need be
// motion.
#pragma once

#include <string>
#include <vector>

#include "moivre/kinematics/newton.h"

namespace moivre {

/// coefficient * row `row`.
struct RowShare {
  Eigen::Index row = 0;
  std::string name;
  double coefficient = 0;
};

/// Row `row` = sum of the shares.
struct RedundantRow {
  Eigen::Index row = 0;
  std::string name;
  std::vector<RowShare> combination;
};

/// "Phi5 = Phi1 - Phi3", by the rows' names.
std::string to_text(const RedundantRow& redundant);

/// What counts as zero in the equilibrated Phi_q where each row of the joints may miss by `fit`.
double rank_tolerance(const Phi& joints, double fit);

/// What counts alone, drivers left out: a tenth of the work of `mobility`.
struct ConstraintRank {
  Eigen::Index rank = 0;                ///< by pivoted QR
  Eigen::Index degrees_of_freedom = 0;  ///< n - rank
  std::vector<RedundantRow> redundant;
};

ConstraintRank constraint_rank(const Phi& phi, const Eigen::VectorXd& q, double t = 0,
                               double fit = 0);

/// A body (or unknown) that can move while all others stand still, and that no driver holds. At a
/// singular pose: that can next to it, too.
struct IdleFreedom {
  std::string name;
  /// q' of length 1, zero but for this body. At a singular pose along the motion that was followed
  /// through it; next to it where none was.
  Eigen::VectorXd direction;
};

struct Mobility {
  Eigen::Index coordinates = 0;  ///< n
  Eigen::Index constraints = 0;  ///< m, joints (or equations) without drivers
  Eigen::Index drivers = 0;
  Eigen::Index rank = 0;  ///< by pivoted QR
  Eigen::Index rank_by_svd = 0;
  Eigen::Index degrees_of_freedom = 0;  ///< n - rank
  Eigen::Index gruebler = 0;            ///< n - m
  Eigen::Index driven_freedoms = 0;     ///< degrees of freedom left with the drivers held
  std::vector<RedundantRow> redundant;
  Eigen::VectorXd singular_values;   ///< of the equilibrated Phi_q, largest first
  Eigen::MatrixXd null_space;        ///< R
  Eigen::MatrixXd left_null_space;   ///< m x (m - rank), orthonormal, of Phi_q^T
  Eigen::MatrixXd force_directions;  ///< n x m, column i = -gradient of constraint i
  std::vector<IdleFreedom> idle;
  std::vector<Eigen::Index> independent;  ///< coordinates chosen by pivoting
  double misfit = 0;                      ///< of the pose, drivers included (mechanism/phi.h)
  bool is_assembled = false;              ///< the joints' rows vanish, or misfit <= fit
  bool is_singular = false;               ///< rank_nearby > rank
  Eigen::Index rank_nearby = 0;           ///< rank at assembled poses next to this one
  bool is_near_singular = false;
  std::vector<std::string> row_names;
  std::vector<std::string> warnings;
};

/// At the pose q and the time t. Assembled: the joints' rows vanish, or no row misses by more than
/// `fit`.
Mobility mobility(const Phi& phi, const Eigen::VectorXd& q, double t = 0, double fit = 0);

}  // namespace moivre
