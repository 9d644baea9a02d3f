// SPDX-License-Identifier: MIT
// Do blocks by formula have the roots that their paths lead to, and is what is not clear left to
// paths?
#include "quadratic_block.h"

#include <gtest/gtest.h>

#include "mechanisms.h"

namespace moivre {
namespace {

ClosureResult with_start(const Mechanism& mechanism, StartKind start) {
  ClosureOptions options;
  options.solve.threads = 1;
  options.solve.start = start;
  return find_closures(mechanism, *make_cvode_tracker(), options);
}

double distance(const Point& a, const Point& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, std::abs(a[v] - b[v]));
  return largest / std::max(1.0, max_norm(a));
}

TEST(BlocksByFormula, HaveTheRootsThatPathsLeadTo) {
  for (const char* name : {"four-bar", "slider-crank", "inverted-slider-crank", "scotch-yoke",
                           "whitworth", "watt-1", "stephenson-3", "jansen-leg"}) {
    const Mechanism mechanism = mechanism_file(name);
    const ClosureResult formula = with_start(mechanism, StartKind::automatic);
    const ClosureResult paths = with_start(mechanism, StartKind::total_degree);
    EXPECT_EQ(formula.work.accepted, 0u) << name;
    EXPECT_EQ(formula.paths, paths.paths) << name;
    EXPECT_EQ(formula.reduced.degrees, paths.reduced.degrees) << name;
    EXPECT_EQ(formula.completeness, paths.completeness) << name;
    ASSERT_EQ(formula.solutions.size(), paths.solutions.size()) << name;
    for (const Solution& root : formula.solutions) {
      const auto same =
          std::find_if(paths.solutions.begin(), paths.solutions.end(),
                       [&](const Solution& other) { return distance(root.x, other.x) <= 1e-14; });
      ASSERT_NE(same, paths.solutions.end()) << name;
      EXPECT_EQ(root.real, same->real) << name;
      EXPECT_NEAR(root.condition / same->condition, 1, 1e-9) << name;
      EXPECT_LE(root.accuracy, 1e-15) << name;
    }
  }
}

// Stretched rods of lengths 3 and 4 over a distance of 7, and of a little less: two roots in one
// place, and nearly so.
Mechanism stretched(double distance) {
  return mechanism_text("[ground.points]\nA = [0, 0]\nB = [" + std::to_string(distance) +
                        ", 0]\n[body.left.points]\nA = [0, 0]\nC = [3, 0]\n"
                        "[body.right.points]\nC = [0, 0]\nB = [4, 0]\n"
                        "[[joint]]\ntype = \"revolute\"\nat = [\"ground.A\", \"left.A\"]\n"
                        "[[joint]]\ntype = \"revolute\"\nat = [\"left.C\", \"right.C\"]\n"
                        "[[joint]]\ntype = \"revolute\"\nat = [\"right.B\", \"ground.B\"]\n");
}

TEST(BlocksByFormula, AreNoneWhereRootsMeet) {
  const ClosureResult meeting = with_start(stretched(7), StartKind::automatic);
  EXPECT_GT(meeting.work.accepted, 0u);
  ASSERT_EQ(meeting.solutions.size(), 1u);
  EXPECT_EQ(meeting.solutions.front().multiplicity, 2u);
  EXPECT_EQ(with_start(stretched(6.5), StartKind::automatic).work.accepted, 0u);
}

TEST(BlocksByFormula, HaveNoMoreRootsThanTheirBound) {
  const Formulation formulation = formulate(stretched(6.5), 0);
  const auto zero = std::make_shared<const Known>(Coefficient{0, 0});
  const std::vector<KnownValue> known(formulation.system.variables.size(), zero);
  for (const Block& block : block_structure(formulation.system).blocks) {
    const QuadraticBlock formula(formulation, block);
    const auto roots = formula.roots(known);
    if (!roots) continue;
    EXPECT_EQ(roots->size(), formula.bound());
  }
}

// No formula for six bodies that close together.
TEST(BlocksByFormula, LeaveHigherGroupsToTheirPaths) {
  const ClosureResult result = with_start(mechanism_file("assur-7-serial"), StartKind::automatic);
  EXPECT_GT(result.work.accepted, 0u);
}

}  // namespace
}  // namespace moivre
