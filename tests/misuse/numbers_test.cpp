// SPDX-License-Identifier: MIT
// Is NaN, and infinity, refused by name wherever a real number is taken?
#include <functional>
#include <limits>

#include "moivre/arms/arm_closures.h"
#include "moivre/arms/held_range.h"
#include "moivre/arms/pose_table.h"
#include "moivre/arms/posture.h"
#include "moivre/arms/rules.h"
#include "moivre/arms/turns.h"
#include "moivre/certify/certifier.h"
#include "moivre/closures/closures.h"
#include "moivre/closures/mobility_kinds.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/family/parameter_homotopy.h"
#include "moivre/formulation/formulation.h"
#include "moivre/kinematics/coefficients.h"
#include "moivre/kinematics/least_squares.h"
#include "moivre/kinematics/linear.h"
#include "moivre/kinematics/local_dimension.h"
#include "moivre/kinematics/mobility.h"
#include "moivre/kinematics/own_newton.h"
#include "moivre/kinematics/sensitivity.h"
#include "moivre/kinematics/state.h"
#include "moivre/mechanism/builder.h"
#include "moivre/mechanism/dimensions.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/read.h"
#include "moivre/mechanism/rules.h"
#include "moivre/motion/motion.h"
#include "moivre/multiprecision/reference_roots.h"
#include "moivre/solver/filter.h"
#include "moivre/sweep/sweep.h"
#include "moivre/urdf/read.h"
#include "refused.h"

