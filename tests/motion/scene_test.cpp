// SPDX-License-Identifier: MIT
// Is a pose found among closures exactly where it is the same as one of them? That the others need no look is tested where they are told
// apart by their numbers: tests/numeric/near_points_test.cpp.
#include "scene.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mechanisms.h"
#include "moivre/closures/same_pose.h"

namespace moivre {
namespace {

void expect_found(const Mechanism& mechanism) {
  const Phi phi(mechanism);
  const Scene scene = scene_of(phi, closures_of(mechanism));
  const std::vector<Closure>& closures = scene.closures.closures;
  ASSERT_GE(closures.size(), 2U);
  for (std::size_t j = 0; j < closures.size(); ++j) {
    for (Eigen::Index k = 0; k < phi.dimension(); ++k) {
      const double size = is_length(phi, k) ? size_of(phi, closures[j].q) : 1;
      Eigen::VectorXd q = closures[j].q;
      q[k] += 0.9 * kSamePose * size;
      EXPECT_EQ(nearest_closure(phi, scene, q), j);
      q[k] += 0.2 * kSamePose * size;
      EXPECT_EQ(nearest_closure(phi, scene, q), std::nullopt);
      if (is_length(phi, k)) continue;
      q[k] = closures[j].q[k] + 2 * std::numbers::pi;
      EXPECT_EQ(nearest_closure(phi, scene, q), j);
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
  EXPECT_EQ(nearest_closure(phi, scene_of(phi, {}), initial_guess(m)), std::nullopt);
}

}  // namespace
}  // namespace moivre
