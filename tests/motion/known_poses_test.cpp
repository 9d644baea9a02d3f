// SPDX-License-Identifier: MIT
// Is a pose found among closures exactly where it is the same as one of them?
#include "known_poses.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mechanisms.h"
#include "moivre/closures/same_pose.h"

namespace moivre {
namespace {

void expect_found(const Mechanism& mechanism) {
  const Phi phi(mechanism);
  const std::vector<Closure> closures = closures_of(mechanism).closures;
  const KnownPoses poses(phi, closures);
  ASSERT_GE(closures.size(), 2U);
  for (std::size_t j = 0; j < closures.size(); ++j) {
    for (Eigen::Index k = 0; k < phi.dimension(); ++k) {
      const double size = is_length(phi, k) ? size_of(phi, closures[j].q) : 1;
      Eigen::VectorXd q = closures[j].q;
      q[k] += 0.9 * kSamePose * size;
      EXPECT_EQ(poses.nearest(phi, closures, q), j);
      q[k] += 0.2 * kSamePose * size;
      EXPECT_EQ(poses.nearest(phi, closures, q), std::nullopt);
      if (is_length(phi, k)) continue;
      q[k] = closures[j].q[k] + 2 * std::numbers::pi;
      EXPECT_EQ(poses.nearest(phi, closures, q), j);
    }
  }
}

TEST(KnownPoses, AreFoundWithinTheToleranceAndNotBeyond) {
  expect_found(mechanism_file("jansen-leg"));
  expect_found(mechanism_file("stephenson-3"));
  expect_found(mechanism_file("slider-crank-equations"));
}

TEST(KnownPoses, AreNotFoundAmongNone) {
  const Mechanism m = mechanism_file("four-bar");
  const Phi phi(m);
  EXPECT_EQ(KnownPoses(phi, {}).nearest(phi, {}, initial_guess(m)), std::nullopt);
}

}  // namespace
}  // namespace moivre
