// SPDX-License-Identifier: MIT
// Are roots told that are wanted, the others counted, and those on denominators no roots?
#include "moivre/solver/filter.h"

#include <gtest/gtest.h>

#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

SolveResult solved(const std::string& text) {
  static const std::unique_ptr<Tracker> tracker = make_cvode_tracker();
  return solve(read_system({"text", text}), *tracker);
}

std::uint64_t sum_of(const SolveResult& result) {
  std::uint64_t sum = result.on_denominators + result.filtered + result.excess +
                      result.paths.on_positive_dimensional;
  for (const Solution& root : result.solutions) sum += root.multiplicity;
  return sum;
}

TEST(Denominators, RootsOnThemAreDroppedAndCounted) {
  // (x^2 - 1)/(x - 1) = y, x*y = 6: x = 1 makes the denominator zero, the roots are 2, 3 and -3,
  // -2.
  const SolveResult result = solved("(x^2 - 1)/(x - 1) - y; x*y - 6;");
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.solutions.size(), 2U);
  EXPECT_EQ(result.on_denominators, 1U);
  EXPECT_EQ(result.paths.finite, sum_of(result));
  for (const Solution& root : result.solutions) {
    EXPECT_LT(std::abs(root.x[0] * root.x[1] - 6.0), 1e-12);
    EXPECT_LT(std::abs(root.x[0] + 1.0 - root.x[1]), 1e-12);
  }
}

TEST(Denominators, ARootBesideADenominatorIsARoot) {
  for (const std::string gap : {"1e-3", "1e-9", "1e-14"}) {
    const SolveResult result = solved("(x - 1 - " + gap + ")*(x - 3)/(x - 1); y - x;");
    EXPECT_EQ(result.solutions.size(), 2U) << gap;
    EXPECT_EQ(result.on_denominators, 0U) << gap;
  }
}

TEST(Denominators, HillTermsHaveTheirSteadyStates) {
  // x' = 4 x^2 / (1 + x^2) - x: 0 and 2 +- sqrt(3).
  const SolveResult result = solved("4*x^2/(1 + x^2) = x;");
  ASSERT_EQ(result.solutions.size(), 3U);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
  EXPECT_TRUE(result.solutions[0].real && result.solutions[1].real && result.solutions[2].real);
}

TEST(Denominators, AllRootsMayLieOnThem) {
  const SolveResult result = solved("x/x - y; (y - 1)*x^2/x;");
  EXPECT_EQ(result.solutions.size(), 0U);
}

/// x = 0, y^2 + z^2 = 1 is a circle of roots; x = -4, y = 1, z = 2 stands alone.
constexpr const char* kCircleAndPoint = "x*(y - 1); x*(z - 2); x + y^2 + z^2 - 1;";

TEST(PointsOfSets, AreToldWithThePathsThatEndThere) {
  const SolveResult result = solved(kCircleAndPoint);
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.solutions.size(), 1U);
  ASSERT_FALSE(result.on_sets.empty());
  std::uint64_t paths = 0;
  for (const Solution& point : result.on_sets) {
    EXPECT_LT(std::abs(point.x[0]), 1e-7);
    EXPECT_LT(std::abs(point.x[1] * point.x[1] + point.x[2] * point.x[2] - 1.0), 1e-7);
    paths += point.multiplicity;
  }
  EXPECT_EQ(paths, result.paths.on_positive_dimensional);
}

TEST(PointsOfSets, AreThoseOfTheFileAndNotOfItsCombinations) {
  // A fourth equation that two points of the circle meet: the combinations have curves that the
  // file has not.
  const SolveResult result = solved(std::string(kCircleAndPoint) + " (x + 4)*(y - z);");
  for (const Solution& point : result.on_sets) {
    EXPECT_LT(std::abs((point.x[0] + 4.0) * (point.x[1] - point.x[2])), 1e-6);
  }
}

TEST(Planes, AreToldWhetherAPathEndsThereOrNot) {
  // x = y = 0 is a line of roots; the others are x = +-1, y = -1, z = -1.
  const std::string line = "x*z + x; y + x^2*y^2*z^2; x*y + x;";
  const SolveResult told = solved(line);
  ASSERT_EQ(told.planes.size(), 1U) << told.message;
  EXPECT_EQ(told.planes[0], (CoordinatePlane{{0, 2}, 1}));
  for (const auto& [text, is_kept] :
       {std::pair("y > -1", true), {"y < 0", false}, {"z > 5", true}}) {
    SolveResult result = told;
    RootFilter wanted;
    wanted.conditions = {read_conditions({"conditions", text}, told.system.variables)[0]};
    keep_wanted(wanted, result);
    EXPECT_EQ(result.planes.size(), is_kept ? 1U : 0U) << text;
  }
}

