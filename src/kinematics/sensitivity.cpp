// SPDX-License-Identifier: MIT
// dq/dp from one factorization; what is left over of a right-hand side tells whether the mechanism
// still closes.
#include "moivre/kinematics/sensitivity.h"

#include <Eigen/Core>
#include <limits>
#include <string>

#include "moivre/factorization/qr.h"
#include "moivre/kinematics/null_space.h"
#include "moivre/kinematics/own_units.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What least squares leave over, relative to the right-hand side. A pose is known to about 1e-13,
// and so is what its constraints span where they are well conditioned; a dimension that a spare
// constraint holds leaves a share of order 1.
constexpr double kLeftOver = 1e-7;

/// Lengths of the rows, so that a row that compares angles counts like one of lengths; no less than
/// a thousandth of the longest.
VectorXd row_lengths(const MatrixXd& A) {
  constexpr double kFloor = 1e-3;
  const VectorXd lengths = A.rowwise().norm();
  const double longest = lengths.size() == 0 ? 0 : lengths.maxCoeff();
  return lengths.cwiseMax(longest > 0 ? kFloor * longest : 1);
}

// A double root that is right to rounding is off by the root of that, and so is Phi_q at a dead
// point, relative to its largest pivot.
constexpr double kHalfTheDigits = 1e-6;

Index rank_within(const MatrixXd& A, double tolerance) {
  return PivotedQr<double>(equilibrated(A)).rank(tolerance);
}

}  // namespace

PoseSensitivity pose_sensitivity(const Phi& phi, const VectorXd& q, double t,
                                 const MatrixXd& partial_p, const PoseKind& kind) {
  require_place(phi, q, t);
  if (partial_p.rows() != phi.size() || !partial_p.allFinite()) {
    throw InvalidInput("partial_p has finite numbers, a row for each of " +
                       std::to_string(phi.size()) + " constraints");
  }
  if (kind.spins < 0) throw InvalidInput("a pose has no fewer spins than none");
  const MatrixXd J = phi.jacobian(q, t);
  const Factorization factors = factorization_of(phi, J);
  const VectorXd scale = row_lengths(J).cwiseInverse();
  PoseSensitivity result;
  const Index rank =
      kind.is_multiple ? rank_within(in_own_units(phi, J), kHalfTheDigits) : factors.rank();
  result.is_singular = rank + kind.spins < phi.dimension();
  result.has_spare_rows = rank < phi.size();
  result.rates = MatrixXd::Zero(phi.dimension(), partial_p.cols());
  result.breaks_closure.resize(static_cast<std::size_t>(partial_p.cols()));
  result.free = result.is_singular || factors.rank() == phi.dimension()
                    ? MatrixXd(phi.dimension(), 0)
                    : null_space_of(phi, J);
  for (Index k = 0; k < partial_p.cols(); ++k) {
    const VectorXd change = partial_p.col(k);
    if (change.isZero(0)) continue;
    auto rate = result.rates.col(k);
    if (!result.is_singular) {
      rate = factors.solve(-change);
      const double left_over = (J * rate + change).cwiseProduct(scale).cwiseAbs().maxCoeff();
      const double size = change.cwiseProduct(scale).cwiseAbs().maxCoeff();
      result.breaks_closure[static_cast<std::size_t>(k)] = left_over > kLeftOver * size;
    }
    if (result.is_singular || result.breaks_closure[static_cast<std::size_t>(k)]) {
      rate.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }
  return result;
}

}  // namespace moivre
