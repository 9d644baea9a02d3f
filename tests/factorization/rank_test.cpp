// SPDX-License-Identifier: MIT
// Is a rank never told that the error could take away, and is one told that it cannot?
#include "moivre/factorization/rank.h"

#include <gtest/gtest.h>

#include "moivre/numeric/random.h"

namespace moivre {
namespace {

Eigen::MatrixXcd random_matrix(Eigen::Index m, Eigen::Index n, std::uint64_t seed) {
  Eigen::MatrixXcd A(m, n);
  for (Eigen::Index k = 0; k < A.size(); ++k) {
    A.data()[k] = random_phase(seed, RandomStream::slice, static_cast<std::uint64_t>(k));
  }
  return A;
}

TEST(LeastRank, CountsWhatTheErrorCannotTakeAway) {
  const Eigen::MatrixXcd A = Eigen::Vector3cd(1, 1e-3, 1e-9).asDiagonal();
  EXPECT_EQ(least_rank(A, 0), 3);
  EXPECT_EQ(least_rank(A, 1e-6), 2);
  EXPECT_EQ(least_rank(A, 1e-2), 1);
  EXPECT_EQ(least_rank(A, 2), 0);
}

TEST(LeastRank, OfAProductIsItsInnerDimensionWhateverTheErrorAddsToIt) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Eigen::MatrixXcd B = random_matrix(9, 4, seed) * random_matrix(4, 6, seed + 10);
    EXPECT_EQ(least_rank(B, 0), 4);
    const Eigen::MatrixXcd E = 1e-8 * random_matrix(9, 6, seed + 20);
    EXPECT_EQ(least_rank(B + E, E.norm()), 4);
    EXPECT_EQ(least_rank(B + E, 1e-12), 6);
  }
}

TEST(LeastRank, OfNothingIsZero) {
  EXPECT_EQ(least_rank(Eigen::MatrixXcd(0, 3), 0), 0);
  EXPECT_EQ(least_rank(Eigen::MatrixXcd(3, 0), 0), 0);
  EXPECT_EQ(least_rank(Eigen::MatrixXcd::Zero(3, 3), 0), 0);
}

}  // namespace
}  // namespace moivre
