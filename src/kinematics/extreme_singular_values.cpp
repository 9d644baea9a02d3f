// SPDX-License-Identifier: MIT
// Lanczos on both sides of a QR factorization.
#include "extreme_singular_values.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <optional>
#include <vector>

#include "moivre/numeric/svd.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Below, Jacobi's rotations are as fast.
constexpr Index kSmall = 16;
// Of an eigenvalue: standing still so far, twice running, is converged.
constexpr double kStandstill = 1e-13;
constexpr Index kFewest = 4;

/// A start with a part in every direction, the same for every call.
VectorXd start_vector(Index n) {
  VectorXd v(n);
  for (Index k = 0; k < n; ++k) v[k] = 1 + 0.5 * std::cos(1.7 * static_cast<double>(k));
  return v.normalized();
}

/// The largest eigenvalue of the symmetric operator on n coordinates; nullopt where it is no number.
template <class Operator>
std::optional<double> largest_eigenvalue(const Operator& apply, Index n) {
  MatrixXd Q(n, n);
  VectorXd alpha(n);
  VectorXd beta(n);
  Q.col(0) = start_vector(n);
  double last = 0;
  int still = 0;
  for (Index k = 0; k < n; ++k) {
    VectorXd w = apply(Q.col(k));
    if (!w.allFinite()) return std::nullopt;
    alpha[k] = Q.col(k).dot(w);
    for (int twice = 0; twice < 2; ++twice) {
      w -= Q.leftCols(k + 1) * (Q.leftCols(k + 1).transpose() * w);
    }
    beta[k] = w.norm();
    Eigen::SelfAdjointEigenSolver<MatrixXd> tridiagonal;
    tridiagonal.computeFromTridiagonal(alpha.head(k + 1), beta.head(k), Eigen::EigenvaluesOnly);
    const double value = tridiagonal.eigenvalues()[k];
    still = std::abs(value - last) <= kStandstill * std::abs(value) ? still + 1 : 0;
    last = value;
    const bool is_spanned = !(beta[k] > kStandstill * std::abs(value));
    if (is_spanned || (still >= 2 && k >= kFewest)) break;
    if (k + 1 < n) Q.col(k + 1) = w / beta[k];
  }
  return last;
}

}  // namespace

ExtremeSingularValues extreme_singular_values(const MatrixXd& A) {
  const MatrixXd tall = A.rows() >= A.cols() ? A : MatrixXd(A.transpose());
  const Index n = tall.cols();
  const auto by_svd = [&] {
    const VectorXd all = singular_values(A);
    return ExtremeSingularValues{all[0], all[all.size() - 1]};
  };
  if (n <= kSmall) return by_svd();
  const Eigen::HouseholderQR<MatrixXd> qr(tall);
  const MatrixXd R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  if (!(R.diagonal().cwiseAbs().minCoeff() > 0)) return by_svd();
  const auto square =
      largest_eigenvalue([&](const VectorXd& v) { return VectorXd(R.transpose() * (R * v)); }, n);
  const auto inverse = largest_eigenvalue(
      [&](const VectorXd& v) {
        const VectorXd w = R.triangularView<Eigen::Upper>().transpose().solve(v);
        return VectorXd(R.triangularView<Eigen::Upper>().solve(w));
      },
      n);
  if (!square || !inverse || !(*square > 0) || !(*inverse > 0)) return by_svd();
  return {std::sqrt(*square), 1 / std::sqrt(*inverse)};
}

}  // namespace moivre
