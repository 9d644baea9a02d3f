// SPDX-License-Identifier: MIT
// Are mechanisms put together in code refused by name where they cannot be meant, whatever takes
// them?
#include <functional>
#include <limits>

#include "moivre/closures/closures.h"
#include "moivre/formulation/formulation.h"
#include "moivre/kinematics/linear.h"
#include "moivre/kinematics/mobility.h"
#include "moivre/kinematics/newton.h"
#include "moivre/kinematics/sensitivity.h"
#include "moivre/kinematics/state.h"
#include "moivre/mechanism/dimensions.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/read.h"
#include "moivre/mechanism/rules.h"
#include "moivre/motion/circuits.h"
#include "moivre/motion/motion.h"
#include "moivre/sweep/sweep.h"
#include "refused.h"

namespace moivre::test {
namespace {

Mechanism four_bar() {
  return read_mechanism(read_source(MOIVRE_SOURCE_DIR "/problems/mechanisms/four-bar.toml"));
}

/// Every entry refuses the mechanism with this sentence.
void expect_refused_everywhere(const Mechanism& mechanism, const std::string& word) {
  const Eigen::VectorXd q = Eigen::VectorXd::Zero(9);
  expect_refused([&] { return find_closures(mechanism, cvode()); }, word);
  expect_refused([&] { return find_motion(mechanism, cvode()); }, word);
  expect_refused([&] { return follow_guesses(mechanism, {q}); }, word);
  expect_refused([&] { return formulate(mechanism, 0); }, word);
  expect_refused([&] { return Phi(mechanism); }, word);
  expect_refused([&] { return initial_guess(mechanism); }, word);
}

struct Slip {
  std::string refusal;
  std::function<void(Mechanism&)> make;
};

TEST(MisuseTest, EverySlipInAMechanismIsRefusedByName) {
  const std::vector<Slip> slips{
      {"names body 7, counted from 0, of 4", [](Mechanism& m) { m.joints[1].at[0].body = 7; }},
      {"names point 9, counted from 0, of body", [](Mechanism& m) { m.joints[1].at[1].point = 9; }},
      {"ties body 'crank' to itself",
       [](Mechanism& m) {
         m.joints[0].at = {PointOf{1, 0}, PointOf{1, 1}};
       }},
      {"of a planar mechanism must have z = 0",
       [](Mechanism& m) { m.bodies[1].points[0].at.z() = 5; }},
      {"two bodies are called 'crank'", [](Mechanism& m) { m.bodies[2].name = "crank"; }},
      {"is there twice",
       [](Mechanism& m) { m.bodies[1].points[1].name = m.bodies[1].points[0].name; }},
      {"two joints are called", [](Mechanism& m) { m.joints[1].name = m.joints[0].name; }},
      {"has a coordinate that is not finite",
       [](Mechanism& m) { m.bodies[2].points[1].at.x() = kNaN; }},
      {"has a coordinate that is not finite",
       [](Mechanism& m) { m.bodies[2].points[1].at.y() = kInfinity; }},
      {"needs finite numbers of its parabola",
       [](Mechanism& m) {
         m.drivers[0].law = Parabola{kNaN, 0, 0};
       }},
      {"needs a table of two or more finite rows",
       [](Mechanism& m) {
         m.drivers[0].law = Spline{{0, 1}, {1}, {}};
       }},
      {"has a function without its one operand",
       [](Mechanism& m) {
         m.drivers[0].law = TypedLaw{{Formula::Kind::sin, 0, 0, {}}, 1};
       }},
      {"drives body 12, counted from 0, of 4", [](Mechanism& m) { m.drivers[0].bodies[1] = 12; }},
      {"has a number of something that is not there",
       [](Mechanism& m) { m.drivers[0].joint = 1'000'000'000; }},
      {"names carrier 1000000000, counted from 0, of 4 bodies",
       [](Mechanism& m) { m.joints[0].gear.carrier = 1'000'000'000; }},
      {"drives a body against itself",
       [](Mechanism& m) {
         m.drivers[0].bodies = {1, 1};
       }},
      {"drives joint 99, counted from 0, of 4",
       [](Mechanism& m) {
         m.drivers[0].kind = DriverKind::slide;
         m.drivers[0].joint = 99;
       }},
      {"a revolute joint that has none",
       [](Mechanism& m) {
         m.drivers[0].kind = DriverKind::slide;
         m.drivers[0].joint = 0;
       }},
      {"drives an unknown of a mechanism of bodies",
       [](Mechanism& m) { m.drivers[0].kind = DriverKind::unknown; }},
      {"exists in spatial mechanisms only",
       [](Mechanism& m) { m.joints[0].type = JointType::spherical; }},
      {"needs axis[0] of length 1",
       [](Mechanism& m) {
         m.joints[0].type = JointType::prismatic;
         m.joints[0].axis[0] = {2, 0, 0};
       }},
      {"has a number that is not finite, or beyond 1e50",
       [](Mechanism& m) { m.joints[0].length = -kInfinity; }},
      {"has a number that is not finite, or beyond 1e50",
       [](Mechanism& m) { m.joints[1].gear.radii[1] = kNaN; }},
      {"has a number that is not finite, or beyond 1e50",
       [](Mechanism& m) { m.joints[0].axis[1].z() = kNaN; }},
      {"has its lower limit above the upper",
       [](Mechanism& m) {
         m.joints[0].limits = Limits{1, 0};
       }},
      {"needs teeth other than 0",
       [](Mechanism& m) {
         m.joints[0].type = JointType::gear;
         m.joints[0].gear.teeth = {0, 3};
       }},
      {"names carrier 44, counted from 0, of 4 bodies",
       [](Mechanism& m) {
         m.joints[0].type = JointType::gear;
         m.joints[0].gear.carrier = 44;
       }},
      {"needs a profile of four or more angles",
       [](Mechanism& m) { m.joints[0].type = JointType::cam_lever; }},
      {"names a coordinate that is not there, 'crank.psi'",
       [](Mechanism& m) { m.guess["crank.psi"] = 1; }},
      {"the guess of 'crank.phi' must be finite",
       [](Mechanism& m) { m.guess["crank.phi"] = kNaN; }},
      {"fit must be a finite length above 0", [](Mechanism& m) { m.fit = -1; }},
      {"there is no ground", [](Mechanism& m) { m.bodies.clear(); }},
      {"the first body is the ground", [](Mechanism& m) { m.bodies[0].name = "frame"; }},
      {"a held spin names a body",
       [](Mechanism& m) {
         m.held_spins.push_back({9, {}});
       }},
      {"there are bodies and typed unknowns",
       [](Mechanism& m) {
         m.unknowns.push_back({"x", false, {}});
       }},
  };
  EXPECT_TRUE(broken_rules(four_bar()).empty());
  for (const Slip& slip : slips) {
    SCOPED_TRACE(slip.refusal);
    Mechanism mechanism = four_bar();
    slip.make(mechanism);
    expect_refused_everywhere(mechanism, slip.refusal);
  }
}

TEST(MisuseTest, AFormulaNamesUnknownsThatAreThere) {
  Mechanism typed;
  typed.unknowns = {{"x", false, {}}};
  typed.equations = {{"e", {}, {Formula::Kind::unknown, 0, 5, {}}, {}}};
  expect_refused([&] { return Phi(typed); }, "equation 'e' has unknown 5, counted from 0, of 1");
}

TEST(MisuseTest, StructureIsNamedToo) {
  Mechanism loose = four_bar();
  loose.bodies.push_back({"loose", {}, {}});
  EXPECT_TRUE(broken_form(loose).empty());
  ASSERT_EQ(broken_rules(loose).size(), 1U);
  EXPECT_NE(broken_rules(loose)[0].find("'loose' is not connected to the ground"),
            std::string::npos);
}

// A length that a revolute does not read was the mechanism's size: all others vanished beside it.
TEST(MisuseTest, WhatAJointDoesNotReadChangesNothing) {
  Mechanism mechanism = four_bar();
  const ClosureResult as_it_is = find_closures(mechanism, lanes());
  mechanism.joints[1].length = mechanism.joints[2].pitch = -1e45;
  EXPECT_TRUE(broken_rules(mechanism).empty());
  const ClosureResult same = find_closures(mechanism, lanes());
  EXPECT_EQ(Phi(mechanism).length(), Phi(four_bar()).length());
  ASSERT_EQ(same.closures.size(), as_it_is.closures.size());
  for (std::size_t k = 0; k < same.closures.size(); ++k) {
    EXPECT_EQ(same.closures[k].q, as_it_is.closures[k].q);
  }
}

// Beside a length of 1e40 the others are rounding, and terms of the equations with them: a proof
// asked for the value of an unknown that no equation was left of.
TEST(MisuseTest, LengthsThatVanishBesideOthersAreNoCrash) {
  for (const double huge : {1e20, 1e40}) {
    Mechanism mechanism =
        read_mechanism(read_source(MOIVRE_SOURCE_DIR "/problems/mechanisms/slider-crank.toml"));
    mechanism.bodies[0].points.push_back({"far", {huge, 0, 0}, {}});
    EXPECT_FALSE(broken_rules(mechanism).empty());
    ClosureOptions options;
    options.solve.threads = 1;
    for (const Closure& one : find_closures(mechanism, lanes(), options).closures) {
      EXPECT_TRUE(one.q.allFinite());
    }
  }
}

TEST(MisuseTest, APoseHasANumberForEachCoordinate) {
  const Mechanism mechanism = four_bar();
  const Phi phi(mechanism);
  const Eigen::VectorXd three = Eigen::VectorXd::Zero(3);
  const Eigen::VectorXd nine = Eigen::VectorXd::Zero(9);
  const std::string word = "q has 9 numbers, one for each coordinate, not 3";
  expect_refused([&] { return phi.value(three, 0); }, word);
  expect_refused([&] { return phi.jacobian(three, 0); }, word);
  expect_refused([&] { return phi.quadratic(nine, three, 0); }, word);
  expect_refused([&] { return phi.canonical(three); }, word);
  expect_refused([&] { return mobility(phi, three); }, "9");
  expect_refused([&] { return newton(phi, three); }, "9");
  expect_refused([&] { return newton(phi, Eigen::VectorXd::Constant(9, kNaN)); }, "finite");
  expect_refused([&] { return point_position(mechanism, {1, 0}, three); }, word);
  expect_refused([&] { return point_position(mechanism, {1, 9}, nine); }, "there is no point 9");
  expect_refused([&] { return orientation(mechanism, 7, nine); }, "there is no body 7");
  expect_refused([&] { return joint_coordinate(mechanism, mechanism.joints[0], three); }, word);
  expect_refused([&] { return require_pose(mechanism, three); }, "9 numbers");
}

TEST(MisuseTest, WhatIsNotThereHasNoNumber) {
  const Mechanism mechanism = four_bar();
  const Eigen::VectorXd nine = Eigen::VectorXd::Zero(9);
  Joint lost = mechanism.joints[1];
  lost.at[0].body = 7;
  expect_refused([&] { return joint_coordinate(mechanism, lost, nine); }, "an end that is not");
  expect_refused([&] { return turn_state(mechanism, lost, nine, nine, nine); }, "an end that is");
  for (const DimensionKind kind :
       {DimensionKind::point, DimensionKind::length, DimensionKind::turn, DimensionKind::driver}) {
    const Dimension nowhere{"it", kind, {9, 9}, 0, 9, 9, false};
    Mechanism changed = mechanism;
    expect_refused([&] { return dimension_value(mechanism, nowhere); }, "is not there");
    expect_refused([&] { return set_dimension(changed, nowhere, 1); }, "is not there");
  }
  Mechanism driven = mechanism;
  driven.drivers[0].law = Spline{{0, 1}, {}, {}};
  expect_refused([&] { return driver_values(driven, 0); }, "two or more rows");
  expect_refused([&] { return dimension_value(driven, dimensions(mechanism).back()); }, "rows");
  expect_refused([&] { return natural_duration(driven); }, "finite rows");
  driven.drivers[0].law = TypedLaw{{Formula::Kind::sin, 0, 0, {}}, 1};
  expect_refused([&] { return driver_values(driven, 0); }, "without its one operand");
  expect_refused([&] { return passages_from(Circuits{}, 3); }, "there is no branch 3");
}

TEST(MisuseTest, KinematicsTakesWhatFitsTheMechanism) {
  const Phi phi(four_bar());
  const Phi joints = phi.without_drivers();
  const Eigen::VectorXd q = Eigen::VectorXd::Zero(phi.dimension());
  Partition partition = choose_partition(joints, q);
  const auto independent = std::ssize(partition.independent);
  const Eigen::VectorXd rates = Eigen::VectorXd::Ones(independent);
  const Eigen::VectorXd one_more = Eigen::VectorXd::Ones(independent + 1);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  const auto state = [&](const Eigen::VectorXd& velocity, const Eigen::VectorXd& acceleration) {
    return partitioned_state(joints, partition, q, velocity, acceleration);
  };
  expect_refused([&] { return state(one_more, rates); }, "independent velocity is");
  expect_refused([&] { return state(rates, one_more); }, "independent acceleration is");
  partition.independent[0] = phi.dimension();
  expect_refused([&] { return state(rates, rates); }, "coordinates once");
  expect_refused([&] { return pose_sensitivity(phi, q, 0, one); }, "constraints");
  expect_refused([&] { return pose_sensitivity(phi, one, 0, one); }, "one for each coordinate");
  const Eigen::Matrix2d A = Eigen::Matrix2d::Identity();
  LinearOptions options;
  options.row_units = one;
  expect_refused([&] { return Factorization(A, options); }, "row units must be 2 positive numbers");
  options.row_units = Eigen::Vector2d(1, -1);
  expect_refused([&] { return Factorization(A, options); }, "row units must be 2 positive numbers");
  expect_refused([&] { return Factorization(A).solve(one); }, "A has 2 rows");
}

TEST(MisuseTest, TimesAreFinite) {
  const Mechanism mechanism = four_bar();
  ClosureOptions closures;
  closures.time = kNaN;
  expect_refused([&] { return find_closures(mechanism, cvode(), closures); }, "finite");
  MotionOptions motion;
  motion.to = kInfinity;
  expect_refused([&] { return find_motion(mechanism, cvode(), motion); }, "to");
}

}  // namespace
}  // namespace moivre::test