TEST(PointsOfSets, WhereADenominatorIsZeroAreNone) {
  const SolveResult result = solved("x*(y - 1)/x; x*(z - 2); x + y^2 + z^2 - 1;");
  EXPECT_TRUE(result.on_sets.empty());
}

TEST(PointsOfSets, AreFilteredLikeRoots) {
  SolveResult result = solved(kCircleAndPoint);
  RootFilter wanted;
  wanted.positive = true;
  keep_wanted(wanted, result);
  EXPECT_TRUE(result.on_sets.empty()) << "x is 0 on the circle";
}

TEST(Filter, KeepsWhatIsWantedAndCountsTheRest) {
  const std::string circle = "x^2 + y^2 - 5; x*y - 2;";  // +-(1, 2), +-(2, 1)
  const SolveResult all = solved(circle);
  ASSERT_EQ(all.solutions.size(), 4U);
  SolveResult positive = all;
  keep_wanted({.positive = true}, positive);
  EXPECT_EQ(positive.solutions.size(), 2U);
  EXPECT_EQ(positive.filtered, 2U);
  EXPECT_EQ(positive.completeness, all.completeness);
  EXPECT_EQ(positive.paths.finite, sum_of(positive));
  for (const PathRecord& path : positive.ledger) {
    EXPECT_TRUE(path.solution == PathRecord::kNoSolution || path.solution < 2U);
  }
  SolveResult boxed = all;
  keep_wanted({.box = {{"x", 0, 1.5}, {"y", -10, 10}}}, boxed);
  ASSERT_EQ(boxed.solutions.size(), 1U);
  EXPECT_NEAR(boxed.solutions[0].x[0].real(), 1, 1e-12);
  SolveResult edge = all;
  keep_wanted({.box = {{"x", 2, 3}}}, edge);
  EXPECT_EQ(edge.solutions.size(), 1U) << "a root on the edge of the box is in it";
}

TEST(Filter, RealAndNonzero) {
  SolveResult real = solved("x^3 - 1; y - x;");
  keep_wanted({.real = true}, real);
  EXPECT_EQ(real.solutions.size(), 1U);
  EXPECT_EQ(real.filtered, 2U);
  SolveResult nonzero = solved("x*(x - 3); y*(y - 2);");
  keep_wanted({.nonzero = true}, nonzero);
  EXPECT_EQ(nonzero.solutions.size(), 1U);
  SolveResult positive = solved("x*(x - 3); y*(y - 2);");
  keep_wanted({.positive = true}, positive);
  EXPECT_EQ(positive.solutions.size(), 1U);
}

/// The roots that meet the conditions of the text itself.
SolveResult kept(const std::string& text) {
  SolveResult result = solved(text);
  keep_wanted({.conditions = read_system({"text", text}).conditions}, result);
  return result;
}

TEST(FilterConditions, KeepTheRealRootsThatMeetThemAll) {
  const std::string circle = "x^2 + y^2 - 5; x*y - 2; ";  // +-(1, 2), +-(2, 1)
  EXPECT_EQ(kept(circle + "x > 0;").solutions.size(), 2U);
  EXPECT_EQ(kept(circle + "x > 0; x < y;").solutions.size(), 1U);
  EXPECT_EQ(kept(circle + "0 < x < 3/2;").solutions.size(), 1U);
  EXPECT_EQ(kept(circle + "x^2*y > 3;").solutions.size(), 1U);
  const SolveResult none = kept(circle + "x*y <= 1;");
  EXPECT_TRUE(none.solutions.empty());
  EXPECT_EQ(none.filtered, 4U);
  EXPECT_EQ(none.paths.finite, sum_of(none));
  EXPECT_EQ(none.completeness, RootCompleteness::proved);
  EXPECT_EQ(kept("x^4 - 1; x < 5;").solutions.size(), 2U) << "i is not real";
}

TEST(FilterConditions, SayWhatIsOnTheBoundaryAsFarAsDigitsTell) {
  // x y is 2 at every root.
  const std::string circle = "x^2 + y^2 - 5; x*y - 2; ";
  const SolveResult closed = kept(circle + "x*y <= 2;");
  ASSERT_EQ(closed.solutions.size(), 4U);
  for (const Solution& root : closed.solutions) {
    EXPECT_EQ(root.on_boundary, std::vector<std::string>{"x*y <= 2"});
  }
  const SolveResult open = kept(circle + "x*y < 2;");
  EXPECT_TRUE(open.solutions.empty());
  EXPECT_NE(open.left_out.back().why.find("4 of them on its boundary"), std::string::npos)
      << open.left_out.back().why;
  const SolveResult inside = kept(circle + "x*y <= 2 + 1e-9;");
  ASSERT_EQ(inside.solutions.size(), 4U);
  EXPECT_TRUE(inside.solutions[0].on_boundary.empty());
}

