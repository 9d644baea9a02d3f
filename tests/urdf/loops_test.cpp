// SPDX-License-Identifier: MIT
// Does a side file close a robot's loops as it is meant? In the links' frames, with every fault at
// its line.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/read.h"
#include "moivre/urdf/mechanism_text.h"
#include "moivre/urdf/read.h"

namespace moivre {
namespace {

using Eigen::Vector3d;

const std::string kRobots = MOIVRE_SOURCE_DIR "/problems/robots/";

/// Two links that hang turned from the base: the frame of `left` is turned about x, that of `right`
/// about z, by right angles.
const std::string kTurned = R"(<robot name="turned">
  <link name="base"/><link name="left"/><link name="right"/>
  <joint name="l" type="continuous"><parent link="base"/><child link="left"/>
    <origin xyz="1 0 0" rpy="1.57079632679 0 0"/><axis xyz="0 0 1"/></joint>
  <joint name="r" type="continuous"><parent link="base"/><child link="right"/>
    <origin xyz="-1 0 0" rpy="0 0 1.57079632679"/><axis xyz="1 0 0"/></joint>
  <joint name="f" type="continuous"><parent link="right"/><child link="follower"/>
    <origin xyz="0 1 0"/><mimic joint="r" multiplier="2" offset="0.5"/></joint>
  <link name="follower"/>
</robot>)";

Robot turned_robot() { return read_urdf({"turned.urdf", kTurned}); }

Mechanism closed(const Robot& robot, const std::string& side, RobotChanges changes = {}) {
  changes.loops = Source{"side.toml", side};
  return read_mechanism({"closed", mechanism_text(robot, "robot", changes)});
}

Mechanism closed_file(const std::string& name) {
  RobotChanges changes;
  changes.loops = read_source(kRobots + name + ".loops.toml");
  const Robot robot = read_urdf(read_source(kRobots + name + ".urdf"));
  return read_mechanism({name, mechanism_text(robot, name, changes)});
}

std::size_t body_named(const Mechanism& mechanism, const std::string& name) {
  std::size_t body = 0;
  while (mechanism.bodies.at(body).name != name) ++body;
  return body;
}

TEST(LoopsTest, PointsAreInTheFramesOfTheLinks) {
  const Mechanism mechanism = closed(turned_robot(), R"(
[ground.points]
G = [1, 2, 3]
[body.left.points]
A = [1, 2, 3]
[body.right.points]
B = [1, 2, 3]
[[joint]]
type = "rod"
at = ["left.A", "right.B"]
length = 2
)");
  const auto last_of = [&](const char* body) {
    return mechanism.bodies[body_named(mechanism, body)].points.back().at;
  };
  EXPECT_LT((last_of("ground") - Vector3d(1, 2, 3)).norm(), 1e-12);
  EXPECT_LT((last_of("left") - Vector3d(1, -3, 2)).norm(), 1e-12);
  EXPECT_LT((last_of("right") - Vector3d(-2, 1, 3)).norm(), 1e-12);
  EXPECT_EQ(mechanism.joints.back().length, 2);
}

TEST(LoopsTest, AnAxisIsInTheFrameOfItsLinkAndOneAloneInThatOfTheFirst) {
  const std::string at = "at = [\"left.l\", \"right.r\"]\n";
  const auto axes_of = [&](const std::string& axis) {
    return closed(turned_robot(),
                  "[[joint]]\ntype = \"revolute\"\nname = \"loop\"\n" + at + "axis = " + axis)
        .joints.back()
        .axis;
  };
  const auto one = axes_of("[0, 0, 1]");
  EXPECT_LT((one[0] - Vector3d(0, -1, 0)).norm(), 1e-12);
  EXPECT_LT((one[1] - Vector3d(0, -1, 0)).norm(), 1e-12);
  const auto pair = axes_of("[[0, 0, 1], [0, 1, 0]]");
  EXPECT_LT((pair[0] - Vector3d(0, -1, 0)).norm(), 1e-12);
  EXPECT_LT((pair[1] - Vector3d(-1, 0, 0)).norm(), 1e-12);
}

TEST(LoopsTest, AWeldWithoutATurnHoldsLinksAsTheyStandWithAllJointsAtZero) {
  const Mechanism mechanism = closed(turned_robot(), R"(
[ground.points]
T = [1, 0, 0]
[[joint]]
type = "weld"
at = ["ground.T", "left.l"]
)");
  Mechanism at_zero = mechanism;
  at_zero.drivers.clear();
  EXPECT_LT(scaled_residual(Phi(at_zero), initial_guess(at_zero), 0), 1e-12);
}

TEST(LoopsTest, ThePalletizersHandIsLevelWhereItsThreeLoopsAreParallelograms) {
  const Mechanism mechanism = closed_file("palletizer");
  const double shoulder = 0.3, crank = -0.2, waist = 0.5, flange = 0.1;
  // Rods are parallel to the upper arm, the forearm and its rod to the crank; triangle and hand do
  // not tilt.
  const std::map<std::string, double> tilts{{"turntable", 0},   {"upper_arm", shoulder},
                                            {"crank", crank},   {"drive_rod", shoulder},
                                            {"forearm", crank}, {"arm_rod", shoulder},
                                            {"triangle", 0},    {"forearm_rod", crank},
                                            {"hand", 0},        {"flange", 0}};
  Eigen::VectorXd q = initial_guess(mechanism);
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    const std::string& name = mechanism.bodies[body].name;
    const double about_z = waist - (name == "flange" ? flange : 0);
    const Eigen::AngleAxisd turn(Eigen::AngleAxisd(about_z, Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(tilts.at(name), Vector3d::UnitY()));
    q.segment<3>(6 * static_cast<Eigen::Index>(body - 1) + 3) = turn.angle() * turn.axis();
  }
  // Origins follow along the tree; what is left are the loops.
  for (const Joint& joint : mechanism.joints) {
    const auto& [parent, child] = joint.at;
    const Vector3d own = point_position(mechanism, child, q);
    const Vector3d wanted = point_position(mechanism, parent, q);
    if (mechanism.bodies[child.body].points[child.point].at.isZero()) {
      q.segment<3>(6 * static_cast<Eigen::Index>(child.body - 1)) += wanted - own;
    }
  }
  EXPECT_LT(scaled_residual(Phi(mechanism), q, 0), 1e-12);
}

TEST(LoopsTest, TheSideFileDrivesFirstAndWhatIsHeldComesBehind) {
  RobotChanges changes;
  changes.held = {{"r", 0.25}};
  const Mechanism mechanism = closed(turned_robot(), R"toml(
[[driver]]
angle = "l"
value = "0.1*sin(2*t)"
[guess]
left.rz = 0.1
)toml",
                                     changes);
  ASSERT_EQ(mechanism.drivers.size(), 3U);
  EXPECT_EQ(mechanism.drivers[0].name, "l");
  EXPECT_EQ(mechanism.drivers[1].name, "r");
  EXPECT_EQ(driver_state(mechanism.drivers[1].law, 0).value, 0.25);
  EXPECT_EQ(mechanism.drivers[2].name, "f");
  EXPECT_EQ(driver_state(mechanism.drivers[2].law, 0).value, 1.0);
  EXPECT_EQ(mechanism.guess.at("left.rz"), 0.1);
}

