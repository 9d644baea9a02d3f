// SPDX-License-Identifier: MIT
// The inverse of R grows by a column for each column of A, until it is too large.
#include "moivre/factorization/rank.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "moivre/factorization/qr.h"

namespace moivre {

using Eigen::Index;
using Eigen::MatrixXcd;

Index least_rank(const MatrixXcd& A, double error) {
  if (A.size() == 0) return 0;
  const Index most = std::min(A.rows(), A.cols());
  const double rounding = static_cast<double>(most) * std::numeric_limits<double>::epsilon();
  const double noise = error + rounding * A.norm();
  const MatrixXcd R = PivotedQr<std::complex<double>>(A).R();
  MatrixXcd inverse = MatrixXcd::Zero(most, most);
  double squares = 0;
  for (Index r = 0; r < most; ++r) {
    if (std::abs(R(r, r)) <= noise) return r;
    inverse(r, r) = 1.0 / R(r, r);
    inverse.col(r).head(r) = -inverse(r, r) * (inverse.topLeftCorner(r, r) * R.col(r).head(r));
    squares += inverse.col(r).head(r + 1).squaredNorm();
    if (std::sqrt(squares) * noise >= 1) return r;
  }
  return most;
}

}  // namespace moivre
