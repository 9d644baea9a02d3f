// SPDX-License-Identifier: MIT
// From one root to all: published counts by loops, and the trace test true with all roots, false without one.
#include "moivre/family/monodromy.h"

#include <gtest/gtest.h>

#include "families.h"
#include "family_problems.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

MonodromyOptions with_seed(std::uint64_t seed) {
  MonodromyOptions options;
  options.seed = seed;
  return options;
}

TEST(Monodromy, FindsARandomPairWhereEveryEquationHasAParameterOfItsOwn) {
  const Family family =
      coefficient_family(read_system({"test", "2\nx*y - 3*x + i; y^2 + x*y - 2;\n"}));
  const auto pair = random_pair(family, 3);
  ASSERT_TRUE(pair);
  const Complex x = pair->x[0];
  const Complex y = pair->x[1];
  EXPECT_LT(std::abs(pair->p[0] * x * y + pair->p[1] * x + pair->p[2]), 1e-12);
  EXPECT_LT(std::abs(pair->p[3] * x * y + pair->p[4] * y * y + pair->p[5]), 1e-12);
  EXPECT_FALSE(random_pair(conics(), 1));                // its second equation ties x alone
  EXPECT_FALSE(random_pair(six_r_problem().family, 1));  // and so do the norms of axes
}

TEST(Monodromy, FindsAllRootsOfCoefficientFamiliesAndTheTraceTestHolds) {
  const auto lanes = make_lane_tracker();
  const System cyclic =
      read_system(read_source(MOIVRE_SOURCE_DIR "/problems/polynomials/cyclic-5.phc"));
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Family family = coefficient_family(cyclic);
    const auto pair = random_pair(family, seed);
    ASSERT_TRUE(pair);
    family = learn_by_monodromy(std::move(family), *pair, *lanes, with_seed(seed));
    EXPECT_EQ(family.roots.size(), 70U) << seed;
    EXPECT_TRUE(family.learning.complete) << family.learning.standing;
  }
}

TEST(Monodromy, TheTraceTestFailsWithoutOneRoot) {
  const auto lanes = make_lane_tracker();
  const Family whole = learn(stewart_problem().family, *lanes);
  ASSERT_EQ(whole.roots.size(), 40U);
  const TraceTest all = trace_test(whole, *lanes);
  EXPECT_TRUE(all.was_made);
  EXPECT_TRUE(all.holds) << all.defect;
  Family part = whole;
  part.roots.pop_back();
  const TraceTest missed = trace_test(part, *lanes);
  EXPECT_FALSE(missed.holds);
  EXPECT_EQ(missed.missing, 1U);
  // Without the points beside the roots the sums are not linear.
  MonodromyOptions without_loops;
  without_loops.quiet_loops = 0;
  const TraceTest few = trace_test(whole, *lanes, without_loops);
  EXPECT_TRUE(few.was_made);
  EXPECT_FALSE(few.holds);
  EXPECT_GT(few.defect, 1e-4);
}

TEST(Monodromy, AgreesWithDirectSolvesOnKinematics) {
  const auto lanes = make_lane_tracker();
  for (const FamilyProblem& problem : family_problems()) {
    const Family direct = learn(problem.family, *lanes);
    const KnownPair pair{direct.roots.front(), direct.generic};
    Family unlearned = problem.family;
    unlearned.nonzero = direct.nonzero;
    const Family found = learn_by_monodromy(unlearned, pair, *lanes, with_seed(2));
    EXPECT_EQ(found.roots.size(), problem.roots) << problem.name << ": " << found.learning.standing;
    EXPECT_TRUE(found.learning.complete) << problem.name << ": " << found.learning.standing;
  }
}

TEST(Monodromy, RefusesWhatIsNoRoot) {
  const auto lanes = make_lane_tracker();
  EXPECT_THROW(learn_by_monodromy(conics(), {{100, 200}, {1, 2, 3}}, *lanes),
               std::invalid_argument);
  EXPECT_THROW(learn_by_monodromy(conics(), {{1}, {1, 2, 3}}, *lanes), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