namespace moivre::test {
namespace {

/// An entry, and what it is given.
struct TakesNumber {
  const char* name;
  std::function<void(double)> call;
};

/// Each refuses NaN and both infinities, and its words say which number is meant.
void expect_only_finite(const std::vector<TakesNumber>& entries) {
  for (const TakesNumber& entry : entries) {
    for (const double x : {kNaN, kInfinity, -kInfinity}) {
      SCOPED_TRACE(std::string(entry.name) + " = " + std::to_string(x));
      EXPECT_NE(refusal_of([&] { entry.call(x); }), "not refused");
    }
  }
}

TEST(NumbersTest, OfSystemsAndFamiliesAreFinite) {
  const auto [x, p] = unknowns<2>();
  const System f = make_system({"x", "p"}, {x * x - p});
  const System square = make_system({"x"}, {x * x - 2});
  const Family bare = unlearned_family(f, {{"p", 1}});
  const Family family = learn(bare, lanes());
  const ParameterProblem problem{f, {"p"}, {4}, {{2.0}, {-2.0}}};
  expect_only_finite({
      {"coefficient", [&, y = x](double n) { (void)(n * y); }},
      {"summand", [&, y = x](double n) { (void)(y + n); }},
      {"divisor", [&, y = x](double n) { (void)(y / n); }},
      {"Rational", [](double n) { (void)Rational(n); }},
      {"imaginary part", [](double n) { (void)Coefficient(Complex(1, n)); }},
      {"size",
       [&](double n) {
         unlearned_family(f, {{"p", n}});
       }},
      {"exact_value", [&](double n) { exact_value(Complex(1, n)); }},
      {"member", [&](double n) { solve_members(family, std::vector<Point>{{n}}, lanes()); }},
      {"imaginary part of a member",
       [&](double n) { solve_members(family, std::vector<Point>{{Complex(1, n)}}, lanes()); }},
      {"row", [&](double n) { solve_member_table(family, std::vector{Complex(n)}, lanes()); }},
      {"followed member",
       [&](double n) { follow_members(family, std::vector<Point>{{n}}, lanes()); }},
      {"start point",
       [&](double n) {
         ParameterProblem of = problem;
         of.roots[1][0] = Complex(2, n);
         track(of, {5}, lanes());
       }},
      {"x of a pair",
       [&](double n) {
         learn_by_monodromy(bare, {{n}, {1.0}}, lanes());
       }},
      {"p of a pair",
       [&](double n) {
         learn_by_monodromy(bare, {{1.0}, {n}}, lanes());
       }},
      {"size of a random pair", [&](double n) { random_pair(bare, 1, n); }},
      {"approximation", [&](double n) { reference_roots(square, {{n}}, 30, 1); }},
      {"accuracy of a certificate",
       [&](double n) {
         Certifier{make_certify_program(square), {n}};
       }},
  });
  // Half a line is a range.
  SolveResult result;
  result.system.variables = {"x"};
  keep_wanted({.box = {{"x", 0, kInfinity}}}, result);
  expect_refused([&] { keep_wanted({.box = {{"x", 0, kNaN}}}, result); }, "x");
}

TEST(NumbersTest, OfEndsOfPathsAndTrackersAreFinite) {
  const Polynomial x = unknown(0);
  const System f = make_system({"x"}, {x * x - 2});
  const auto with_end = [&](double EndParameters::*number) {
    return [&f, number](double n) {
      SolveOptions options;
      options.endgame.ends.*number = n;
      solve(f, lanes(), options);
    };
  };
  expect_only_finite({
      {"watch_radius", with_end(&EndParameters::watch_radius)},
      {"creeping_radius", with_end(&EndParameters::creeping_radius)},
      {"first_radius", with_end(&EndParameters::first_radius)},
      {"least_radius", with_end(&EndParameters::least_radius)},
      {"shrink", with_end(&EndParameters::shrink)},
      {"rounding", with_end(&EndParameters::rounding)},
      {"sample_error", with_end(&EndParameters::sample_error)},
      {"agreement", with_end(&EndParameters::agreement)},
      {"regular_condition", with_end(&EndParameters::regular_condition)},
      {"singular_condition", with_end(&EndParameters::singular_condition)},
      {"zero_sum", with_end(&EndParameters::zero_sum)},
      {"beyond", with_end(&EndParameters::beyond)},
      {"known_size", with_end(&EndParameters::known_size)},
      {"valuation_error", with_end(&EndParameters::valuation_error)},
      {"face_threshold", with_end(&EndParameters::face_threshold)},
      {"face_progress", with_end(&EndParameters::face_progress)},
      {"fine_rounding", with_end(&EndParameters::fine_rounding)},
      {"tolerance of lanes", [](double n) { make_lane_tracker({.tolerance = n}); }},
      {"rtol of CVODE", [](double n) { make_cvode_tracker({.rtol = n}); }},
  });
}

TEST(NumbersTest, OfMechanismsAndPosesAreFinite) {
  const Mechanism bar =
      read_mechanism(read_source(MOIVRE_SOURCE_DIR "/problems/mechanisms/four-bar.toml"));
  const Phi phi(bar);
  const Eigen::VectorXd q = find_closures(bar, lanes()).closures.front().q;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(q.size());
  const Phi joints = phi.without_drivers();
  const Partition partition = choose_partition(joints, q);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  const Eigen::MatrixXd by_one = Eigen::MatrixXd::Ones(phi.size(), 1);
  const auto spoiled = [&](double n) {
    Eigen::VectorXd wrong = q;
    wrong[4] = n;
    return wrong;
  };
  expect_only_finite({
      {"guess of Newton", [&](double n) { newton(phi, spoiled(n)); }},
      {"t of Newton", [&](double n) { newton(phi, q, n); }},
      {"tolerance of Newton",
       [&](double n) {
         NewtonOptions options;
         options.residual_tolerance = n;
         newton(phi, q, 0, options);
       }},
      {"guess of least squares", [&](double n) { least_squares_pose(phi, spoiled(n)); }},
      {"t of least squares", [&](double n) { least_squares_pose(phi, q, n); }},
      {"q of mobility", [&](double n) { mobility(phi, spoiled(n)); }},
      {"t of mobility", [&](double n) { mobility(phi, q, n); }},
      {"fit of mobility", [&](double n) { mobility(phi, q, 0, n); }},
      {"fit of a rank", [&](double n) { constraint_rank(phi, q, 0, n); }},
      {"q of a state", [&](double n) { motion_state(phi, spoiled(n), 0); }},
      {"t of a state", [&](double n) { motion_state(phi, q, n); }},
      {"t of a partition", [&](double n) { choose_partition(phi.without_drivers(), q, n); }},
      {"q of a partition's state",
       [&](double n) { partitioned_state(joints, partition, spoiled(n), one, one); }},
      {"velocity of a partition",
       [&](double n) {
         partitioned_state(joints, partition, q, Eigen::VectorXd::Constant(1, n), one);
       }},
      {"acceleration of a partition",
       [&](double n) {
         partitioned_state(joints, partition, q, one, Eigen::VectorXd::Constant(1, n));
       }},
      {"q of a sensitivity", [&](double n) { pose_sensitivity(phi, spoiled(n), 0, by_one); }},
      {"t of a sensitivity", [&](double n) { pose_sensitivity(phi, q, n, by_one); }},
      {"rate of a sensitivity", [&](double n) { pose_sensitivity(phi, q, 0, n * by_one); }},
      {"unit of a row",
       [](double n) {
         LinearOptions options;
         options.row_units = Eigen::Vector2d(1, n);
         Factorization(Eigen::Matrix2d::Identity(), options);
       }},
      {"unit of a column",
       [](double n) {
         LinearOptions options;
         options.column_units = Eigen::Vector2d(1, n);
         Factorization(Eigen::Matrix2d::Identity(), options);
       }},
      {"t of coefficients", [&](double n) { kinematic_coefficients(phi, q, n); }},
      {"q of a dimension", [&](double n) { local_dimension(phi, spoiled(n)); }},
      {"t of a dimension", [&](double n) { local_dimension(phi, q, n); }},
      {"q of a point",
       [&](double n) {
         point_position(bar, {1, 0}, spoiled(n));
       }},
      {"q' of a point",
       [&](double n) {
         point_state(bar, {1, 0}, q, spoiled(n), rest);
       }},
      {"q'' of points", [&](double n) { point_states(bar, q, rest, spoiled(n)); }},
      {"q of a body", [&](double n) { (void)orientation(bar, 1, spoiled(n)); }},
      {"q of a joint", [&](double n) { joint_coordinate(bar, bar.joints[0], spoiled(n)); }},
      {"q' of a joint", [&](double n) { joint_state(bar, bar.joints[0], q, spoiled(n), rest); }},
      {"q of a turn", [&](double n) { turn_state(bar, bar.joints[0], spoiled(n), rest, rest); }},
      {"q of limits", [&](double n) { (void)broken_limit(bar, spoiled(n)); }},
      {"time of a guess", [&](double n) { (void)initial_guess(bar, n); }},
      {"time of closures",
       [&](double n) {
         ClosureOptions options;
         options.time = n;
         find_closures(bar, lanes(), options);
       }},
      {"time of a formulation", [&](double n) { formulate(bar, n); }},
      {"time of mobility kinds", [&](double n) { find_mobility(bar, lanes(), n); }},
      {"time of driver values", [&](double n) { driver_values(bar, n); }},
      {"time of a dimension's value",
       [&](double n) { dimension_value(bar, dimensions(bar).back(), n); }},
      {"time of a duration", [&](double n) { (void)natural_duration(bar, n); }},
      {"dimension",
       [&](double n) {
         Mechanism other = bar;
         set_dimension(other, dimension_names(bar).front(), n);
         find_closures(other, lanes());
       }},
      {"row of a table",
       [](double n) {
         natural_spline({0, 1}, {0, n});
       }},
      {"time of a table",
       [](double n) {
         natural_spline({0, n}, {0, 1});
       }},
      {"row of a profile",
       [](double n) {
         periodic_spline({0, 1, 2, 3}, {n, 1, 2, n});
       }},
  });
}

TEST(NumbersTest, OfMotionsAndSweepsAreFinite) {
  const Mechanism bar =
      read_mechanism(read_source(MOIVRE_SOURCE_DIR "/problems/mechanisms/four-bar.toml"));
  const Eigen::VectorXd q = find_closures(bar, lanes()).closures.front().q;
  const auto with_branch = [&](double BranchOptions::*number) {
    return [&bar, &q, number](double n) {
      MotionOptions options;
      options.branch.*number = n;
      follow_guesses(bar, {q}, options);
    };
  };
  expect_only_finite({
      {"from",
       [&](double n) {
         MotionOptions options;
         options.from = n;
         find_motion(bar, lanes(), options);
       }},
      {"to",
       [&](double n) {
         MotionOptions options;
         options.to = n;
         follow_guesses(bar, {q}, options);
       }},
      {"guess",
       [&](double n) {
         Eigen::VectorXd wrong = q;
         wrong[2] = n;
         follow_guesses(bar, {q, wrong});
       }},
      {"pose of a branch",
       [&](double n) {
         Eigen::VectorXd wrong = q;
         wrong[2] = n;
         follow_branch(bar, wrong, {0, 1});
       }},
      {"time of a branch",
       [&](double n) {
         follow_branch(bar, q, {0, n});
       }},
      {"velocity_times",
       [&](double n) {
         BranchOptions options;
         options.velocity_times = std::vector<double>{n};
         follow_branch(bar, q, {0, 0.01}, options);
       }},
      {"largest_turn_rad", with_branch(&BranchOptions::largest_turn_rad)},
      {"largest_miss", with_branch(&BranchOptions::largest_miss)},
      {"longest_step", with_branch(&BranchOptions::longest_step)},
      {"largest_approach", with_branch(&BranchOptions::largest_approach)},
      {"end of a sweep",
       [&](double n) {
         FamilyBook book;
         sweep(bar, {{dimension_names(bar).front(), 1, n, 3}}, lanes(), book);
       }},
      {"guess of an own function",
       [](double n) {
         newton(OwnFunction{[](const Eigen::VectorXd& x) -> Eigen::VectorXd { return x; }, {}},
                Eigen::VectorXd::Constant(1, n));
       }},
      {"tolerance for an own function",
       [](double n) {
         newton(OwnFunction{[](const Eigen::VectorXd& x) -> Eigen::VectorXd { return x; }, {}},
                Eigen::VectorXd::Constant(1, 1), {n, 50});
       }},
  });
}

TEST(NumbersTest, OfArmsAndTheirPosesAreFinite) {
  const Robot robot = read_urdf(read_source(MOIVRE_SOURCE_DIR "/problems/robots/puma560.urdf"));
  const Arm arm = make_arm(robot, {});
  const Eigen::VectorXd values = Eigen::VectorXd::Constant(6, 0.3);
  const Eigen::Isometry3d pose = forward_kinematics(arm, values);
  const auto spoiled = [&](double n) {
    Eigen::VectorXd wrong = values;
    wrong[3] = n;
    return wrong;
  };
  const auto displaced = [&](double n) {
    Eigen::Isometry3d wrong = pose;
    wrong.translation().y() = n;
    return wrong;
  };
  const auto with_accuracy = [&](double n) { return TypedPose{pose, n}; };
  const auto ignore = [](ArmResult&&) {};
  expect_only_finite({
      {"value", [&](double n) { forward_kinematics(arm, spoiled(n)); }},
      {"value of frames", [&](double n) { joint_frames(arm, spoiled(n)); }},
      {"value of a posture", [&](double n) { posture_of(arm, spoiled(n)); }},
      {"value within limits",
       [&](double n) {
         Eigen::VectorXd wrong = spoiled(n);
         place_in_limits(arm, wrong);
       }},
      {"value beside a set",
       [&](double n) {
         SelfMotion motion;
         motion.values = values;
         (void)is_on(arm, motion, spoiled(n), 0.1);
       }},
      {"value of a miss", [&](double n) { misfit_of(arm, pose, spoiled(n)); }},
      {"pose of a miss", [&](double n) { misfit_of(arm, displaced(n), values); }},
      {"miss within which a set is met",
       [&](double n) {
         ArmResult result;
         result.pose = pose;
         SelfMotion motion;
         motion.values = values;
         (void)contains(arm, result, motion, values, n);
       }},
      {"value of turns", [&](double n) { all_turns(arm, spoiled(n)); }},
      {"value of nearest turns", [&](double n) { nearest_turns(arm, spoiled(n), values); }},
      {"where an arm stands", [&](double n) { nearest_turns(arm, values, spoiled(n)); }},
      {"value of a distance", [&](double n) { (void)distance_from(arm, spoiled(n), values); }},
      {"standing of a distance", [&](double n) { (void)distance_from(arm, values, spoiled(n)); }},
      {"pose", [&](double n) { find_arm_closures(arm, displaced(n), lanes()); }},
      {"pose of many",
       [&](double n) {
         find_arm_closures(arm, std::vector<Eigen::Isometry3d>{pose, displaced(n)}, lanes());
       }},
      {"pose of each",
       [&](double n) {
         for_each_pose(arm, std::vector<Eigen::Isometry3d>{displaced(n)}, lanes(), ignore);
       }},
      {"pose of a table",
       [&](double n) {
         tabulate_arm_closures(arm, std::vector<Eigen::Isometry3d>{displaced(n)}, lanes());
       }},
      {"accuracy of a pose", [&](double n) { find_arm_closures(arm, with_accuracy(n), lanes()); }},
      {"accuracy of many",
       [&](double n) {
         find_arm_closures(arm, std::vector<TypedPose>{with_accuracy(n)}, lanes());
       }},
      {"accuracy of each",
       [&](double n) {
         for_each_pose(arm, std::vector<TypedPose>{with_accuracy(n)}, lanes(), ignore);
       }},
      {"accuracy at a held joint",
       [&](double n) { find_closures_of_each({arm}, with_accuracy(n), lanes()); }},
      {"flat pose",
       [](double n) {
         std::vector<double> flat{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, n, 0, 0, 0, 1};
         for (const Eigen::Isometry3d& one : poses_of(flat)) (void)workable_pose(one, "it");
       }},
      {"held value",
       [&](double n) {
         make_arm(robot, {{}, {}, {{robot.joints.front().name, n}}});
       }},
      {"end of a held range",
       [&](double n) {
         values_of({"joint", 0, n, 4});
       }},
  });
}

}  // namespace
}  // namespace moivre::test