TEST(LoopsTest, APoseIsHeldByAWeld) {
  RobotChanges changes;
  changes.tip = "left";
  changes.pose = Eigen::Translation3d(1, 0, 0) * Eigen::AngleAxisd(2.0, Vector3d::UnitX());
  const Robot robot = turned_robot();
  Mechanism mechanism = read_mechanism({"posed", mechanism_text(robot, "robot", changes)});
  mechanism.drivers.clear();
  Eigen::VectorXd q = initial_guess(mechanism);
  q[6 * static_cast<Eigen::Index>(body_named(mechanism, "left") - 1) + 3] =
      2.0 - 1.57079632679489662;
  const Eigen::VectorXd rows = Phi(mechanism).value(q, 0);
  const std::vector<std::string> names = Phi(mechanism).row_names();
  double largest = 0;
  std::size_t of_weld = 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k].find("weld") == std::string::npos) continue;
    ++of_weld;
    largest = std::max(largest, std::abs(rows[static_cast<Eigen::Index>(k)]));
  }
  EXPECT_EQ(of_weld, 6U);
  EXPECT_LT(largest, 1e-11);
  changes.tip = "base";
  EXPECT_THROW(mechanism_text(robot, "robot", changes), std::invalid_argument);
}

struct FaultySide {
  std::string text;
  std::size_t line;
  std::string words;
};

