// SPDX-License-Identifier: MIT
// Is the least motion that of the singular value decomposition, at ordinary postures and next to
// singular ones?
#include "../../src/arms/least_motion.h"

#include <gtest/gtest.h>

#include "moivre/factorization/svd.h"
#include "moivre/numeric/random.h"

namespace moivre::test {
namespace {

Screws<double> random_screws(std::uint64_t number, Eigen::Index joints) {
  Screws<double> screws(6, joints);
  for (Eigen::Index k = 0; k < screws.size(); ++k) {
    const auto index = number * 100 + static_cast<std::uint64_t>(k);
    screws(k % 6, k / 6) = 2 * random_unit(5, RandomStream::test, index) - 1;
  }
  return screws;
}

void expect_same(const Screws<double>& screws) {
  const LeastMotion least = least_motion(screws);
  const Svd parts = svd(screws, SingularVectors::full);
  const Eigen::Index last = parts.sigma.size() - 1;
  EXPECT_NEAR(least.singular_value, parts.sigma[last], 1e-10 * parts.sigma[last] + 1e-15);
  EXPECT_NEAR(std::abs(least.joints.dot(parts.V.col(last))), 1, 1e-10);
  EXPECT_NEAR(std::abs(least.tip.dot(parts.U.col(last))), 1, 1e-8);
  EXPECT_LT((screws * least.joints - least.singular_value * least.tip).norm(), 1e-14);
}

TEST(LeastMotionTest, IsThatOfTheSingularValueDecomposition) {
  for (std::uint64_t k = 0; k < 300; ++k) {
    for (const Eigen::Index joints : {3, 4, 5, 6}) expect_same(random_screws(k, joints));
  }
}

TEST(LeastMotionTest, NextToSingularPosturesToo) {
  for (std::uint64_t k = 0; k < 30; ++k) {
    for (const double size : {1e-1, 1e-3, 1e-5, 1e-6, 1e-8, 1e-11}) {
      Screws<double> screws = random_screws(k, 6);
      const Velocity6<double> beside = screws.col(5);
      screws.col(5) = 0.3 * screws.col(0) - 0.8 * screws.col(3) + size * beside;
      const LeastMotion least = least_motion(screws);
      const double sigma = svd(screws, SingularVectors::full).sigma[5];
      EXPECT_NEAR(least.singular_value, sigma, 1e-6 * sigma + 1e-15) << size;
    }
  }
}

TEST(LeastMotionTest, OfEqualSingularValuesIsAnyOfTheirs) {
  Screws<double> screws = Screws<double>::Identity(6, 6);
  screws(0, 0) = 2;
  const LeastMotion least = least_motion(screws);
  EXPECT_NEAR(least.singular_value, 1, 1e-14);
  EXPECT_NEAR((screws * least.joints).norm(), 1, 1e-14);
}

}  // namespace
}  // namespace moivre::test