TEST(FilterConditions, AreDecidedAsFarAsTheAccuracyOfTheRootReaches) {
  // Roots 1 and 1 + 1e-9: 1e-12 beside them is told, 1e-20 is not.
  const std::string pair = "(x - 1)*(x - 1 - 1e-9); y - 1e6*x; ";
  for (const auto& [bound, told, on_boundary] :
       {std::tuple{"1 - 1e-12", 2U, 0U}, {"1 + 1e-12", 1U, 0U}, {"1 + 1e-20", 1U, 1U}}) {
    const SolveResult result = kept(pair + "1e6*x > 1e6*(" + bound + ");");
    EXPECT_EQ(result.solutions.size(), told) << bound;
    const std::string& why = result.left_out.back().why;
    EXPECT_EQ(why.find("on its boundary") != std::string::npos, on_boundary > 0) << why;
  }
}

TEST(FilterConditions, HoldWithinTheAccuracyOfTheRoot) {
  Solution root;
  root.x = {1.0, 1000.0};
  root.real = true;
  root.accuracy = 1e-3;  // of the largest coordinate: x may be 0 or 2
  SolveResult result;
  result.system.variables = {"x", "y"};
  result.solutions = {root};
  const Polynomial x = unknown(0);
  SolveResult closed = result;
  keep_wanted({.conditions = {{x - Rational(3, 2), false, "x >= 3/2"}}}, closed);
  ASSERT_EQ(closed.solutions.size(), 1U);
  EXPECT_EQ(closed.solutions[0].on_boundary.size(), 1U);
  keep_wanted({.conditions = {{x - 3, false, "x >= 3"}}}, result);
  EXPECT_TRUE(result.solutions.empty());
}

TEST(FilterConditions, PointsOfSetsAreKeptWhereTheyMeetThem) {
  for (const auto& [text, is_kept] : {std::pair{"x > -1", true}, {"x > 1", false}}) {
    SolveResult result;
    result.system.variables = {"x"};
    Solution point;
    point.x = {0.0};
    point.real = true;
    result.on_sets = {point};
    keep_wanted({.conditions = read_conditions({"condition", text}, {"x"})}, result);
    EXPECT_EQ(result.on_sets.size(), is_kept ? 1U : 0U) << text;
    result.on_sets = {point};
    result.on_sets[0].real = false;
    keep_wanted({.conditions = read_conditions({"condition", text}, {"x"})}, result);
    EXPECT_TRUE(result.on_sets.empty()) << text;
  }
}

TEST(FilterConditions, OfAClusterHoldWithinItsRadius) {
  Solution cluster;
  cluster.x = {1.0};
  cluster.real = cluster.cluster = true;
  cluster.accuracy = 1e-15;
  cluster.radius = 1e-3;
  cluster.multiplicity = 2;
  SolveResult result;
  result.system.variables = {"x"};
  result.solutions = {cluster};
  const Polynomial x = unknown(0);
  keep_wanted({.conditions = {{x - Rational(9999, 10000), false, "x >= 0.9999"}}}, result);
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_EQ(result.solutions[0].on_boundary.size(), 1U);
}

TEST(FilterConditions, WhoseValuesLeaveDoubleAreNotDecided) {
  Solution root;
  root.x = {1e200};
  root.real = true;
  SolveResult result;
  result.system.variables = {"x"};
  result.solutions = {root};
  const Polynomial x = unknown(0);
  keep_wanted({.conditions = {{pow(x, 3) - pow(x, 2), false, "x^3 >= x^2"}}}, result);
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_EQ(result.solutions[0].on_boundary.size(), 1U);
}

TEST(Filter, RefusesWhatCannotBeMeant) {
  SolveResult result = solved("x - 1;");
  EXPECT_THROW(keep_wanted({.box = {{"z", 0, 1}}}, result), InvalidInput);
  EXPECT_THROW(keep_wanted({.box = {{"x", 1, 0}}}, result), InvalidInput);
  EXPECT_THROW(keep_wanted({.box = {{"x", std::nan(""), 0}}}, result), InvalidInput);
  EXPECT_THROW(keep_wanted({.conditions = {{unknown(1), true, "y > 0"}}}, result), InvalidInput);
}

}  // namespace
}  // namespace moivre
