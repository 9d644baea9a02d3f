// SPDX-License-Identifier: MIT
// From one root to all: published counts by loops, and the trace test true with all roots, false
// without one.
#include <gtest/gtest.h>

#include <array>

#include "families.h"
#include "family_problems.h"
#include "loop_problems.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/polynomial/value.h"
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
}

TEST(Monodromy, FindsARandomPairWhereParametersAreNotLinearOrTieNoEquation) {
  const auto lanes = make_lane_tracker();
  const Family squares = unlearned_family(
      read_system({"test", "2 4\nx^2*p^3 - y*q + p*q; x*y - p^2;\n"}), {{"p"}, {"q"}});
  for (const Family& family : {conics(), six_r_problem().family, squares}) {
    const auto pair = random_pair(family, 1);
    ASSERT_TRUE(pair);
    const SolveResult member = solve(member_system(family, exact_values(pair->p)), *lanes);
    EXPECT_TRUE(
        std::any_of(member.solutions.begin(), member.solutions.end(), [&](const Solution& root) {
          double distance = 0;
          for (std::size_t j = 0; j < root.x.size(); ++j) {
            distance = std::max(distance, std::abs(root.x[j] - pair->x[j]));
          }
          return !root.singular && distance < 1e-9 * std::max(1.0, max_norm(root.x));
        }));
  }
}

TEST(Monodromy, FindsNoPairWhereNoMemberHasARegularRoot) {
  const Family doubled = unlearned_family(read_system({"test", "1 2\n(x - p)^2;\n"}), {{"p"}});
  EXPECT_FALSE(random_pair(doubled, 1));
}

TEST(Monodromy, CountsConicsThatTouchConics) {
  const auto lanes = make_lane_tracker();
  const std::size_t published[] = {1, 6, 36, 184};
  for (int touched = 0; touched <= 3; ++touched) {
    const Family unlearned = conics_that_touch(touched);
    const auto pair = random_pair(unlearned, 5);
    ASSERT_TRUE(pair) << touched;
    MonodromyOptions options = with_seed(5);
    options.test = touched < 3;
    const Family family = learn_by_monodromy(unlearned, *pair, *lanes, options);
    EXPECT_EQ(family.roots.size(), published[touched]);
    EXPECT_EQ(family.learning.certified, published[touched]);
    EXPECT_EQ(family.learning.complete, options.test) << family.learning.standing;
  }
}

TEST(Monodromy, DoesNotSayThatLoopsBroughtNothingNewWhereALimitEndedThem) {
  const auto lanes = make_lane_tracker();
  const Family unlearned = conics_that_touch(2);
  const auto pair = random_pair(unlearned, 5);
  ASSERT_TRUE(pair);
  MonodromyOptions few_loops = with_seed(5);
  few_loops.most_loops = 1;
  MonodromyOptions few_roots = with_seed(5);
  few_roots.most_roots = 2;
  for (MonodromyOptions options : {few_loops, few_roots}) {
    options.test = options.certify = false;  // exact algebra would count them
    options.other_pairs = 0;
    const Family family = learn_by_monodromy(unlearned, *pair, *lanes, options);
    EXPECT_LT(family.roots.size(), 36u);
    EXPECT_FALSE(family.learning.complete);
    EXPECT_NE(family.learning.standing.find("until a limit of loops or roots ended them"),
              std::string::npos)
        << family.learning.standing;
  }
}

TEST(Monodromy, MakesNoTraceTestWhereALimitEndedTheLoopsOnItsCurve) {
  const auto lanes = make_lane_tracker();
  const Family unlearned = conics_that_touch(2);
  const auto pair = random_pair(unlearned, 5);
  ASSERT_TRUE(pair);
  MonodromyOptions options = with_seed(5);
  options.test = false;
  const Family family = learn_by_monodromy(unlearned, *pair, *lanes, options);
  ASSERT_EQ(family.roots.size(), 36u);
  options.most_roots = family.roots.size();
  EXPECT_FALSE(trace_test(family, *lanes, options).was_made);
  options.most_roots = 1000;
  EXPECT_TRUE(trace_test(family, *lanes, options).holds);
}

