// SPDX-License-Identifier: MIT
// Does what is put together in code mean what the same text means: polynomials, mechanisms, own
// starts, own functions, tables?
#include <algorithm>
#include <cmath>

#include "moivre/arms/pose_table.h"
#include "moivre/closures/closures.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/family/parameter_homotopy.h"
#include "moivre/kinematics/own_newton.h"
#include "moivre/mechanism/builder.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/read.h"
#include "moivre/polynomial/read.h"
#include "moivre/urdf/read.h"
#include "refused.h"

namespace moivre::test {
namespace {

TEST(Surface, PolynomialsAreWrittenAsOnPaper) {
  const auto [x, y] = unknowns<2>();
  Polynomial p = x * y - 1;
  p += x;
  p -= 2;
  p *= -1;
  const Rational half = 0.5;
  const Coefficient two = 2;
  const System f =
      make_system({"x", "y"}, {p, -x + two * pow(y, 3) * half - 0.25 + x / 4 - Rational(1, 3) * y});
  EXPECT_EQ(f, read_system({"text", "-x*y - x + 3; y^3 - x + x/4 - y/3 - 1/4;"}));
}

MechanismBuilder built_four_bar() {
  MechanismBuilder built("Four-bar");
  built.units("mm", "deg");
  built.ground({{"A", {0, 0}}, {"D", {100, 0}}});
  built.body("crank", {{"A", {0, 0}}, {"B", {40, 0}}});
  built.body("coupler", {{"B", {0, 0}}, {"C", {120, 0}}});
  built.body("rocker", {{"D", {0, 0}}, {"C", {80, 0}}});
  built.joint("revolute", {"ground.A", "crank.A"});
  built.joint("revolute", {"crank.B", "coupler.B"});
  built.joint("revolute", {"coupler.C", "rocker.C"});
  built.joint("revolute", {"ground.D", "rocker.D"}, {{"limits", {-170, 170}}});
  built.driver("angle", "crank", {{"start", 40}, {"velocity", 360}});
  return built;
}

TEST(Surface, AMechanismBuiltByNamesIsThatOfTheFile) {
  const Mechanism built = built_four_bar().build();
  EXPECT_EQ(built.bodies.size(), 4U);
  EXPECT_EQ(built.joints[3].name, "D");
  EXPECT_NEAR(built.joints[3].limits->upper, 170 * std::acos(-1.0) / 180, 1e-15);
  const ClosureResult own = find_closures(built, cvode());
  const ClosureResult of_file = find_closures(
      read_mechanism(read_source(MOIVRE_SOURCE_DIR "/problems/mechanisms/four-bar.toml")), cvode());
  ASSERT_EQ(own.closures.size(), of_file.closures.size());
  for (std::size_t k = 0; k < own.closures.size(); ++k) {
    EXPECT_LT((own.closures[k].q - of_file.closures[k].q).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(Surface, ABuilderSharesTheRulesOfTheReader) {
  MechanismBuilder built = built_four_bar();
  built.joint("revolte", {"ground.A", "crank.Z"});
  built.guess("crank.psi", 1);
  built.driver("angle", "crnk", {{"start", std::nan("")}});
  const std::string refusal = refusal_of([&] { (void)built.build(); });
  for (const char* word : {"'revolte'", "revolute", "crank.psi", "crnk", "finite"}) {
    EXPECT_NE(refusal.find(word), std::string::npos) << word << " in " << refusal;
  }
}

/// The broken rules of what was built.
std::vector<std::string> rules_broken_by(const MechanismBuilder& built) {
  try {
    (void)built.build();
  } catch (const ParseError&) {
    return {"a place in a text that nobody wrote"};
  } catch (const InvalidInput& refusal) {
    return refusal.broken_rules();
  }
  return {};
}

TEST(Surface, ABuilderTellsWhichBodyPointOrJointIsWrong) {
  MechanismBuilder built = built_four_bar();
  built.body("flag", {{"A", {0, 0}}, {"B", {1, 2, 3}}});
  built.joint("revolte", {"ground.A", "crank.Z"});
  built.joint("revolute", {"flag.A", "crank.Z"}, {{"limts", {0, 1}}});
  built.driver("angle", "crnk", {{"start", 1}});
  built.guess("crank.psi", 1);
  const std::vector<std::string> rules = rules_broken_by(built);
  const auto is_told = [&](const std::string& rule) {
    return std::any_of(rules.begin(), rules.end(),
                       [&](const std::string& each) { return each.starts_with(rule); });
  };
  for (const char* rule :
       {"body 'flag', point 'B': point 'flag.B' must be 2 numbers",
        "joint 5 (revolte at [ground.A, crank.Z]), 'type': unknown joint type 'revolte'",
        "joint 6 (revolute at [flag.A, crank.Z]), 'at': body 'crank' has no point 'Z'",
        "joint 6 (revolute at [flag.A, crank.Z]), 'limts': unknown key 'limts'",
        "driver 2, 'angle': there is no body 'crnk'", "guess, 'crank.psi': "}) {
    EXPECT_TRUE(is_told(rule)) << rule << " in " << ::testing::PrintToString(rules);
  }
  MechanismBuilder typed;
  typed.unknowns({"phi"}, {"s"});
  typed.equation("loop", "s - l*cos(phi");
  const std::vector<std::string> of_typed = rules_broken_by(typed);
  ASSERT_FALSE(of_typed.empty());
  EXPECT_TRUE(of_typed[0].starts_with("equations, 'loop': ")) << of_typed[0];
  MechanismBuilder twice = built_four_bar();
  twice.body("crank", {{"A", {0, 0}}});
  ASSERT_EQ(rules_broken_by(twice).size(), 1U);
  EXPECT_TRUE(rules_broken_by(twice)[0].starts_with("body 'crank': ")) << rules_broken_by(twice)[0];
}

TEST(Surface, APointIsAskedForByItsName) {
  const Mechanism four_bar = built_four_bar().build();
  const Eigen::VectorXd q = find_closures(four_bar, cvode()).closures.at(0).q;
  EXPECT_EQ(point_position(four_bar, "coupler.C", q), point_position(four_bar, {2, 1}, q));
  EXPECT_EQ(point_position(four_bar, std::string("ground.D"), q), Eigen::Vector3d(100, 0, 0));
  expect_refused([&] { return point_named(four_bar, "coupler.D"); },
                 "there is no point 'coupler.D'");
  expect_refused([&] { return point_position(four_bar, "coupler.CC", q); },
                 "did you mean 'coupler.C'?");
  expect_refused([&] { return point_position(four_bar, "coupler.C", q.head(3)); }, "q ");
}

TEST(Surface, ABuilderWritesWordsThatNeedCare) {
  MechanismBuilder built("a \"title\" with \\ and \n");
  EXPECT_EQ(built.text(), "title = \"a \\\"title\\\" with \\\\ and \\u000A\"\n");
  MechanismBuilder typed;
  typed.unknowns({"phi"}, {"s"});
  typed.constant("l", 0.1);
  typed.equation("loop", "s - l*cos(phi)");
  typed.driver("unknown", "phi", {{"start", 0.3}});
  EXPECT_EQ(typed.build().constants.at("l"), 0.1);
}

/// x^2 + y^2 = a, x y = b: +-(1, 2), +-(2, 1) at a = 5, b = 2.
ParameterProblem known_roots() {
  const auto [x, y, a, b] = unknowns<4>();
  return {make_system({"x", "y", "a", "b"}, {x * x + y * y - a, x * y - b}),
          {"a", "b"},
          {5, 2},
          {{1.0, 2.0}, {-1.0, -2.0}, {2.0, 1.0}, {-2.0, -1.0}}};
}

TEST(Surface, KnownRootsAreFollowedToOtherParameters) {
  const auto ends = track(known_roots(), {10, 3}, cvode());
  const double known[][2] = {{1, 3}, {-1, -3}, {3, 1}, {-3, -1}};
  for (std::size_t k = 0; k < 4; ++k) {
    ASSERT_TRUE(ends[k]);
    EXPECT_LT(std::abs((*ends[k])[0] - known[k][0]) + std::abs((*ends[k])[1] - known[k][1]), 1e-12);
  }
  for (const ParameterValues& to : {ParameterValues{10, 3}, {1, 3}, {-5, Rational(1, 7)}}) {
    const SolveResult result = solve(known_roots(), to, cvode());
    EXPECT_EQ(result.solutions.size(), 4U);
    for (const Solution& root : result.solutions) EXPECT_EQ(root.certified, true);
  }
}

TEST(Surface, AMissingStartIsAMissingRootAndSaid) {
  ParameterProblem problem = known_roots();
  problem.roots.pop_back();
  const SolveResult result = solve(problem, {10, 3}, cvode());
  EXPECT_EQ(result.solutions.size(), 3U);
  EXPECT_FALSE(result.complete);
  problem.roots.push_back({7.0, 7.0});
  EXPECT_FALSE(track(problem, {10, 3}, cvode()).back().has_value());
}

TEST(Surface, WrongStartsAreRefusedByName) {
  ParameterProblem problem = known_roots();
  problem.roots[1] = {1.0};
  problem.roots[2] = {std::nan(""), 1.0};
  problem.from = {5};
  expect_refused(
      [&] {
        return track(problem, {1, 2, 3}, cvode());
      },
      "p0 has 1 number, there are 2 parameters; p1 has 3 numbers, there are 2 "
      "parameters; start point 1 has 1 number, there are 2 unknowns; start point 2 has "
      "a number that is not finite");
}

TEST(Surface, NewtonFindsAZeroOfOnesOwnFunction) {
  const OwnFunction f{[](const Eigen::VectorXd& q) -> Eigen::VectorXd {
                        return Eigen::Vector2d(std::cos(q[0]) - q[1], q[0] - q[1]);
                      },
                      {}};
  const NewtonResult run = newton(f, Eigen::Vector2d(1, 1));
  EXPECT_EQ(run.status, NewtonStatus::converged) << run.message;
  EXPECT_NEAR(run.q[0], 0.73908513321516064, 1e-14);
  EXPECT_FALSE(run.is_singular);
  const OwnFunction square{
      [](const Eigen::VectorXd& q) -> Eigen::VectorXd { return q.cwiseProduct(q).array() + 1; },
      [](const Eigen::VectorXd& q) -> Eigen::MatrixXd { return (2 * q).asDiagonal(); }};
  EXPECT_NE(newton(square, Eigen::VectorXd::Constant(1, 1)).status, NewtonStatus::converged);
  const OwnFunction torn{square.value, [](const Eigen::VectorXd&) -> Eigen::MatrixXd {
                           return Eigen::MatrixXd::Ones(2, 3);
                         }};
  expect_refused([&] { return newton(torn, Eigen::VectorXd::Constant(1, 1)); },
                 "must be 1 x 1, not 2 x 3");
}

TEST(Surface, AGuessThatIsNoPlaceOfAnOwnFunctionIsRefused) {
  int calls = 0;
  const OwnFunction f{[&](const Eigen::VectorXd& q) -> Eigen::VectorXd {
                        ++calls;
                        return Eigen::Vector2d(std::cos(q[0]) - q[1], q[0] - q[1]);
                      },
                      {},
                      2};
  EXPECT_EQ(newton(f, Eigen::Vector2d(1, 1)).status, NewtonStatus::converged);
  calls = 0;
  expect_refused([&] { return newton(f, Eigen::VectorXd::Ones(1)); },
                 "the guess has 1 entry, the function has 2 unknowns");
  expect_refused([&] { return newton(f, Eigen::VectorXd::Ones(3)); },
                 "the guess has 3 entries, the function has 2 unknowns");
  expect_refused(
      [&] {
        return newton(OwnFunction{f.value, {}, -1}, Eigen::Vector2d(1, 1));
      },
      "the number of unknowns must be 0 or more");
  EXPECT_EQ(calls, 0) << "it would read behind the guess";
}

TEST(Surface, WhatAnOwnFunctionThrowsComesToTheCaller) {
  const OwnFunction f{[](const Eigen::VectorXd&) -> Eigen::VectorXd { throw 7; }, {}};
  EXPECT_THROW(newton(f, Eigen::VectorXd::Constant(1, 1)), int);
}

TEST(Surface, ATableHasTheRootsOfItsMembers) {
  const auto [x, p] = unknowns<2>();
  const Family family =
      learn(unlearned_family(make_system({"x", "p"}, {x * x - p}), {{"p", 1}}), cvode());
  std::vector<Complex> parameters;
  std::vector<Point> members;
  for (int k = -20; k <= 20; ++k) {
    parameters.emplace_back(k);
    members.push_back({Complex(k)});
  }
  const MemberTable table = solve_member_table(family, parameters, cvode());
  const std::vector<MemberRoots> roots = solve_members(family, members, cvode());
  ASSERT_EQ(table.members(), roots.size());
  for (std::size_t k = 0; k < roots.size(); ++k) {
    ASSERT_EQ(table.first[k + 1] - table.first[k], roots[k].roots.size());
    EXPECT_EQ(table.complete[k] == 1, roots[k].complete);
    for (std::size_t r = 0; r < roots[k].roots.size(); ++r) {
      EXPECT_EQ(table.points[table.first[k] + r], roots[k].roots[r].x[0]);
      EXPECT_EQ(table.real[table.first[k] + r] == 1, roots[k].roots[r].real);
    }
  }
}

TEST(Surface, ATableHasTheClosuresOfItsPoses) {
  const Arm arm =
      make_arm(read_urdf(read_source(MOIVRE_SOURCE_DIR "/problems/robots/puma560.urdf")), {});
  std::vector<Eigen::Isometry3d> poses;
  for (int k = 0; k < 20; ++k) {
    poses.push_back(forward_kinematics(arm, Eigen::VectorXd::Constant(6, 0.3 + 0.02 * k)));
  }
  const auto lanes = make_lane_tracker();
  const PoseTable table = tabulate_arm_closures(arm, poses, *lanes);
  const std::vector<ArmResult> results = find_arm_closures(arm, poses, *lanes);
  ASSERT_EQ(table.poses(), results.size());
  for (std::size_t k = 0; k < results.size(); ++k) {
    ASSERT_EQ(table.first[k + 1] - table.first[k], results[k].closures.size());
    for (std::size_t c = 0; c < results[k].closures.size(); ++c) {
      const Eigen::Map<const Eigen::VectorXd> values(table.values.data() + 6 * (table.first[k] + c),
                                                     6);
      EXPECT_EQ(Eigen::VectorXd(values), results[k].closures[c].in_limits);
    }
  }
}

}  // namespace
}  // namespace moivre::test
