// SPDX-License-Identifier: MIT
// How is A x = b factorized once and solved often? LU, normal equations, QR, minimum norm and SVD.
#include "moivre/kinematics/linear.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "extreme_singular_values.h"
#include "moivre/factorization/qr.h"
#include "moivre/factorization/svd.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the longest row or column. Applied to rows and columns it lifts rounding noise (1e-16) to
// 1e-10 at most, which kRankTolerance still takes for zero.
constexpr double kLengthFloor = 1e-3;

void scale_rows(MatrixXd& A) {
  const VectorXd length = A.rowwise().norm();
  const double longest = length.size() == 0 ? 0 : length.maxCoeff();
  if (!(longest > 0)) return;
  for (Index i = 0; i < A.rows(); ++i) A.row(i) /= std::max(length[i], kLengthFloor * longest);
}

bool suits(LinearMethod method, Index rows, Index columns, Index rank) {
  switch (method) {
    case LinearMethod::lu:
      return rows == columns && rank == columns;
    case LinearMethod::normal_equations:
    case LinearMethod::qr:
      return rank == columns;
    case LinearMethod::minimum_norm:
      return rank == rows;
    case LinearMethod::svd:
      return true;
  }
  return false;
}

LinearMethod natural_method(Index rows, Index columns, Index rank) {
  for (const LinearMethod method :
       {LinearMethod::lu, LinearMethod::qr, LinearMethod::minimum_norm}) {
    if (suits(method, rows, columns, rank)) return method;
  }
  return LinearMethod::svd;
}

/// Whether an equilibrated matrix is far from losing rank, where stairs make that cheaper to know
/// than its pivots.
bool has_surely_full_rank(const MatrixXd& equilibrated) {
  constexpr Index kStairsPay = 16;
  const MatrixXd tall = equilibrated.rows() >= equilibrated.cols()
                            ? equilibrated
                            : MatrixXd(equilibrated.transpose());
  if (tall.cols() <= kStairsPay || !tall.allFinite()) return false;
  const StaircaseOrder order = staircase_order(tall);
  return is_surely_regular(tall, order);
}

/// All 1 where none are given.
VectorXd positive_or_ones(const VectorXd& numbers, Index size, const std::string& names,
                          const char* what_has_one) {
  if (numbers.size() == 0) return VectorXd::Ones(size);
  if (numbers.size() != size || !(numbers.array() > 0).all() || !numbers.allFinite()) {
    throw InvalidInput(names + " must be " + std::to_string(size) + " positive numbers, one " +
                       what_has_one);
  }
  return numbers;
}

}  // namespace

std::string to_string(LinearMethod method) {
  switch (method) {
    case LinearMethod::lu:
      return "LU";
    case LinearMethod::normal_equations:
      return "normal equations";
    case LinearMethod::qr:
      return "QR";
    case LinearMethod::minimum_norm:
      return "minimum norm";
    case LinearMethod::svd:
      return "SVD";
  }
  return "";
}

MatrixXd equilibrated(const MatrixXd& A) {
  MatrixXd scaled = A;
  scale_rows(scaled);
  MatrixXd columns = scaled.transpose();
  scale_rows(columns);
  return columns.transpose();
}

Index numerical_rank(const MatrixXd& A, double tolerance) {
  if (A.size() == 0) return 0;
  const MatrixXd scaled = equilibrated(A);
  if (tolerance > kRankTolerance) {
    const VectorXd sigma = singular_values(scaled);
    return (sigma.array() > tolerance * sigma[0]).count();
  }
  if (has_surely_full_rank(scaled)) return std::min(A.rows(), A.cols());
  return PivotedQr<double>(scaled).rank(tolerance);
}

struct Factorization::Factors {
  Eigen::PartialPivLU<MatrixXd> lu;
  Eigen::LDLT<MatrixXd> normal;
  Qr qr;    // of A, or of (A W^(-1/2))^T for minimum_norm
  Svd svd;  // of A W^(-1/2)

  Factors(LinearMethod method, const MatrixXd& A, const VectorXd& root_weights) {
    const auto weighted = [&]() -> MatrixXd {
      return A * root_weights.cwiseInverse().asDiagonal();
    };
    switch (method) {
      case LinearMethod::lu:
        lu.compute(A);
        break;
      case LinearMethod::normal_equations:
        normal.compute(A.transpose() * A);
        break;
      case LinearMethod::qr:
        qr = Qr(A);
        break;
      case LinearMethod::minimum_norm:
        qr = Qr(weighted().transpose());
        break;
      case LinearMethod::svd:
        svd = moivre::svd(weighted(), SingularVectors::thin);
        break;
    }
  }
};

Factorization::Factorization(const MatrixXd& A, const LinearOptions& options)
    : row_units_(positive_or_ones(options.row_units, A.rows(), "row units", "an equation")),
      column_units_(
          positive_or_ones(options.column_units, A.cols(), "column units", "a coordinate")),
      A_(row_units_.cwiseInverse().asDiagonal() * A * column_units_.asDiagonal()),
      root_weights_(column_units_.cwiseProduct(
          positive_or_ones(options.weights, A.cols(), "weights", "a coordinate").cwiseSqrt())),
      rank_(numerical_rank(A_)) {
  method_ = options.method.value_or(natural_method(A.rows(), A.cols(), rank_));
  if (!suits(method_, A.rows(), A.cols(), rank_)) method_ = LinearMethod::svd;
  if (A.size() != 0) factors_ = std::make_shared<const Factors>(method_, A_, root_weights_);
}

VectorXd Factorization::solve(const VectorXd& b) const {
  if (b.size() != row_units_.size()) {
    throw InvalidInput("b has " + std::to_string(b.size()) + " numbers, A has " +
                       std::to_string(row_units_.size()) + " rows");
  }
  if (!factors_) return VectorXd::Zero(A_.cols());
  return column_units_.cwiseProduct(solve_in_units(b.cwiseQuotient(row_units_)));
}

VectorXd Factorization::solve_in_units(const VectorXd& b) const {
  const auto& [lu, normal, qr, svd] = *factors_;
  switch (method_) {
    case LinearMethod::lu:
      return lu.solve(b);
    case LinearMethod::normal_equations:
      return normal.solve(A_.transpose() * b);
    case LinearMethod::qr:
      return qr.solve(b);
    case LinearMethod::minimum_norm:
      // The shortest z with A W^(-1/2) z = b, x = W^(-1/2) z.
      return qr.solve_transposed(b).cwiseQuotient(root_weights_);
    case LinearMethod::svd:
      break;
  }
  // x = W^(-1/2) V S^+ U^T b with the `rank_` largest singular values.
  const VectorXd c = svd.U.leftCols(rank_).transpose() * b;
  const VectorXd z = svd.V.leftCols(rank_) * c.cwiseQuotient(svd.sigma.head(rank_));
  return z.cwiseQuotient(root_weights_);
}

}  // namespace moivre
