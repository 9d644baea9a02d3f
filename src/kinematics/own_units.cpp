// SPDX-License-Identifier: MIT
// Ranks and null spaces of the scaled matrix, the latter carried back to the file's units.
#include "moivre/kinematics/own_units.h"

#include "moivre/factorization/qr.h"
#include "moivre/kinematics/null_space.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd orthonormal(const MatrixXd& columns) {
  return columns.size() == 0 ? columns : Qr(columns).basis();
}

}  // namespace

double largest_of(const Phi& phi, const VectorXd& v) {
  return v.size() == 0 ? 0 : v.cwiseQuotient(phi.own_units()).lpNorm<Eigen::Infinity>();
}

MatrixXd in_own_units(const Phi& phi, const MatrixXd& J) {
  MatrixXd scaled = phi.own_row_units().head(J.rows()).cwiseInverse().asDiagonal() * J;
  const Index n = phi.dimension();
  scaled.leftCols(n) = scaled.leftCols(n) * phi.own_units().asDiagonal();
  return scaled;
}

Index rank_of(const Phi& phi, const MatrixXd& J, double tolerance) {
  return numerical_rank(in_own_units(phi, J), tolerance);
}

Factorization factorization_of(const Phi& phi, const MatrixXd& J, LinearOptions options) {
  options.row_units = phi.own_row_units();
  options.column_units = phi.own_units();
  return Factorization(J, options);
}

MatrixXd null_space_of(const Phi& phi, const MatrixXd& J, double tolerance) {
  return orthonormal(phi.own_units().asDiagonal() * null_space(in_own_units(phi, J), tolerance));
}

MatrixXd left_null_space_of(const Phi& phi, const MatrixXd& J, double tolerance) {
  const VectorXd units = phi.own_row_units().head(J.rows());
  return orthonormal(units.cwiseInverse().asDiagonal() *
                     left_null_space(in_own_units(phi, J), tolerance));
}

}  // namespace moivre
