// SPDX-License-Identifier: MIT
// Do `closures` and `mechanism` answer for robots, and refuse what they cannot, every fault named?
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "refusing.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

const std::string kRobots = MOIVRE_SOURCE_DIR "/problems/robots/";
const std::string kPuma = kRobots + "puma560.urdf";
const std::string kPose = "0.4 -0.2 0.3 0.5 0.5 0.5 0.5";

class RobotCommands : public RefusingCommands {};

TEST_F(RobotCommands, APoseHasItsClosuresByJointName) {
  const Outcome outcome = scene.run({"closures", kPuma, "--pose", kPose, "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json.at("counts").at("complex"), 8);
  EXPECT_EQ(json.at("closures").size(), 8U);
  const Json& first = json.at("closures").at(0);
  EXPECT_EQ(first.at("id"), "A");
  EXPECT_EQ(first.at("coordinates").size(), 6U);
  EXPECT_TRUE(first.at("coordinates").contains("joint6"));
  for (const Json& closure : json.at("closures")) {
    EXPECT_EQ(closure.at("within_limits").get<bool>(), closure.at("beyond_limits").empty());
    EXPECT_LT(closure.at("residual").get<double>(), 1e-10);
  }
}

TEST_F(RobotCommands, AFileOfPosesHasAnAnswerEach) {
  scene.write("poses.csv", "x,y,z,qw,qx,qy,qz\n0.4,-0.2,0.3,0.5,0.5,0.5,0.5\n9 9 9 1 0 0 0\n");
  const Outcome outcome =
      scene.run({"closures", kPuma, "--poses", "poses.csv", "--json", "-", "--csv", "out.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  ASSERT_EQ(json.at("poses").size(), 2U);
  EXPECT_EQ(json.at("poses").at(1).at("pose"), 1);
  EXPECT_EQ(json.at("poses").at(0).at("closures").size(), 8U);
  EXPECT_TRUE(json.at("poses").at(1).at("closures").empty());
  const std::string table = scene.read("out.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 9);
  EXPECT_TRUE(contains(table, "joint1 [rad]"));
}

TEST_F(RobotCommands, AnArmOfSevenJointsNeedsOneHeld) {
  const std::string panda = kRobots + "panda.urdf";
  expect_refusal({"closures", panda, "--tip", "panda_hand_tcp", "--pose", kPose},
                 {"7 free joints", "--hold", "panda_joint7"});
  const Outcome outcome =
      scene.run({"closures", panda, "--tip", "panda_hand_tcp", "--hold", "panda_joint7=0.8",
                 "--pose", "0.4 0.2 0.3 0 1 0 0", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["counts"]["complex"], 8);
  EXPECT_EQ(report["held"], Json({{"panda_joint7", 0.8}}));
}

TEST_F(RobotCommands, AJointIsHeldAtManyValues) {
  const std::string panda = kRobots + "panda.urdf";
  const std::vector<std::string> asked{"closures",       panda,    "--tip",
                                       "panda_hand_tcp", "--pose", "0.4 0.2 0.3 0 1 0 0"};
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> all = asked;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const Outcome outcome = scene.run(
      with({"--sweep-hold", "panda_joint7=0.7:0.9:3", "--json", "-", "--csv", "out.csv"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  ASSERT_EQ(report["poses"].size(), 3U);
  EXPECT_EQ(report["held"], Json::object());
  EXPECT_EQ(report["poses"][1]["held"], Json({{"panda_joint7", 0.8}}));
  EXPECT_EQ(report["poses"][1]["counts"]["complex"], 8);
  EXPECT_TRUE(contains(scene.read("out.csv"), ",panda_joint7 held\n"));
  const std::string text = scene.run(with({"--sweep-hold", "panda_joint7=0.8:0.8:1"})).out;
  EXPECT_TRUE(contains(text, "\npanda_joint7 = 0.8: 8 complex closures"));
  for (const std::string range : {"panda_joint7", "panda_joint7=1:2", "panda_joint7=1:2:0",
                                  "panda_joint7=1:2:3x", "=1:2:3", "panda_joint7=1:nan:3"}) {
    expect_refusal(with({"--sweep-hold", range}), {"JOINT=FROM:TO:N"});
  }
  expect_refusal(with({"--sweep-hold", "panda_joint7=0:1:3", "--svg", "p.svg"}), {"one pose"});
  expect_refusal(with({"--sweep-hold", "panda_joint7=0:1:3", "--hold", "panda_joint7=1"}),
                 {"at one value and at many"});
}

TEST_F(RobotCommands, JointValuesMayHaveAUnit) {
  const std::string panda = kRobots + "panda.urdf";
  const auto asked = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"closures",       panda,    "--tip",
                                 "panda_hand_tcp", "--pose", "0.4 0.2 0.3 0 1 0 0"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const auto held = [&](const std::string& value) {
    const Outcome outcome =
        scene.run(asked({"--hold", "panda_joint7=" + value, "--json", "-", "--quiet"}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out)["held"]["panda_joint7"].get<double>();
  };
  EXPECT_EQ(held("45deg"), 45 * (std::numbers::pi / 180));
  EXPECT_EQ(held("0.8rad"), 0.8);
  const Outcome swept =
      scene.run(asked({"--sweep-hold", "panda_joint7=45deg:0.9rad:2", "--json", "-", "--quiet"}));
  const Json poses = Json::parse(swept.out)["poses"];
  EXPECT_EQ(poses[0]["held"]["panda_joint7"], 45 * (std::numbers::pi / 180));
  EXPECT_EQ(poses[1]["held"]["panda_joint7"], 0.9);
  const auto nearest = [&](const std::string& values) {
    const Outcome outcome = scene.run(
        asked({"--hold", "panda_joint7=0.8", "--nearest", values, "--json", "-", "--quiet"}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out)["poses"][0]["closures"];
  };
  EXPECT_EQ(nearest("0 0 0 -90deg 0 1"), nearest("0 0 0 -1.5707963267948966 0 1rad"));
  expect_refusal(asked({"--hold", "panda_joint7=30grad"}), {"30grad is not JOINT=VALUE", "30deg"});
  expect_refusal(asked({"--hold", "panda_joint7=30mm"}), {"the joint turns", "rad or deg"});
  expect_refusal(asked({"--sweep-hold", "panda_joint7=1m:2:3"}), {"the joint turns"});
  expect_refusal(asked({"--hold", "panda_joint7=0.8", "--nearest", "0 0 0 0 5mm 0"}),
                 {"panda_joint5, 5mm: the joint turns"});
}

TEST_F(RobotCommands, AJointHeldBeyondItsLimitsIsSaidToBe) {
  const auto told = [&](const std::string& value) {
    return scene
        .run({"closures", kRobots + "panda.urdf", "--hold", "panda_joint7=" + value, "--tip",
              "panda_link8", "--pose", "0.4 0.1 0.5 0 1 0 0"})
        .out;
  };
  EXPECT_NE(told("30").find("panda_joint7 = 30, beyond its limits"), std::string::npos);
  EXPECT_EQ(told("30deg").find("beyond its limits"), std::string::npos);
}

TEST_F(RobotCommands, ASetWithinTheAccuracyOfThePoseIsSaidToMissIt) {
  // The elbow is nearly straight, and the pose has three digits.
  const auto told = [&](const std::string& pose) {
    return scene
        .run({"closures", kRobots + "ur5.urdf", "--base", "base_link", "--tip", "tool0", "--pose",
              pose})
        .out;
  };
  EXPECT_TRUE(contains(told("0.243 0.290 0.828 0.213 -0.038 0.551 0.806"),
                       "within the accuracy of the pose (it misses by "));
  const std::string home = told("0.81725 0.19145 -0.005491 0 0 0.7071067811865 0.7071067811865");
  EXPECT_FALSE(contains(home, "within the accuracy"));
  EXPECT_TRUE(contains(home, "\nthe tip stands while the joints move"));
}

TEST_F(RobotCommands, TheNameOfAJointBeginsNoFormulaInATable) {
  const std::string joint = "\"joint1\"";
  std::string urdf = scene.read(kPuma);
  for (std::size_t at = 0; (at = urdf.find(joint)) != std::string::npos;) {
    urdf.replace(at, joint.size(), "\"=cmd|calc\"");
  }
  scene.write("formula.urdf", urdf);
  const Outcome outcome =
      scene.run({"closures", "formula.urdf", "--pose", kPose, "--quiet", "--csv", "out.csv"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(scene.read("out.csv"), ",'=cmd|calc [rad],")) << scene.read("out.csv");
}

TEST_F(RobotCommands, EveryFaultOfTheQuestionIsNamed) {
  expect_refusal({"closures", kPuma}, {"--pose"});
  expect_refusal({"closures", kPuma, "--pose", "1 2 3", "--tip", "hnd"},
                 {"did you mean 'hand'", "seven numbers"});
  expect_refusal({"closures", kPuma, "--pose", kPose, "--hold", "joint1"}, {"JOINT=VALUE"});
  expect_refusal({"closures", kPuma, "--pose", kPose, "--at", "2", "--fit", "1"},
                 {"--at, --fit are not for robots"});
  expect_refusal({"closures", kPuma, "--pose", kPose, "--poses", kPuma}, {"one of them"});
}

TEST_F(RobotCommands, PosturesAreDrawnSideBySideAndOnAPageThatTurns) {
  const Outcome outcome = scene.run({"closures", kPuma, "--pose", kPose, "--quiet", "--svg",
                                     "postures.svg", "--html", "postures.html"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string svg = scene.read("postures.svg");
  for (const std::string words : {"shoulder left, elbow up, no flip", "shoulder right", ">H<"}) {
    EXPECT_TRUE(contains(svg, words)) << words;
  }
  EXPECT_TRUE(contains(scene.read("postures.html"), "<canvas"));
  scene.write("poses.csv", "0.4 0 0.3 1 0 0 0\n0.3 0 0.3 1 0 0 0\n");
  expect_refusal({"closures", kPuma, "--poses", "poses.csv", "--svg", "p.svg"}, {"one pose"});
}

TEST_F(RobotCommands, AFaultyRobotIsRefusedWithTheLine) {
  scene.write("arm.urdf", "<robot name='r'>\n  <link name='a'/>\n  <link nme='b'/>\n</robot>\n");
  expect_refusal({"closures", "arm.urdf", "--pose", kPose}, {"arm.urdf:3:3: error", "'name'"});
  expect_refusal({"mechanism", "arm.urdf"}, {"arm.urdf:3:3: error"});
}

TEST_F(RobotCommands, OptionsOfRobotsAreRefusedForMechanisms) {
  expect_refusal({"closures", MOIVRE_SOURCE_DIR "/problems/mechanisms/3-rpr.toml", "--pose", kPose},
                 {"are for robots"});
}

TEST_F(RobotCommands, ASideFileClosesTheLoopsOfARobot) {
  const auto counts_of = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all{"closures", "--json", "-"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = scene.run(all);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out);
  };
  const std::string arm = kRobots + "palletizer.urdf";
  const std::string arm_loops = kRobots + "palletizer.loops.toml";
  // Each parallelogram closes as such and crossed.
  EXPECT_EQ(counts_of({arm, "--loops", arm_loops}).at("counts").at("real"), 8);
  const std::string delta = kRobots + "delta.urdf";
  // Three spheres meet in two points.
  EXPECT_EQ(counts_of({delta, "--loops", kRobots + "delta.loops.toml"}).at("counts").at("complex"),
            2);
  std::string rods = scene.read(kRobots + "delta.loops.toml");
  rods.resize(rods.find("[[driver]]"));
  scene.write("rods.toml", rods);
  // Where the platform is given, each arm has two postures, whether its slides are held or its
  // pose.
  const Json held = counts_of(
      {delta, "--loops", "rods.toml", "--hold", "x=0.05", "--hold", "y=0.03", "--hold", "z=-0.45"});
  EXPECT_EQ(held.at("counts").at("real"), 8);
  const Json posed = counts_of(
      {delta, "--loops", "rods.toml", "--tip", "platform", "--pose", "0.05 0.03 -0.45 1 0 0 0"});
  EXPECT_EQ(posed.at("counts").at("real"), 8);
}

TEST_F(RobotCommands, ARobotWithLoopsBecomesAMechanismThatTheOthersTake) {
  const Outcome typed = scene.run({"mechanism", kRobots + "palletizer.urdf", "--loops",
                                   kRobots + "palletizer.loops.toml", "-o", "arm.toml"});
  EXPECT_EQ(typed.exit_code, 0) << typed.err;
  const Outcome motion = scene.run({"motion", "arm.toml", "--to", "1", "--json", "-"});
  EXPECT_EQ(motion.exit_code, 0) << motion.err;
  EXPECT_EQ(Json::parse(motion.out).at("branches").size(), 8U);
}

TEST_F(RobotCommands, EveryFaultOfASideFileIsNamed) {
  const std::string delta = kRobots + "delta.urdf";
  const std::string loops = kRobots + "delta.loops.toml";
  scene.write("side.toml",
              "[[joint]]\ntype = \"rod\"\nlength = 1\nat = [\"arm1.x\", \"arm4.y\"]\n");
  expect_refusal({"closures", delta, "--loops", "side.toml"},
                 {"side.toml:4:7: error", "no point 'x'", "no body 'arm4'"});
  expect_refusal({"mechanism", delta, "--loops", "side.toml"}, {"side.toml:4:7: error"});
  expect_refusal({"closures", delta, "--loops", loops, "--base", "arm1", "--poses", "p.csv",
                  "--tip", "platform"},
                 {"the root, base", "--poses is for arms without loops", "--tip needs --pose"});
  expect_refusal({"closures", delta, "--loops", loops, "--hold", "motr1=1"},
                 {"did you mean 'motor1'"});
  expect_refusal({"mechanism", delta, "--loops", "side.toml", "-o", "side.toml"}, {"overwrite"});
}

TEST_F(RobotCommands, ARobotBecomesAMechanismThatTheOthersTake) {
  for (const std::string name : {"ur5", "panda", "kinova_j2s6s200", "puma560"}) {
    SCOPED_TRACE(name);
    const Outcome typed = scene.run({"mechanism", kRobots + name + ".urdf", "-o", name + ".toml"});
    EXPECT_EQ(typed.exit_code, 0) << typed.err;
    const Outcome newton = scene.run({"newton", name + ".toml"});
    EXPECT_EQ(newton.exit_code, 0) << newton.err;
    const Outcome mobility = scene.run({"mobility", name + ".toml", "--json", "-"});
    EXPECT_EQ(mobility.exit_code, 0) << mobility.err;
    const int freedoms = name == "panda" ? 9 : 6;
    EXPECT_EQ(Json::parse(mobility.out).at("degrees_of_freedom"), freedoms);
  }
}

TEST_F(RobotCommands, WhereTheArmStandsOrdersTheClosuresAndTurnsAreListed) {
  const Outcome outcome = scene.run({"closures", kPuma, "--pose", kPose, "--nearest", "0,0,0,0,0,0",
                                     "--limits", "wrap", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  double before = 0;
  for (const Json& closure : json.at("closures")) {
    EXPECT_GE(closure.at("distance").get<double>(), before);
    before = closure.at("distance").get<double>();
    EXPECT_GE(closure.at("turns").size(), 1U);
  }
  const Outcome table = scene.run({"closures", kPuma, "--pose", kPose, "--nearest",
                                   "0.4 1 2.4 -180deg 1 6", "--limits", "wrap"});
  std::vector<double> distances;
  for (std::size_t at = table.out.find("distance "); at != std::string::npos;
       at = table.out.find("distance ", at + 1)) {
    distances.push_back(std::stod(table.out.substr(at + 9)));
  }
  EXPECT_GT(distances.size(), json.at("closures").size());
  EXPECT_TRUE(std::is_sorted(distances.begin(), distances.end())) << table.out;
  const Outcome few = scene.run({"closures", kPuma, "--pose", kPose, "--nearest", "1 2"});
  EXPECT_EQ(few.exit_code, 1);
  EXPECT_TRUE(contains(few.err, "--nearest has 2 values, the chain has 6 free joints")) << few.err;
}

}  // namespace
}  // namespace moivre::test
