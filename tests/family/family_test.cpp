// SPDX-License-Identifier: MIT
// A family once learned gives every member the roots that a direct solve finds, special members
// too.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "families.h"
#include "moivre/family/members.h"
#include "moivre/polynomial/digits.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

std::vector<Point> points_of(const SolveResult& result) {
  std::vector<Point> points;
  for (const Solution& root : result.solutions) points.push_back(root.x);
  return points;
}

SolveOptions with_seed(std::uint64_t seed) {
  SolveOptions options;
  options.seed = seed;
  options.threads = 1;
  return options;
}

TEST(Learn, PutsParametersBehindTheUnknowns) {
  const Family family =
      unlearned_family(read_system({"test", "1 3\na*x + b*x^2 - 1;\n"}), {{"b"}, {"a", 10}});
  EXPECT_EQ(family.system.variables, (std::vector<std::string>{"x", "b", "a"}));
  EXPECT_EQ(family.sizes, (std::vector<double>{1, 10}));
  EXPECT_EQ(member_system(family, {Coefficient{2, 0}, Coefficient{3, 0}}),
            read_system({"test", "1\n3*x + 2*x^2 - 1;\n"}));
}

TEST(Learn, KeepsHowItsEquationsWereBroughtIntoTheRangeOfDouble) {
  const System typed = read_system({"test", "2 3\n1e400*(x*y - a); 0.123456789012*x^2 - a*y;\n"});
  const Family family = unlearned_family(typed, {{"a"}});
  const System member = member_system(family, {Coefficient{3, 0}});
  EXPECT_EQ(member.scaled_log2, typed.scaled_log2);
  const CoefficientErrors errors = coefficient_errors(member);
  ASSERT_EQ(errors.size(), 2U);
  for (const NumberErrors& error : errors[0]) EXPECT_TRUE(error.empty());
  const SolveResult result = solve(member, *make_lane_tracker(), with_seed(1));
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.solutions.size(), 3U);
}

TEST(Learn, DrawsAMemberWhoseNumbersAreShort) {
  const Family family =
      unlearned_family(read_system({"test", "1 3\na*x + b*x^2 - 1;\n"}), {{"b"}, {"a", 100}});
  std::set<std::pair<double, double>> drawn;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Point p = generic_member(family, seed);
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_GE(std::abs(p[j]), 0.49 * family.sizes[j]);
      EXPECT_LE(std::abs(p[j]), 1.51 * family.sizes[j]);
      const Complex whole = std::ldexp(1, 20 - std::ilogb(family.sizes[j])) * p[j];
      EXPECT_EQ(whole, Complex(std::round(whole.real()), std::round(whole.imag())));
    }
    drawn.insert({p[0].real(), p[1].imag()});
  }
  EXPECT_EQ(drawn.size(), 100U);
}

TEST(Learn, DrawsFiniteNumbersOfAnySize) {
  for (const double size : {1e-320, 1e-300, 1e300}) {
    const Family family = unlearned_family(read_system({"test", "1 2\nx - a;\n"}), {{"a", size}});
    const Complex p = generic_member(family, 1).front();
    EXPECT_GT(std::abs(p), 0.4 * size);
    EXPECT_LT(std::abs(p), 1.6 * size);
  }
}

TEST(Learn, NamesEveryFaultOfTheParameters) {
  const System system = read_system({"test", "1 3\na*x + b*x^2 - 1;\n"});
  try {
    unlearned_family(system, {{"c"}, {"a"}, {"a"}, {"b", -1}});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "the system has no name c; its names are a, x, b; the parameter a is named twice; "
              "the size of the parameter b must be positive");
  }
  EXPECT_THROW(unlearned_family(system, {{"a"}}), std::invalid_argument);
  EXPECT_THROW(unlearned_family(system, {}), std::invalid_argument);
}

TEST(Learn, FindsTheGenericRootsWithEverySeed) {
  const auto lanes = make_lane_tracker();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Family family = learn(conics(), *lanes, with_seed(seed));
    EXPECT_EQ(family.roots.size(), 4U);
    EXPECT_TRUE(family.learning.complete);
    ASSERT_TRUE(family.learning.bound);
    EXPECT_EQ(family.learning.bound->value, 4U);
    EXPECT_EQ(learn(four_bar(), *lanes, with_seed(seed)).roots.size(), 2U);
  }
}

