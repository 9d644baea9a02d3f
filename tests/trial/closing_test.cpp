// SPDX-License-Identifier: MIT
// Which poses count as assembled? Those at the origin, those of rounded lengths with leave, and no
// pose that misses by nine digits.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "files.h"

namespace moivre::test {
namespace {

TEST(PoseAtTheOrigin, ConvergesThoughAllItsCoordinatesAreNoise) {
  for (const std::string name : {"hooke", "spherical4r"}) {
    const Answer answer = answered("newton", name);
    EXPECT_EQ(answer.exit_code, 0) << name;
    EXPECT_EQ(answer.json.at("status"), "converged") << name;
    EXPECT_EQ(answered("motion", name, {"--from-guess", "--steps", "8"}).exit_code, 0) << name;
  }
}

TEST(PoseAtTheOrigin, IsAssembledWhereAMobilityIsAskedFor) {
  const Answer answer = answered("mobility", "wedge");
  EXPECT_EQ(answer.exit_code, 0);
  for (const std::string warning : answer.json.at("warnings")) {
    EXPECT_FALSE(contains(warning, "not assembled")) << warning;
  }
}

TEST(RoundedLengths, AreSaidWithTheMisfitAndWhatWouldTakeThem) {
  for (const auto& [name, misfit] :
       {std::pair{"par-3", 6.6e-5 * 3}, std::pair{"par-6", 6.6e-8 * 10}}) {
    const Answer answer = answered("closures", name);
    EXPECT_EQ(answer.exit_code, 0) << name;
    EXPECT_EQ(answer.json.at("counts").at("complex"), 0) << name;
    EXPECT_GT(answer.json.at("least_misfit"), 0) << name;
    EXPECT_LT(answer.json.at("least_misfit"), misfit) << name;
    EXPECT_TRUE(contains(answer.json.at("message"), "--fit")) << answer.json.at("message");
  }
}

TEST(RoundedLengths, AreFittedWithinWhatIsGivenAndNotCountedAmongTheExactClosures) {
  const Answer answer = answered("closures", "par-3", {"--fit", "0.01"});
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_EQ(answer.json.at("counts").at("complex"), 0);
  EXPECT_EQ(answer.json.at("counts").at("fitted"), 1);
  EXPECT_EQ(answer.json.at("fit"), 0.01);
  ASSERT_EQ(answer.json.at("closures").size(), 1U);
  const auto& closure = answer.json.at("closures").at(0);
  EXPECT_TRUE(closure.at("fitted").get<bool>());
  EXPECT_LT(closure.at("misfit"), 0.01);
  EXPECT_NEAR(closure.at("coordinates").at("c3.phi"), 50 * std::acos(-1.0) / 180, 1e-4);
}

TEST(RoundedLengths, HaveTheMobilityOfTheExactOnesWithinFit) {
  EXPECT_EQ(answered("mobility", "par-3").exit_code, 2);
  // The misfit is 6.6e-5: a fit that hardly takes the pose counts as one that takes it easily.
  for (const std::string fit : {"7e-5", "0.01"}) {
    const Answer answer = answered("mobility", "par-3", {"--fit", fit});
    EXPECT_EQ(answer.exit_code, 0) << fit;
    EXPECT_TRUE(answer.json.at("assembled").get<bool>()) << fit;
    EXPECT_EQ(answer.json.at("rank"), 11) << fit;
    EXPECT_EQ(answer.json.at("rank_by_svd"), 11) << fit;
    EXPECT_EQ(answer.json.at("degrees_of_freedom"), 1) << fit;
    EXPECT_EQ(answer.json.at("driven_freedoms"), 0) << fit;
    EXPECT_EQ(answer.json.at("redundant").size(), 1U) << fit;
    EXPECT_EQ(answer.json.at("independent").size(), 1U) << fit;
    EXPECT_NEAR(answer.json.at("misfit"), 6.6e-5, 1e-6);
  }
  const Answer closures = answered("closures", "par-3", {"--fit", "0.01"});
  EXPECT_EQ(closures.json.at("mobility").at("degrees_of_freedom"), 1);
}

TEST(RoundedLengths, MoveInAgreementWithTheirClosures) {
  for (const std::string name : {"par-3", "par-6"}) {
    const Answer answer = answered("motion", name, {"--fit", "0.01", "--steps", "24"});
    EXPECT_EQ(answer.exit_code, 0) << name << answer.json.at("failures");
    ASSERT_GE(answer.json.at("branches").size(), 1U) << name;
    for (const auto& checkpoint : answer.json.at("checkpoints")) {
      EXPECT_TRUE(checkpoint.at("agrees").get<bool>()) << name << checkpoint.at("message");
    }
  }
}

TEST(RoundedLengths, OfTwelveDigitsLeaveNoResidualWorthTheName) {
  for (const std::string name : {"par-9", "par-12"}) {
    const Answer answer = answered("closures", name);
    ASSERT_EQ(answer.json.at("closures").size(), 1U) << name;
    EXPECT_LT(answer.json.at("closures").at(0).at("residual"), 1e-11) << name;
    EXPECT_EQ(answer.json.at("counts").at("complex"), 1) << name;
  }
}

TEST(CognatesBesideTheirSpecialPose, HaveTheTwoClosuresThatClose) {
  for (const std::string time : {"4.5000001", "4.50000001", "4.499999"}) {
    const Answer answer = answered("closures", "cognates", {"--at", time});
    EXPECT_EQ(answer.exit_code, 0) << time;
    EXPECT_EQ(answer.json.at("counts").at("complex"), 2) << time;
    EXPECT_EQ(answer.json.at("counts").at("real"), 2) << time;
  }
}

TEST(CognatesAtTheirSpecialPose, HaveThreeMoreForAnInstantInOneLine) {
  EXPECT_EQ(answered("closures", "cognates", {"--at", "4.5"}).json.at("counts").at("real"), 5);
  const Answer answer = answered(
      "motion", "cognates", {"--from", "4", "--to", "5", "--steps", "10", "--checkpoints", "2"});
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_EQ(answer.json.at("failures").size(), 0U) << answer.json.at("failures");
  EXPECT_EQ(answer.json.at("branches").size(), 2U);
  int lines = 0;
  for (const auto& line : answer.json.at("left_out")) {
    lines += contains(line.at("why"), "for an instant") ? 1 : 0;
  }
  EXPECT_EQ(lines, 1);
}

TEST(IdleWheel, IsNamedAndHeldAndHidesNoClosure) {
  const Answer answer = answered("closures", "roller");
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_EQ(answer.json.at("counts").at("real"), 2);
  EXPECT_TRUE(answer.json.at("moves").is_null());
  ASSERT_EQ(answer.json.at("idle").size(), 1U);
  EXPECT_EQ(answer.json.at("idle").at(0).at("body"), "roller");
  EXPECT_EQ(answer.json.at("idle").at(0).at("joint"), "roller pin");
  EXPECT_EQ(answer.json.at("mobility").at("degrees_of_freedom"), 2);
  const Answer motion = answered("motion", "roller", {"--steps", "12"});
  EXPECT_EQ(motion.exit_code, 0);
  EXPECT_EQ(motion.json.at("branches").size(), 2U);
}

TEST(Gears, MeshAsTheyWereDrawnUnlessAllMeshingsAreAskedFor) {
  const Answer drawn = answered("closures", "geared-37-53");
  EXPECT_EQ(drawn.json.at("counts").at("complex"), 2);
  EXPECT_EQ(drawn.json.at("left_out").at(0).at("what"),
            "other meshings than the drawn one of gear mesh");
  // a2 = phase - 37/53 a1, as numbers.
  for (const auto& closure : drawn.json.at("closures")) {
    const double g2 = closure.at("coordinates").at("g2.phi");
    EXPECT_NEAR(g2 * 180 / std::acos(-1.0), 15 - 37.0 / 53 * 30, 1e-9);
  }
  EXPECT_EQ(answered("closures", "geared-37-53", {"--meshings"}).json.at("counts").at("complex"),
            106);
  EXPECT_EQ(answered("closures", "planetary").json.at("counts").at("complex"), 1);
  EXPECT_EQ(answered("closures", "diff").json.at("counts").at("complex"), 1);
  const Answer motion = answered("motion", "geared-37-53", {"--steps", "12"});
  EXPECT_EQ(motion.exit_code, 0) << motion.json.at("failures");
  EXPECT_LE(motion.json.at("branches").size(), 4U);
}

TEST(MotionFromADeadPoint, HasTheBranchesThatLeaveItOnOneCircuit) {
  const Answer motion = answered("motion", "top-dead-centre", {"--to", "2"});
  EXPECT_EQ(motion.exit_code, 0);
  ASSERT_EQ(motion.json.at("branches").size(), 2U);
  ASSERT_EQ(motion.json.at("events").size(), 1U);
  EXPECT_EQ(motion.json.at("events").at(0).at("beginning"), nlohmann::json({"A", "B"}));
  ASSERT_EQ(motion.json.at("circuits").size(), 1U);
  const Answer chosen = answered("motion", "top-dead-centre", {"--to", "2", "--closure", "A"});
  EXPECT_EQ(chosen.json.at("branches").size(), 2U);
}

TEST(RangeOfADriver, HasItsTurningPointsBetweenSamples) {
  const Answer motion = answered("motion", "piston-back", {"--to", "2"});
  for (const auto& circuit : motion.json.at("circuits")) {
    EXPECT_NEAR(circuit.at("drivers").at(0).at("lower"), 80, 1e-9);
    EXPECT_NEAR(circuit.at("drivers").at(0).at("upper"), 120, 1e-9);
  }
}

TEST(IdleWheelsThatMesh, AreHeldByOneOfThem) {
  const std::string wheels = R"([body.w1.points]
P = [0, 0]
[body.w2.points]
B = [0, 0]
[[joint]]
type = "revolute"
at = ["coupler.P", "w1.P"]
name = "p1"
[[joint]]
type = "revolute"
at = ["coupler.B", "w2.B"]
name = "p2"
[[joint]]
type = "gear"
bodies = ["w1", "w2"]
ratio = [-20, 30]
carrier = "coupler"
)";
  std::ifstream file(trial("roller"));
  std::ostringstream text;
  text << file.rdbuf();
  const std::string four_bar = text.str().substr(0, text.str().find("[body.roller.points]"));
  const Scene scene;
  scene.write("wheels.toml", four_bar + wheels);
  const auto json =
      nlohmann::json::parse(scene.run({"closures", "wheels.toml", "--quiet", "--json", "-"}).out);
  EXPECT_EQ(json.at("counts").at("complex"), 2);
  ASSERT_EQ(json.at("idle").size(), 1U);
  EXPECT_EQ(json.at("idle").at(0).at("body"), "w1");
}

// From another frame the same platform has 288 or 304 complex closures: which of its poses are none
// hangs on rounding.
TEST(PosesFarAway, AreNotProvedToBeNone) {
  const Answer answer = answered("closures", "nearly-similar-platform");
  EXPECT_EQ(answer.json.at("counts").at("real"), 16);
  EXPECT_NE(answer.json.at("completeness"), "proved");
}

}  // namespace
}  // namespace moivre::test
