// SPDX-License-Identifier: MIT
// Is a mechanism file read as it was typed?
#include "moivre/mechanism/read.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "files.h"

namespace moivre {
namespace {

using test::example;
using test::kDegree;
using test::typed;

TEST(MechanismReader, FourBarIsReadInTheOrderOfTheFile) {
  const Mechanism m = example("four-bar");
  EXPECT_EQ(m.title, "Four-bar, Norton example 4-1");
  EXPECT_EQ(m.units.length, "mm");
  ASSERT_EQ(m.bodies.size(), 4U);
  EXPECT_EQ(m.bodies[0].name, "ground");
  EXPECT_EQ(m.bodies[1].name, "crank");
  EXPECT_EQ(m.bodies[2].name, "coupler");
  EXPECT_EQ(m.bodies[3].name, "rocker");
  ASSERT_EQ(m.bodies[2].points.size(), 3U);
  EXPECT_EQ(m.bodies[2].points[2].at, Eigen::Vector3d(60, 45, 0));
  ASSERT_EQ(m.joints.size(), 4U);
  EXPECT_EQ(m.joints[0].name, "O2");
  EXPECT_EQ(m.joints[1].name, "A");
  const DriverState driver = driver_state(m.drivers.at(0).law, 0);
  EXPECT_NEAR(driver.value, 40 * kDegree, 1e-15);
  EXPECT_NEAR(driver.velocity, 25, 1e-13);
  EXPECT_NEAR(driver.acceleration, 15, 1e-13);
  EXPECT_NEAR(m.guess.at("rocker.phi"), 57 * kDegree, 1e-15);
}

TEST(MechanismReader, UnknownsKeepTheOrderOfTheFile) {
  const Mechanism m = typed(R"toml(
[unknowns]
lengths = ["z", "a"]
angles = ["m"]
[equations]
e = "z + a + m"
)toml");
  ASSERT_EQ(m.unknowns.size(), 3U);
  EXPECT_EQ(m.unknowns[0].name, "z");
  EXPECT_EQ(m.unknowns[1].name, "a");
  EXPECT_EQ(m.unknowns[2].name, "m");
  EXPECT_TRUE(m.unknowns[2].is_angle);
}

TEST(MechanismReader, AnglesAmongConstantsAreInTheFilesUnit) {
  const Mechanism m = typed(R"toml(
[units]
angle = "deg"
[unknowns]
lengths = ["x"]
[constants]
b = 3
[constants.angles]
beta = 180
[equations]
e = "x - b*cos(beta)"
)toml");
  EXPECT_DOUBLE_EQ(m.constants.at("b"), 3);
  EXPECT_DOUBLE_EQ(m.constants.at("beta"), 180 * kDegree);
}

TEST(MechanismReader, TwoEqualsSignsTogetherStandForOne) {
  const std::string head = "[unknowns]\nlengths = [\"x\"]\n[equations]\ne = ";
  const Mechanism m = typed(head + "\"x^2 == 4\"\n");
  const Mechanism once = typed(head + "\"x^2 =  4\"\n");
  const auto length_of_sides = [](const Mechanism& each) {
    return each.equations.at(0).expression.operands.size();
  };
  EXPECT_EQ(length_of_sides(m), 2U);
  EXPECT_EQ(m.equations[0].expression.operands[1].operands[0].at.column,
            once.equations[0].expression.operands[1].operands[0].at.column);
}

TEST(MechanismReader, GuessMayBeDottedOrQuoted) {
  const std::string body =
      "[ground.points]\nO=[0,0]\n[body.a.points]\nO=[0,0]\n[[joint]]\ntype=\"revolute\"\nat=["
      "\"ground.O\",\"a.O\"]\n";
  EXPECT_DOUBLE_EQ(typed(body + "[guess]\na.phi = 0.5\n").guess.at("a.phi"), 0.5);
  EXPECT_DOUBLE_EQ(typed(body + "[guess]\n\"a.phi\" = 0.5\n").guess.at("a.phi"), 0.5);
}

TEST(MechanismReader, EveryFaultIsNamedInOneError) {
  try {
    typed(R"toml(space = "flat"
[ground.points]
O = [0, 0]
[body.crank.points]
O = [0, nan]
A = [1]
[[joint]]
type = "revolut"
at = ["ground.O", "crank.O"]
[[joint]]
type = "revolute"
at = ["ground.X", "crnk.O"]
colour = "red"
[[driver]]
angle = "crank"
)toml");
    FAIL() << "the file has faults";
  } catch (const ParseError& error) {
    const auto& faults = error.diagnostics();
    ASSERT_EQ(faults.size(), 8U) << error.what();
    EXPECT_EQ(faults[0].at.line, 1U);
    EXPECT_EQ(faults[1].at.line, 5U);
    EXPECT_EQ(faults[2].at.line, 6U);
    EXPECT_EQ(faults[3].at.line, 8U);
    EXPECT_EQ(faults[3].message, "unknown joint type 'revolut'; did you mean 'revolute'?");
    EXPECT_EQ(faults[4].at.line, 12U);
    EXPECT_EQ(faults[5].message, "there is no body 'crnk'; did you mean 'crank'?");
    EXPECT_EQ(faults[6].at.line, 13U);
    EXPECT_EQ(faults[7].at.line, 14U);
  }
}

TEST(MechanismReader, CaretStandsBelowTheNameInsideAString) {
  try {
    typed("[unknowns]\nlengths = [\"x\"]\n[equations]\ne = \"x - radius\"\n");
    FAIL() << "radius is unknown";
  } catch (const ParseError& error) {
    EXPECT_EQ(error.diagnostics()[0].at.line, 4U);
    EXPECT_EQ(error.diagnostics()[0].at.column, 10U);
    EXPECT_EQ(std::string(error.what()),
              "typed.toml:4:10: error: 'radius' is neither an unknown nor a constant; known are "
              "'x', 'pi', 't'\n    e = \"x - radius\"\n             ^\n");
  }
}

TEST(MechanismReader, ColumnsCountBytesBehindLettersOfSeveralBytes) {
  try {
    typed("[unknowns]\nlengths = [\"x\"]\n[equations]\n\"h\xC3\xB6he\" = 5\n");
    FAIL() << "an equation must be a string";
  } catch (const ParseError& error) {
    EXPECT_EQ(error.diagnostics()[0].at.line, 4U);
    EXPECT_EQ(error.diagnostics()[0].at.column, 11U);
  }
}

TEST(MechanismReader, RefusesMoreBodiesThanDenseMatricesBear) {
  std::string text = "[ground.points]\nO = [0, 0]\n";
  for (int body = 0; body <= 300; ++body) {
    const std::string name = std::string("b").append(std::to_string(body));
    text +=
        "[body." + name +
        ".points]\nO = [0, 0]\nP = [1, 0]\n[[joint]]\ntype = \"revolute\"\nat = [\"ground.O\", \"" +
        name + ".O\"]\n";
  }
  try {
    typed(text);
    FAIL() << "301 bodies";
  } catch (const ParseError& error) {
    EXPECT_EQ(error.diagnostics()[0].message, "there are 301 bodies, at most 300 are taken");
  }
}

TEST(Drivers, ThatPrescribeNothingToWorkWithAreNamed) {
  const auto driven = [](const std::string& law) {
    return typed(
        "[unknowns]\nangles = [\"a\"]\nlengths = [\"b\"]\n[equations]\ne = \"b - cos(a)\"\n"
        "[[driver]]\nunknown = \"a\"\n" +
        law + "\n");
  };
  const auto refusal = [](const Mechanism& mechanism, double t) -> std::string {
    try {
      require_drivers(mechanism, t);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(driven("velocity = 1"), 1e6), "");
  EXPECT_EQ(refusal(driven("velocity = 1"), 1e7),
            "at t = 1e+07 s driver 'a' prescribes more than a million turns");
  EXPECT_EQ(refusal(driven("value = \"1/t\""), 0),
            "at t = 0 s driver 'a' prescribes no finite value");
  EXPECT_EQ(refusal(driven("velocity = 1"), std::nan("")),
            "the time of the drivers must be finite");
}

}  // namespace
}  // namespace moivre
