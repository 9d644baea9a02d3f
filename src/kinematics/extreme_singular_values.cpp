// SPDX-License-Identifier: MIT
// Lanczos on both sides of a QR factorization.
#include "extreme_singular_values.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "moivre/factorization/svd.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Below, there is nothing to iterate.
constexpr Index kSmall = 2;
// Of an eigenvalue: standing still so far from one look to the next is converged.
constexpr double kStandstill = 1e-13;
// Of the largest one, which a condition number is made of.
constexpr double kRoughStandstill = 1e-6;
// Inverse iterations that tell an order of magnitude, and how far above a bound it is beyond doubt
// then.
constexpr int kRoughIterations = 2;
constexpr double kFarAbove = 1e3;
// Looks at the eigenvalues of the tridiagonal matrix, which cost more than a step, are so many
// steps apart, or a part of all steps.
constexpr Index kLooks = 3;

/// A start with a part in every direction, the same for every call.
VectorXd start_vector(Index n) {
  VectorXd v(n);
  for (Index k = 0; k < n; ++k) v[k] = 1 + 0.5 * std::cos(1.7 * static_cast<double>(k));
  return v.normalized();
}

/// The largest eigenvalue of the symmetric operator on n coordinates; nullopt where it is no
/// number.
template <class Operator>
std::optional<double> largest_eigenvalue(const Operator& apply, Index n, double standstill) {
  MatrixXd Q(n, n);
  VectorXd alpha(n);
  VectorXd beta(n);
  Q.col(0) = start_vector(n);
  double last = 0;
  Index next_look = kLooks;
  for (Index k = 0; k < n; ++k) {
    VectorXd w = apply(Q.col(k));
    if (!w.allFinite()) return std::nullopt;
    alpha[k] = Q.col(k).dot(w);
    for (int twice = 0; twice < 2; ++twice) {
      for (Index j = 0; j <= k; ++j) w -= Q.col(j).dot(w) * Q.col(j);
    }
    beta[k] = w.norm();
    const bool is_spanned = k + 1 == n || !(beta[k] > kStandstill * std::abs(alpha[0]));
    if (is_spanned || k == next_look) {
      Eigen::SelfAdjointEigenSolver<MatrixXd> tridiagonal;
      tridiagonal.computeFromTridiagonal(alpha.head(k + 1), beta.head(k), Eigen::EigenvaluesOnly);
      const double value = tridiagonal.eigenvalues()[k];
      const bool stands = std::abs(value - last) <= standstill * std::abs(value);
      last = value;
      if (is_spanned || stands) break;
      next_look += std::max(kLooks, k / 2);
    }
    Q.col(k + 1) = w / beta[k];
  }
  return last;
}

/// R^-T R^-1 has it largest; nullopt where R is singular.
std::optional<double> smallest_of(const StaircaseQr& qr, Index n) {
  if (!qr.is_regular()) return std::nullopt;
  const auto inverse =
      largest_eigenvalue([&](const VectorXd& v) { return qr.inverse_squared(v); }, n, kStandstill);
  if (!inverse || !(*inverse > 0)) return std::nullopt;
  return 1 / std::sqrt(*inverse);
}

/// Its order of magnitude; 0 where R is singular.
double rough_smallest_of(const StaircaseQr& qr, Index n) {
  if (!qr.is_regular()) return 0;
  VectorXd v = start_vector(n);
  double growth = 0;
  for (int k = 0; k < kRoughIterations; ++k) {
    v = qr.inverse_squared(std::move(v));
    growth = v.norm();
    v /= growth;
  }
  return growth > 0 ? 1 / std::sqrt(growth) : 0;
}

}  // namespace

double smallest_singular_value(const MatrixXd& A, const StaircaseOrder& order) {
  if (A.cols() > kSmall) {
    if (const auto smallest = smallest_of(StaircaseQr(A, order), A.cols())) return *smallest;
  }
  const VectorXd all = singular_values(A);
  return all[all.size() - 1];
}

bool is_surely_regular(const MatrixXd& A, const StaircaseOrder& order) {
  if (rough_smallest_of(StaircaseQr(A, order), A.cols()) > kFarAbove * kSurelyRegular) return true;
  return smallest_singular_value(A, order) > kSurelyRegular;
}

bool stays_regular(const MatrixXd& A, double smallest) {
  const double longest = A.rowwise().norm().maxCoeff();
  return smallest > kSurelyRegular * longest * std::sqrt(static_cast<double>(A.rows()));
}

bool stays_surely_regular(const MatrixXd& A, const StaircaseQr& qr) {
  return stays_regular(A, rough_smallest_of(qr, A.cols()) / kFarAbove);
}

ExtremeSingularValues extreme_singular_values(const MatrixXd& A, const StaircaseOrder& order) {
  const Index n = A.cols();
  if (n > kSmall) {
    const StaircaseQr qr(A, order);
    const auto smallest = smallest_of(qr, n);
    const auto square =
        largest_eigenvalue([&](const VectorXd& v) { return qr.squared(v); }, n, kRoughStandstill);
    if (smallest && square && *square > 0) return {std::sqrt(*square), *smallest};
  }
  const VectorXd all = singular_values(A);
  return {all[0], all[all.size() - 1]};
}

}  // namespace moivre
