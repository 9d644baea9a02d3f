// SPDX-License-Identifier: MIT
// Is the way of solving A x = b chosen by shape and rank, and right?
#include "moivre/kinematics/linear.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <stdexcept>

#include "moivre/kinematics/null_space.h"

namespace moivre {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns) {
  std::srand(1);  // Eigen draws from rand
  return MatrixXd::Random(rows, columns);
}

TEST(Linear, MethodFollowsShapeAndRank) {
  EXPECT_EQ(Factorization(random_matrix(4, 4)).method(), LinearMethod::lu);
  EXPECT_EQ(Factorization(random_matrix(6, 4)).method(), LinearMethod::qr);
  EXPECT_EQ(Factorization(random_matrix(3, 5)).method(), LinearMethod::minimum_norm);
  EXPECT_EQ(Factorization(random_matrix(4, 2) * random_matrix(2, 5)).method(), LinearMethod::svd);
}

TEST(Linear, MinimumNormEqualsTheSvdAndItsWeightedForm) {
  const MatrixXd A = random_matrix(3, 5);
  const VectorXd b = VectorXd::LinSpaced(3, 1, 2);
  const VectorXd weights = VectorXd::LinSpaced(5, 0.5, 4);
  const VectorXd x = Factorization(A, {LinearMethod::minimum_norm, weights}).solve(b);
  const VectorXd y = Factorization(A, {LinearMethod::svd, weights}).solve(b);
  EXPECT_LT((A * x - b).norm(), 1e-14);
  EXPECT_LT((x - y).norm(), 1e-13);
  const MatrixXd W_inverse = weights.cwiseInverse().asDiagonal();
  const Eigen::Matrix3d gram = A * W_inverse * A.transpose();
  const VectorXd formula = W_inverse * A.transpose() * (gram.inverse() * b);
  EXPECT_LT((x - formula).norm(), 1e-13);
}

TEST(Linear, RankDoesNotDependOnUnits) {
  MatrixXd A = random_matrix(5, 3) * random_matrix(3, 6);
  EXPECT_EQ(numerical_rank(A), 3);
  A.col(2) *= 1e4;
  A.row(1) *= 1e-4;
  EXPECT_EQ(numerical_rank(A), 3);
}

TEST(Linear, NoiseInAZeroRowStaysNoise) {
  MatrixXd A = MatrixXd::Identity(3, 3);
  A.row(2) << 1e-17, -2e-17, 1e-17;
  EXPECT_EQ(numerical_rank(A), 2);
}

TEST(Linear, EmptyMatricesHaveRankZeroAndFullNullSpace) {
  EXPECT_EQ(numerical_rank(MatrixXd(0, 3)), 0);
  EXPECT_EQ(null_space(MatrixXd(0, 3)), MatrixXd::Identity(3, 3));
  EXPECT_EQ(Factorization(MatrixXd(0, 3)).solve(VectorXd()), VectorXd::Zero(3));
}

TEST(Linear, WeightsMustBePositiveAndOneACoordinate) {
  EXPECT_THROW(Factorization(random_matrix(2, 3), {{}, VectorXd::Ones(2)}), std::invalid_argument);
  EXPECT_THROW(Factorization(random_matrix(2, 3), {{}, VectorXd::Zero(3)}), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
