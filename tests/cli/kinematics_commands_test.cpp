// SPDX-License-Identifier: MIT
// Do `newton`, `mobility`, `guesses` and `closures` take every kind of file, and refuse with
// reasons what they cannot?
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../mechanism/files.h"
#include "refusing.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

const std::string kTriangle = R"toml([units]
angle = "deg"
[ground.points]
O = [0, 0]
P = [4, 0]
[body.left.points]
O = [0, 0]
A = [3, 0]
[body.right.points]
P = [0, 0]
A = [2, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "left.O"]
[[joint]]
type = "revolute"
at = ["ground.P", "right.P"]
[[joint]]
type = "revolute"
at = ["left.A", "right.A"]
name = "tip"
[guess]
"left.phi" = 30
"right.phi" = 130
)toml";

const std::string kCircleAndLine =
    "[unknowns]\nangles = [\"phi\"]\nlengths = [\"d\"]\n[equations]\n"
    "across = \"2*cos(phi) - d\"\nup = \"2*sin(phi) - 1\"\n[guess]\nphi = 0.4\nd = 2\n";

const std::string kPolynomials = "2\nx^2 + y^2 - 5;\nx*y - 2;\n";

/// A folder with a mechanism, typed equations and polynomials.
class KinematicsCommands : public RefusingCommands {
 protected:
  KinematicsCommands() {
    scene.write("bodies.toml", kTriangle);
    scene.write("typed.toml", kCircleAndLine);
    scene.write("f.phc", kPolynomials);
  }
};

TEST_F(KinematicsCommands, NewtonTakesAllThreeKindsOfFiles) {
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"newton", "bodies.toml"},
        {"newton", "typed.toml"},
        {"newton", "f.phc", "--guess", "x=3", "--guess", "y=1"}}) {
    std::vector<std::string> words = command;
    words.insert(words.end(), {"--json", "run.json"});
    const Outcome outcome = scene.run(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "\n  k  residual  step      rank  method  ")) << outcome.out;
    const Json run = Json::parse(scene.read("run.json"));
    EXPECT_EQ(run["status"], "converged");
    EXPECT_EQ(run["iterations"].size(), run["steps"].get<std::size_t>() + 1);
  }
}

TEST_F(KinematicsCommands, NewtonsTableShowsTheIteratesOfFewCoordinates) {
  const Outcome few = scene.run({"newton", "f.phc", "--guess", "x=3", "--guess", "y=1"});
  EXPECT_TRUE(has_line(few.out, "  k  residual  step      rank  method        x               y"))
      << few.out;
  EXPECT_TRUE(has_line(few.out, "  0  5         0.81         2  LU            3               1"))
      << few.out;
  const Outcome csv = scene.run({"newton", "bodies.toml", "--csv", "-"});
  EXPECT_EQ(csv.out.substr(0, csv.out.find('\n')),
            "iteration,residual,scaled_residual,step,rank,method,left.x,left.y,left.phi "
            "[rad],right.x,right.y,right.phi [rad]");
}