TEST(Monodromy, FindsTheSameOnSeveralThreads) {
  const auto lanes = make_lane_tracker();
  const Family unlearned = conics_that_touch(1);
  const auto pair = random_pair(unlearned, 2);
  ASSERT_TRUE(pair);
  MonodromyOptions options = with_seed(2);
  const Family alone = learn_by_monodromy(unlearned, *pair, *lanes, options);
  options.threads = 3;
  EXPECT_EQ(learn_by_monodromy(unlearned, *pair, *lanes, options), alone);
}

/// Two circles in turn on a third one: two pairs of roots that no loop joins, and fewer than any
/// bound allows.
TEST(Monodromy, TellsThatAFamilyIsReducible) {
  const auto lanes = make_lane_tracker();
  const Family unlearned = unlearned_family(
      read_system(
          {"test", "2 5\n(x^2 + y^2 - p*x)*(x^2 + y^2 - q*y - r); x^2 + y^2 - x - r*y - p*q;\n"}),
      {{"p"}, {"q"}, {"r"}});
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto pair = random_pair(unlearned, seed);
    ASSERT_TRUE(pair);
    const Family family = learn_by_monodromy(unlearned, *pair, *lanes, with_seed(seed));
    EXPECT_EQ(family.roots.size(), 4U);
    EXPECT_TRUE(family.learning.complete);
    EXPECT_EQ(family.learning.standing,
              "proved: as many certified roots as the dimension of the quotient ring allows; 1 "
              "times a random root was not among those that loops lead to: the family is "
              "reducible, or loops have lost roots");
    MonodromyOptions uncertified = with_seed(seed);
    uncertified.certify = false;
    const Family unproved = learn_by_monodromy(unlearned, *pair, *lanes, uncertified);
    EXPECT_FALSE(unproved.learning.complete);
    EXPECT_EQ(unproved.learning.standing,
              "1 times a random root was not among those that loops lead to: the family is "
              "reducible, or loops have lost roots; there may be more");
  }
}

/// The other component, or a third root of the same, is so many times as far away; beside a curve
/// no bound tells.
TEST(Monodromy, FindsFarRootsOrIsNotComplete) {
  const auto lanes = make_lane_tracker();
  const struct {
    std::string text;
    std::size_t roots;
  } families[] = {
      {"1 2\n(x - a)*(x - a - 10);\n", 2},
      {"1 2\n(x - a)*(x - a - 100000);\n", 2},
      {"1 2\nx^3/1000 + x^2 - a;\n", 3},
      {"1 2\nx^3/1000000 + x^2 - a;\n", 3},
      {"2 3\n(x + y - a)*(x - a)*(x - a - 30); (x + y - a)*(y - a*x - 1);\n", 2},
      {"2 3\n(x + y - a)*(x^3/1000 + x^2 - a); (x + y - a)*(y - a*x - 1);\n", 3},
  };
  for (const auto& [text, roots] : families) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Family family = unlearned_family(read_system({"test", text}), {{"a"}});
      const auto pair = random_pair(family, seed);
      ASSERT_TRUE(pair);
      family = learn_by_monodromy(std::move(family), *pair, *lanes, with_seed(seed));
      EXPECT_TRUE(family.roots.size() == roots || !family.learning.complete)
          << text << ": " << family.roots.size() << ", " << family.learning.standing;
    }
  }
}