TEST(LoopsTest, EveryFaultOfASideFileIsNamedAtItsLine) {
  const std::string joint = "[[joint]]\ntype = \"spherical\"\n";
  const std::vector<FaultySide> faulty{
      {"[body.lft.points]\nA = [0, 0, 0]\n" + joint + "at = [\"left.l\", \"right.r\"]\n", 1,
       "there is no body 'lft'; did you mean 'left'?"},
      {joint + "at = [\"left.l\", \"right.A\"]\n", 3,
       "body 'right' has no point 'A'; known are 'r', 'f'"},
      {joint + "at = [\"left.l\", \"rigt.r\"]\n", 3,
       "there is no body 'rigt'; did you mean 'right'?"},
      {"[body.left.points]\nl = [0, 0, 0]\n" + joint + "at = [\"left.l\", \"right.r\"]\n", 2,
       "body 'left' has a point 'l' already, as at each of its joints; take another name"},
      {"[[driver]]\nangle = \"ll\"\nstart = 0\n", 2, "there is no joint 'll'; did you mean 'l'?"},
      {"[[driver]]\nangle = \"r\"\nstart = 0\n", 1,
       "joint 'f' mimics this one: drive it too, at 2 times this value plus 0.5"},
      {"[[driver]]\nangle = \"h\"\nstart = 0\n", 1,
       "joint 'h' is held; remove this driver, or do not hold the joint"},
      {"[units]\nangle = \"deg\"\n" + joint + "at = [\"left.l\", \"right.r\"]\n", 1,
       "a side file has the robot's units, metres and radians; remove [units]"},
      {"space = \"planar\"\n" + joint + "at = [\"left.l\", \"right.r\"]\n", 1,
       "the mechanism is spatial; remove 'space'"},
      {"[body.left]\ntolerance = 0.1\n" + joint + "at = [\"left.l\", \"right.r\"]\n", 2,
       "a side file has no tolerances of points; write them into the mechanism file that moivre "
       "mechanism makes"},
      {"title = \"nothing\"\n", 1,
       "the file adds nothing; write one [[joint]] for each loop that it closes"},
      {"fit = 1\n" + joint + "at = [\"left.l\", \"right.r\"]\n", 1,
       "unknown key 'fit' in a side file; known are 'title', 'space', 'units', 'ground', 'body', "
       "'joint', 'driver', 'guess'"},
      {joint + "at = [\"left.l\", \"right.r\"]\n" + joint + "at = [\"right.r\", \"left.l\"]\n", 4,
       "this joint repeats joint 'left.l-right.r'; remove it"},
      {"[[driver]]\nangle = \"l\"\nstart = 0\n[[driver]]\nangle = \"l\"\nstart = 0\n", 4,
       "'l' is driven twice; remove one of the drivers"},
      {"[[joint]\n", 1, "Error while parsing table header: "}};
  std::string text = kTurned;
  text.insert(text.rfind("</robot>"),
              "<link name='held'/><joint name='h' type='continuous'><parent link='base'/>"
              "<child link='held'/></joint>");
  const Robot robot = read_urdf({"turned.urdf", text});
  RobotChanges changes;
  changes.held = {{"h", 0}};
  for (const FaultySide& side : faulty) {
    SCOPED_TRACE(side.text);
    try {
      closed(robot, side.text, changes);
      ADD_FAILURE() << "no fault was found";
    } catch (const ParseError& error) {
      ASSERT_EQ(error.diagnostics().size(), 1U) << error.what();
      EXPECT_EQ(error.diagnostics()[0].at.line, side.line) << error.what();
      const std::string message = error.diagnostics()[0].message;
      EXPECT_TRUE(message.starts_with(side.words)) << message;
      EXPECT_EQ(std::string(error.what()).rfind("side.toml:", 0), 0U) << error.what();
    }
  }
}

}  // namespace
}  // namespace moivre