TEST_F(KinematicsCommands, GuessesTakesAllThreeKindsOfFiles) {
  for (const auto& [file, count] :
       {std::pair<const char*, std::size_t>{"bodies.toml", 2}, {"typed.toml", 2}, {"f.phc", 4}}) {
    const Outcome outcome = scene.run({"guesses", file, "--json", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["guesses"].size(), count) << file;
  }
}

TEST_F(KinematicsCommands, AGuessThatGuessesWroteConvergesAtOnce) {
  const Json found = Json::parse(scene.run({"guesses", "bodies.toml", "--json", "-"}).out);
  for (const Json& guess : found["guesses"]) {
    std::vector<std::string> command{"newton", "bodies.toml", "--json", "-"};
    for (std::size_t k = 0; k < guess["q"].size(); ++k) {
      const std::string name = found["names"][k];
      const bool is_angle = name.ends_with("phi");
      const double value = guess["q"][k].get<double>() * (is_angle ? 180 / 3.14159265358979 : 1);
      command.insert(command.end(), {"--guess", name + "=" + Json(value).dump()});
    }
    const Json run = Json::parse(scene.run(command).out);
    EXPECT_EQ(run["status"], "converged");
    EXPECT_LE(run["steps"].get<int>(), 1);
  }
}

TEST_F(KinematicsCommands, AnUnknownCoordinateNamesTheNearestOne) {
  for (const std::string option : {"--guess", "--weight"}) {
    expect_refusal({"newton", "bodies.toml", option, "left.ph=3"},
                   {"there is no coordinate left.ph", "did you mean left.phi?"});
    expect_refusal({"newton", "typed.toml", option, "phj=3"}, {"did you mean phi?"});
    expect_refusal({"newton", "f.phc", option, "z=3"}, {"there is no coordinate z"});
  }
  expect_refusal({"mobility", "bodies.toml", "--guess", "lefd.x=3"}, {"did you mean left.x?"});
}

TEST_F(KinematicsCommands, AValueHasToBeOneFiniteNumber) {
  for (const std::string option : {"--guess", "--weight"}) {
    for (const std::string value : {"nan", "inf", "", "1e999", "1,5", "0x10", "3 4", "ten"}) {
      expect_refusal({"newton", "f.phc", option, "x=" + value},
                     {"is not NAME=VALUE with a finite number"});
    }
    expect_refusal({"newton", "f.phc", option, "x"}, {"is not NAME=VALUE"});
    expect_refusal({"newton", "f.phc", option, "3"}, {"there is no coordinate 3"});
    expect_refusal({"newton", "f.phc", option, "=3"}, {"NAME=VALUE"});
  }
}

TEST_F(KinematicsCommands, TimesThreadsAndGuessesBeyondReasonAreRefused) {
  for (const std::string command : {"closures", "newton", "mobility", "guesses"}) {
    expect_refusal({command, "bodies.toml", "--at", "nan"},
                   {"the time of the drivers must be finite"});
  }
  expect_refusal({"closures", "bodies.toml", "--threads", "-3"}, {"threads must lie between"});
  for (const std::string command : {"newton", "mobility"}) {
    expect_refusal({command, "bodies.toml", "--guess", "left.phi=1e300"},
                   {"more than a million turns"});
    expect_refusal({command, "bodies.toml", "--guess", "left.x=1e300"},
                   {"left.x=1e300 is beyond 1e50"});
  }
}

TEST_F(KinematicsCommands, EveryFaultyValueIsNamedAtOnce) {
  expect_refusal({"newton", "f.phc", "--guess", "x=nan", "--guess", "z=1"},
                 {"x=nan is not NAME=VALUE", "there is no coordinate z"});
}

TEST_F(KinematicsCommands, ACoordinateIsGuessedOnce) {
  expect_refusal({"newton", "f.phc", "--guess", "x=1", "--guess", "x=2"}, {"x is given twice"});
}

TEST_F(KinematicsCommands, WeightsArePositive) {
  for (const std::string weight : {"0", "-1"}) {
    expect_refusal({"newton", "f.phc", "--weight", "x=" + weight}, {"positive"});
  }
}

TEST_F(KinematicsCommands, NewtonRefusesOptionsOutOfRange) {
  expect_refusal({"newton", "f.phc", "--tolerance", "0"}, {"tolerance"});
  expect_refusal({"newton", "f.phc", "--max-iterations", "-1"}, {"iterations"});
}

TEST_F(KinematicsCommands, ComplexCoefficientsAreRefusedWithTheReason) {
  scene.write("complex.phc", "1\nx^2 - i;\n");
  expect_refusal({"newton", "complex.phc", "--guess", "x=1"}, {"coefficients that are not real"});
}

const std::string kNoPolynomial =
    "[unknowns]\nangles = [\"phi\"]\nlengths = [\"s\"]\n[equations]\n"
    "unrolls = \"s - 2*phi\"\nup = \"s*sin(phi) - 1\"\n[guess]\nphi = 0.6\ns = 1.3\n";

TEST_F(KinematicsCommands, WhatIsNoPolynomialIsRefusedByClosuresAndSolvedByNewton) {
  scene.write("belt.toml", kNoPolynomial);
  for (const std::string command : {"closures", "guesses"}) {
    expect_refusal({command, "belt.toml"},
                   {"equation unrolls is no polynomial", "the angle phi stands outside cos and sin",
                    "newton, mobility and motion take it"});
  }
  EXPECT_EQ(scene.run({"newton", "belt.toml"}).exit_code, 0);
  EXPECT_EQ(scene.run({"mobility", "belt.toml"}).exit_code, 0);
}

TEST_F(KinematicsCommands, SpatialMechanismsAreSolvedByClosuresAndNewton) {
  scene.write("space.toml", R"toml(space = "spatial"
[ground.points]
O = [0, 0, 0]
[body.arm.points]
O = [0, 0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "arm.O"]
axis = [0, 0, 1]
name = "hinge"
[[driver]]
angle = "hinge"
start = 0.3
)toml");
  EXPECT_EQ(scene.run({"closures", "space.toml"}).exit_code, 0)
      << scene.run({"closures", "space.toml"}).err;
  EXPECT_EQ(scene.run({"newton", "space.toml"}).exit_code, 0)
      << scene.run({"newton", "space.toml"}).err;
  EXPECT_EQ(scene.run({"mobility", "space.toml"}).exit_code, 0);
}

std::string with_joint_type(const std::string& type) {
  std::string text = kTriangle;
  return text.replace(text.find("revolute"), 8, type);
}

TEST_F(KinematicsCommands, VelocityConstraintsAreRefusedWithTheReason) {
  scene.write("skate.toml", with_joint_type("rolling"));
  expect_refusal({"closures", "skate.toml"}, {"skate.toml:13", "non-holonomic", "gear"});
}

TEST_F(KinematicsCommands, OneSidedConstraintsAreRefusedWithTheReason) {
  scene.write("stop.toml", with_joint_type("contact"));
  expect_refusal({"closures", "stop.toml"}, {"stop.toml:13", "one-sided", "limits"});
  scene.write("less.toml", "[unknowns]\nlengths = [\"x\"]\n[equations]\ne = \"x^2 >= 2\"\n");
  expect_refusal({"newton", "less.toml"}, {"less.toml:4"});
}

TEST_F(KinematicsCommands, JointLimitsFilterClosuresAndAreReported) {
  std::string text = kTriangle;
  text.insert(text.find("name = \"tip\""), "limits = [0, 180]\n");
  scene.write("limited.toml", text);
  const Outcome outcome = scene.run({"closures", "limited.toml", "--json", "report.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(has_line(outcome.out, "2 complex closures, 2 real, 1 outside a joint's limits"))
      << outcome.out;
  const Json report = Json::parse(scene.read("report.json"));
  EXPECT_EQ(report["counts"]["complex"], 2);
  EXPECT_EQ(report["counts"]["real"], 2);
  EXPECT_EQ(report["counts"]["filtered"], 1);
  const Json left_out{{"what", "1 closure"}, {"why", "outside the limits of revolute tip"}};
  EXPECT_EQ(std::count(report["left_out"].begin(), report["left_out"].end(), left_out), 1);
  EXPECT_EQ(report["closures"].size(), 1U);
}

TEST_F(KinematicsCommands, ClosuresGiveTheSameBytesForEveryNumberOfThreads) {
  const std::string file =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/assur-7-serial.toml";
  std::string first;
  for (const char* threads : {"1", "3", "16"}) {
    const Outcome outcome = scene.run({"closures", file, "--threads", threads, "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string bytes = outcome.out.substr(0, outcome.out.find("\"time_s\""));
    if (first.empty()) first = bytes;
    EXPECT_EQ(bytes, first) << threads << " threads";
  }
}

TEST_F(KinematicsCommands, ClosuresTellThatAMechanismMovesAndFromWhichPose) {
  scene.write("loose.toml",
              "[ground.points]\nO = [0, 0]\n[body.bar.points]\nO = [0, 0]\n[[joint]]\n"
              "type = \"revolute\"\nat = [\"ground.O\", \"bar.O\"]\n");
  const Outcome outcome = scene.run({"closures", "loose.toml", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["moves"]["dimension"], 1);
  EXPECT_EQ(report["moves"]["pose"].size(), 3U);
}

TEST_F(KinematicsCommands, ClosuresOfWhatMovesSayAlongWhichCoordinates) {
  scene.write("free.toml", R"([ground.points]
O = [0, 0]
[body.crank.points]
O = [0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
)");
  const Outcome outcome = scene.run({"closures", "free.toml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(has_line(outcome.out, "  along: crank.phi 1")) << outcome.out;
}

// The drawn pose is where the rank is lower than next to it: to first order the body could turn.
TEST_F(KinematicsCommands, ClosuresTellNoDirectionInWhichNothingMoves) {
  scene.write("rods.toml", collinear_rods_text("[0, 0] [2, 0] [5, 0]", 2));
  const Outcome outcome = scene.run({"closures", "rods.toml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(has_line(outcome.out, "  along: p.y 5")) << outcome.out;
}

TEST_F(KinematicsCommands, ClosuresWhereMotionsCrossTellEachDirection) {
  std::string text =
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/parallelogram.toml").text;
  text.replace(text.find("[[driver]]"), text.find("[guess]") - text.find("[[driver]]"), "");
  scene.write("loose.toml", text);
  const Outcome outcome = scene.run({"closures", "loose.toml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto parallel = "along: crank.phi 0.666667, coupler.y 1.333333, rocker.phi 0.666667\n";
  EXPECT_NE(outcome.out.find(parallel), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("  or along: "), std::string::npos) << outcome.out;
}

TEST_F(KinematicsCommands, MobilityOfASetOfClosuresIsThatOfMostOfThem) {
  scene.write("rods.toml", collinear_rods_text("[0, 0] [2, 0] [5, 0]", 2));
  const Outcome outcome = scene.run({"mobility", "rods.toml", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["degrees_of_freedom"], 1);
  EXPECT_EQ(report["generic_degrees_of_freedom"], 1);
  EXPECT_FALSE(report["singular"]);
  ASSERT_EQ(report["idle"].size(), 1U);
  EXPECT_NEAR(report["idle"][0]["direction"][2].get<double>(), 0, 1e-9);
}

TEST_F(KinematicsCommands, MobilityCallsNoSingularPoseGeneric) {
  scene.write("rods.toml", collinear_rods_text("[0, 0] [2, 0] [5, 0]", 2));
  const std::string all = scene.run({"mobility", "rods.toml"}).out;
  const std::string of_set = " with the drivers held: a pose of the set of closures";
  EXPECT_TRUE(has_line(all, "generic: 1 degree of freedom, 1" + of_set)) << all;
  EXPECT_TRUE(has_line(all, "singular: 2 degrees of freedom, 2" + of_set)) << all;
  const std::string there =
      scene.run({"mobility", "rods.toml", "--guess", "p.x=2", "--guess", "p.y=0"}).out;
  EXPECT_TRUE(has_line(there, "idle: p, along p.y 1")) << there;
  EXPECT_EQ(there.find("\nmoves along: "), std::string::npos) << there;
}

}  // namespace
}  // namespace moivre::test