TEST(Monodromy, AProvedBoundNeedsNoTraceTest) {
  const auto lanes = make_lane_tracker();
  const Family unlearned = unlearned_family(read_system({"test", "1 2\nx^2 - p^2;\n"}), {{"p"}});
  const auto pair = random_pair(unlearned, 1);
  ASSERT_TRUE(pair);
  const Family family = learn_by_monodromy(unlearned, *pair, *lanes, with_seed(1));
  EXPECT_EQ(family.roots.size(), 2U);
  ASSERT_TRUE(family.learning.bound);
  EXPECT_EQ(family.learning.bound->kind, BoundKind::bezout);
  EXPECT_TRUE(family.learning.complete);
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

/// (x, y) -> (-x, -y) is a symmetry of every member: roots come in pairs.
TEST(Monodromy, TheTraceTestFailsWithoutAWholeOrbit) {
  const auto lanes = make_lane_tracker();
  const Family unlearned = unlearned_family(
      read_system({"test", "2 6\nx^2 + p*x*y + q*y^2 - r; x^3 + s*x*y^2 + y^3 - x - r*y;\n"}),
      {{"p"}, {"q"}, {"r"}, {"s"}});
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto pair = random_pair(unlearned, seed);
    ASSERT_TRUE(pair);
    Family family = learn_by_monodromy(unlearned, *pair, *lanes, with_seed(seed));
    ASSERT_EQ(family.roots.size(), 6U);
    EXPECT_TRUE(trace_test(family, *lanes, with_seed(seed)).holds);
    const Point taken = family.roots.back();
    const std::size_t orbit = std::erase_if(family.roots, [&](const Point& root) {
      return std::min(std::abs(root[0] - taken[0]), std::abs(root[0] + taken[0])) < 1e-9;
    });
    ASSERT_EQ(orbit, 2U);
    const TraceTest test = trace_test(family, *lanes, with_seed(seed));
    EXPECT_TRUE(test.was_made);
    EXPECT_FALSE(test.holds);
    EXPECT_EQ(test.missing, 2U);
  }
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

/// One of the linkages published for the points of nine-point.csv: x, a, y, b. Their conjugates and
/// the coupler's turns follow.
TEST(Monodromy, TheNinePointSystemHoldsAPublishedLinkage) {
  const Family family = declared_family("nine-point.bertini");
  const std::vector<Point> members =
      read_members(read_source(MOIVRE_SOURCE_DIR "/problems/families/nine-point.csv"), family);
  ASSERT_EQ(members.size(), 1U);
  const Point& p = members.front();
  const Complex x(-1.3312540705576015, -0.8544136936297421);
  const Complex a(-0.33884611544501125, -0.7568765326936728);
  const Complex y(-1.7054407480694351, -0.2622477491324417);
  const Complex b(-0.6738143864007782, -0.18325576331690963);
  Point z{x, std::conj(x), a, std::conj(a), y, std::conj(y), b, std::conj(b)};
  z.resize(24);
  for (std::size_t j = 0; j < 8; ++j) {
    const Complex d = p[j];
    EXPECT_EQ(p[j + 8], std::conj(d));
    // Two linear equations, of the left and of the right crank, in g and its conjugate.
    const auto row = [&](const Complex& crank, const Complex& pivot) {
      return std::array<Complex, 3>{std::conj(pivot - d) * crank, (pivot - d) * std::conj(crank),
                                    std::norm(d) - 2 * ((std::conj(pivot - crank)) * d).real()};
    };
    const auto left = row(x, a);
    const auto right = row(y, b);
    const Complex det = left[0] * right[1] - left[1] * right[0];
    z[8 + j] = (left[2] * right[1] - left[1] * right[2]) / det;
    z[16 + j] = (left[0] * right[2] - left[2] * right[0]) / det;
  }
  const System member = member_system(family, exact_values(p));
  for (const Polynomial& f : member.polynomials) EXPECT_LT(std::abs(value_at(f, z)), 1e-7);
}

TEST(Monodromy, RefusesWhatIsNoRoot) {
  const auto lanes = make_lane_tracker();
  EXPECT_THROW(learn_by_monodromy(conics(), {{100, 200}, {1, 2, 3}}, *lanes),
               std::invalid_argument);
  EXPECT_THROW(learn_by_monodromy(conics(), {{1}, {1, 2, 3}}, *lanes), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
