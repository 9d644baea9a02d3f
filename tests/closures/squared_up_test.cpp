// SPDX-License-Identifier: MIT
// Do n random combinations of N equations keep the roots of all, and no degree grow?
#include "squared_up.h"

#include <gtest/gtest.h>

#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

System system_of(const std::string& equations) { return read_system({"f.phc", equations}); }

TEST(SquaredUp, KeepsTheDegreesOfTheHighestEquations) {
  const System g = squared_up(system_of("4 2\nx - 1;\nx^3 - y;\ny^2 - x;\nx*y - 1;\n"), 1);
  EXPECT_EQ(degrees(g), (std::vector<std::uint64_t>{3, 2}));
}

TEST(SquaredUp, LeavesASquareSystemAsItIsButForItsOrder) {
  const System f = system_of("2\nx - 1;\nx^3 - y;\n");
  const System g = squared_up(f, 1);
  EXPECT_EQ(g.polynomials[0], f.polynomials[1]);
  EXPECT_EQ(g.polynomials[1], f.polynomials[0]);
}

// (x-1)(y-2) = (x-1)(y-3) = 0 hold on all of x = 1, and nowhere else; with (y-5)(x-1) + (y-5) the point (1, 5) is left.
TEST(SquaredUp, CutsASetThatTwoOfThreeEquationsShare) {
  const System f =
      system_of("3 2\n(x - 1)*(y - 2);\n(x - 1)*(y - 3);\n(x - 1)*(y - 5) + (y - 5);\n");
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const SolveResult result = solve(squared_up(f, seed), *make_cvode_tracker());
    EXPECT_EQ(result.paths.on_positive_dimensional, 0u) << seed;
    bool is_found = false;
    for (const Solution& root : result.solutions) {
      is_found |= std::abs(root.x[0] - 1.0) < 1e-9 && std::abs(root.x[1] - 5.0) < 1e-9;
    }
    EXPECT_TRUE(is_found) << seed;
  }
}

}  // namespace
}  // namespace moivre
