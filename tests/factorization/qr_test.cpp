// SPDX-License-Identifier: MIT
// QR factorizations: least squares, shortest solutions and ranks of matrices that were made to have
// them.
#include "moivre/factorization/qr.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace moivre {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Entries that no small sum relates.
MatrixXd made(Index rows, Index columns) {
  MatrixXd A(rows, columns);
  for (Index k = 0; k < A.size(); ++k) A.data()[k] = std::sin(1.0 + static_cast<double>(k * k));
  return A;
}

MatrixXcd made_complex(Index rows, Index columns) {
  return made(rows, columns).cast<Complex>() + Complex(0, 1) * made(columns, rows).transpose();
}

TEST(Qr, WhatIsLeftOfALeastSquaresSolutionIsOrthogonalToTheColumns) {
  const MatrixXd A = made(7, 4);
  const VectorXd b = made(7, 1);
  EXPECT_LT((A.transpose() * (A * Qr(A).solve(b) - b)).norm(), 1e-14);
}

TEST(Qr, TheShortestSolutionOfTheTransposedEquationsLiesInTheSpanOfTheColumns) {
  const MatrixXd A = made(7, 4);
  const VectorXd c = made(4, 1);
  const VectorXd y = Qr(A).solve_transposed(c);
  EXPECT_LT((A.transpose() * y - c).norm(), 1e-14);
  const MatrixXd Q = Qr(A).basis();
  EXPECT_LT((Q.transpose() * Q - MatrixXd::Identity(4, 4)).norm(), 1e-14);
  EXPECT_LT((Q * (Q.transpose() * y) - y).norm(), 1e-14);
}

TEST(Qr, TheInverseOfTheGramMatrixMultipliesBack) {
  const MatrixXd A = made(7, 4);
  const VectorXd v = made(4, 1);
  EXPECT_LT((A.transpose() * (A * Qr(A).inverse_gram(v)) - v).norm(), 1e-13);
}

TEST(PivotedQr, CountsIndependentColumnsAndGivesWhatIsOrthogonalToThem) {
  const MatrixXd A = made(6, 3) * made(3, 5);
  const PivotedQr<double> qr(A);
  EXPECT_EQ(qr.rank(1e-12), 3);
  EXPECT_EQ(qr.rank(2), 0);
  EXPECT_EQ(PivotedQr<double>(MatrixXd::Zero(3, 2)).rank(1e-12), 0);
  const MatrixXd across = qr.last_columns_of_Q(3);
  EXPECT_LT((across.transpose() * A).norm(), 1e-13);
  EXPECT_LT((across.transpose() * across - MatrixXd::Identity(3, 3)).norm(), 1e-14);
}

TEST(PivotedQr, TakesTheLongestColumnFirstAndItsPivotsFall) {
  MatrixXd A = made(5, 4);
  A.col(2) *= 100;
  const PivotedQr<double> qr(A);
  EXPECT_EQ(qr.order()[0], 2);
  const VectorXd pivots = qr.pivots();
  EXPECT_NEAR(pivots[0], A.col(2).norm(), 1e-12);
  EXPECT_TRUE(std::is_sorted(pivots.begin(), pivots.end(), std::greater<>()));
}

TEST(PivotedQr, OfAComplexMatrixSolvesAndItsRMultipliesBackToTheGramMatrix) {
  const MatrixXcd A = made_complex(4, 4);
  const VectorXcd b = made_complex(4, 1);
  const PivotedQr<Complex> qr(A);
  EXPECT_LT((A * qr.solve(b) - b).norm(), 1e-13);
  const MatrixXcd R = qr.R();
  const MatrixXcd gram = R.adjoint() * R;
  for (Index i = 0; i < 4; ++i) {
    for (Index k = 0; k < 4; ++k) {
      EXPECT_LT(std::abs(gram(i, k) - A.col(qr.order()[i]).dot(A.col(qr.order()[k]))), 1e-13);
    }
  }
}

TEST(ShortestSolution, OfAMatrixWithoutFullRankHasNothingInItsNullSpace) {
  const MatrixXd A = made(6, 2) * made(2, 5);
  const VectorXd b = made(6, 1);
  const VectorXd x = shortest_solution(A, b, 1e-12);
  EXPECT_LT((A.transpose() * (A * x - b)).norm(), 1e-12);
  // Orthogonal to the null space: in the span of the rows.
  const MatrixXd rows = Qr(made(2, 5).transpose()).basis();
  EXPECT_LT((rows * (rows.transpose() * x) - x).norm(), 1e-13);
}

TEST(ShortestSolution, OfComplexEquationsIsShorterThanAnyOther) {
  const MatrixXcd A = made_complex(2, 4);
  const VectorXcd b = made_complex(2, 1);
  const VectorXcd x = shortest_solution(A, b);
  EXPECT_LT((A * x - b).norm(), 1e-14);
  const VectorXcd null = PivotedQr<Complex>(A.adjoint()).last_columns_of_Q(2).col(0);
  EXPECT_LT((A * null).norm(), 1e-14);
  EXPECT_LT(std::abs(null.dot(x)), 1e-14);
}

}  // namespace
}  // namespace moivre