TEST(SolveMember, FindsTheRootsOfADirectSolveWithBothTrackers) {
  const auto lanes = make_lane_tracker();
  const auto cvode = make_cvode_tracker();
  const Family family = learn(conics(), *lanes, with_seed(1));
  for (std::uint64_t k = 0; k < 20; ++k) {
    const ParameterValues p = exact_values(random_member(3, k));
    const SolveResult direct = solve(member_system(family, p), *lanes, with_seed(2));
    for (const Tracker* tracker : {lanes.get(), cvode.get()}) {
      const SolveResult result = solve_member(family, p, *tracker, with_seed(1));
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_EQ(result.start.source, StartSource::family);
      EXPECT_EQ(result.paths.tracked, 4U);
      EXPECT_EQ(result.completeness, RootCompleteness::proved);
      EXPECT_TRUE(are_same(points_of(result), points_of(direct), 1e-9));
    }
  }
}

TEST(SolveMember, JudgesTheEndsOfSpecialMembers) {
  const auto lanes = make_lane_tracker();
  const Family family = learn(conics(), *lanes, with_seed(1));
  // y^2 = c, and c = 0: every root is double.
  const SolveResult doubled = solve_member(family, {{}, {}, {}}, *lanes, with_seed(1));
  EXPECT_TRUE(doubled.complete) << doubled.message;
  ASSERT_EQ(doubled.solutions.size(), 2U);
  for (const Solution& root : doubled.solutions) EXPECT_EQ(root.multiplicity, 2U);
  // Two circles, a = 1, b = 0: two roots at infinity.
  const SolveResult circles =
      solve_member(family, {Coefficient{1, 0}, {}, Coefficient{2, 0}}, *lanes, with_seed(1));
  EXPECT_TRUE(circles.complete) << circles.message;
  EXPECT_EQ(circles.paths.at_infinity, 2U);
  EXPECT_EQ(circles.solutions.size(), 2U);
  // Coefficients that are no straight line: a b x^2 + a x + b, with a root at infinity for b = 0.
  const Family squares =
      learn(unlearned_family(read_system({"test", "1 3\na*b*x^2 + a*x + b;\n"}), {{"a"}, {"b"}}),
            *lanes, with_seed(1));
  EXPECT_EQ(squares.roots.size(), 2U);
  const SolveResult linear =
      solve_member(squares, {Coefficient{1, 0}, Coefficient{0, 0}}, *lanes, with_seed(1));
  EXPECT_TRUE(linear.complete) << linear.message;
  EXPECT_EQ(linear.paths.at_infinity, 1U);
  ASSERT_EQ(linear.solutions.size(), 1U);
  EXPECT_LT(std::abs(linear.solutions.front().x[0]), 1e-9);
  const SolveResult meeting =
      solve_member(squares, {Coefficient{4, 0}, Coefficient{1, 0}}, *lanes, with_seed(1));
  ASSERT_EQ(meeting.solutions.size(), 1U);
  EXPECT_EQ(meeting.solutions.front().multiplicity, 2U);
}

// Four roots, and a line of roots, for which exact algebra has no number either.
TEST(SolveMember, TellsNoMoreThanTheFamilyWasLearned) {
  const auto lanes = make_lane_tracker();
  Family family =
      learn(unlearned_family(
                read_system({"test", "2 4\n(x + y - 1)*(x^2 + y^2 - a); (x + y - 1)*(x*y - b);\n"}),
                {{"a"}, {"b"}}),
            *lanes, with_seed(1));
  const ParameterValues p = exact_values(random_member(2, 0));
  family.learning.bound.reset();
  family.learning.complete = true;
  EXPECT_EQ(solve_member(family, p, *lanes, with_seed(1)).completeness, RootCompleteness::shown);
  family.learning.complete = false;
  EXPECT_EQ(solve_member(family, p, *lanes, with_seed(1)).completeness, RootCompleteness::open);
}

}  // namespace
}  // namespace moivre
