// SPDX-License-Identifier: MIT
// Is a pose found among closures exactly where it is the same as one of them? That the others need
// no look is tested where they are told apart by their numbers: tests/numeric/near_points_test.cpp.
#include "solved_checkpoint.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mechanisms.h"
#include "moivre/closures/same_pose.h"

namespace moivre {
namespace {

void expect_found(const Mechanism& mechanism) {
  const Phi phi(mechanism);
  const SolvedCheckpoint solved = solved_checkpoint(phi, closures_of(mechanism));
  const std::vector<Closure>& closures = solved.closures.closures;
  ASSERT_GE(closures.size(), 2U);
  for (std::size_t j = 0; j < closures.size(); ++j) {
    for (Eigen::Index k = 0; k < phi.dimension(); ++k) {
      const double size = is_length(phi, k) ? size_of(phi, closures[j].q) : 1;
      Eigen::VectorXd q = closures[j].q;
      q[k] += 0.9 * kSamePose * size;
      EXPECT_EQ(nearest_closure(phi, solved, q), j);
      q[k] += 0.2 * kSamePose * size;
      EXPECT_EQ(nearest_closure(phi, solved, q), std::nullopt);
      if (is_length(phi, k)) continue;
      q[k] = closures[j].q[k] + 2 * std::numbers::pi;
      EXPECT_EQ(nearest_closure(phi, solved, q), j);
    }
  }
}

TEST(ClosuresOfAScene, AreFoundWithinTheToleranceAndNotBeyond) {
  expect_found(mechanism_file("jansen-leg"));
  expect_found(mechanism_file("stephenson-3"));
  expect_found(mechanism_file("slider-crank-equations"));
}

TEST(ClosuresOfAScene, AreNotFoundAmongNone) {
  const Mechanism m = mechanism_file("four-bar");
  const Phi phi(m);
  EXPECT_EQ(nearest_closure(phi, solved_checkpoint(phi, {}), initial_guess(m)), std::nullopt);
}

Solution root_at(double x, double condition) {
  Solution root;
  root.x = {Complex(x), Complex(2)};
  root.condition = condition;
  return root;
}

SolvedCheckpoint scene_with(const std::vector<Solution>& roots) {
  ClosureResult closures;
  closures.solutions = roots;
  return solved_checkpoint(Phi(mechanism_file("four-bar")), std::move(closures));
}

TEST(ClosuresOfAScene, AreCountedOnceWhereRoundingMayHavePartedADoubleOne) {
  const SolvedCheckpoint parted =
      scene_with({root_at(1 - 1e-8, 1e8), root_at(3, 10), root_at(1 + 1e-8, 1e8)});
  EXPECT_EQ(parted.distinct, 2U);
  EXPECT_FALSE(parted.are_apart);
  const SolvedCheckpoint near =
      scene_with({root_at(1 - 1e-6, 1e6), root_at(3, 10), root_at(1 + 1e-6, 1e6)});
  EXPECT_EQ(near.distinct, 3U);
  EXPECT_TRUE(near.are_apart);
  Solution twice = root_at(1, 1e8);
  twice.singular = true;
  const SolvedCheckpoint with_double = scene_with({twice, root_at(3, 10)});
  EXPECT_EQ(with_double.distinct, 2U);
  EXPECT_FALSE(with_double.are_apart);
}

}  // namespace
}  // namespace moivre
