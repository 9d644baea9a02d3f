// SPDX-License-Identifier: MIT
// Does `moivre track` follow the path that solve follows, or one from a start system of the user's
// own?
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "problems.h"
#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

double distance(const Json& a, const Json& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      largest = std::max(largest, std::abs(a[i][k].get<double>() - b[i][k].get<double>()));
    }
  }
  return largest;
}

TEST(TrackCommand, EndsWhereSolveSaysThatThePathEnds) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Json solved = Json::parse(scene.run({"solve", "f.phc", "--json", "-"}).out);
  for (const Json& root : solved["solutions"]) {
    const std::string path = std::to_string(root["path"].get<int>());
    const Outcome outcome = scene.run({"track", "f.phc", "--path", path, "--json", "-"});
    EXPECT_EQ(outcome.exit_code, 0);
    const Json track = Json::parse(outcome.out);
    EXPECT_EQ(track["end"]["status"], "finite");
    EXPECT_LT(distance(track["end"]["x"], root["x"]), 1e-9);
    EXPECT_EQ(track["steps"][0]["t"], Json::parse("[0.0,0.0]"));
    EXPECT_EQ(track["steps"].back()["t"], Json::parse("[1.0,0.0]"));
  }
}

TEST(TrackCommand, FollowsThePathOfTheSeedGiven) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const auto start = [&](const char* seed) {
    const Outcome outcome =
        scene.run({"track", "f.phc", "--path", "0", "--seed", seed, "--json", "-"});
    return Json::parse(outcome.out)["steps"][0]["x"];
  };
  EXPECT_EQ(start("1"), start("1"));
  EXPECT_GT(distance(start("1"), start("2")), 1e-3);
}

TEST(TrackCommand, ShowsThatTheNewtonCorrectionReducesTheDrift) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Json track = Json::parse(scene.run({"track", "f.phc", "--path", "2", "--json", "-"}).out);
  double before = 0;
  double after = 0;
  for (const Json& step : track["steps"]) {
    before = std::max(before, step["h_before"].get<double>());
    after = std::max(after, step["h_after"].get<double>());
  }
  EXPECT_GT(before, 1e-5);
  EXPECT_LT(after, 1e-9);
}

TEST(TrackCommand, PrintsCsvAndTheVerdictApart) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run({"track", "f.phc", "--path", "0"});
  EXPECT_EQ(outcome.out.rfind("journey,s,t.re,t.im,x.re,x.im,y.re,y.im,h_before,h_after,", 0), 0U);
  EXPECT_EQ(outcome.err.rfind("path 0: finite", 0), 0U) << outcome.err;
}

TEST(TrackCommand, RefusesAPathOutOfRange) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run({"track", "f.phc", "--path", "4"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "moivre: there is no path 4: the start system has 4, numbered from 0 to 3\n");
  EXPECT_EQ(scene.run({"track", "f.phc", "--path", "-1"}).exit_code, 1);
  EXPECT_EQ(scene.run({"track", "f.phc"}).exit_code, 1);
}

TEST(TrackCommand, RefusesASystemWithoutPaths) {
  Scene scene;
  scene.write("f.phc", kParallelLines);
  const Outcome outcome = scene.run({"track", "f.phc", "--path", "0"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "moivre: there is no path to follow: elimination alone decides the system\n");
}

// x^2 = 1 + 3 t along t F + (1 - t) G: the path is known in closed form.
TEST(TrackCommand, FollowsTheStraightLineFromAStartSystemOfOnesOwn) {
  Scene scene;
  scene.write("f.phc", "1\nx^2 - 4;\n");
  scene.write("g.phc", "1\nx^2 - 1;\n");
  scene.write("points.txt", "1 0\n-1 0\n");
  const Outcome outcome = scene.run({"track", "f.phc", "--from", "g.phc", "--points", "points.txt",
                                     "--path", "1", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json track = Json::parse(outcome.out);
  EXPECT_EQ(track["start"]["kind"], "own");
  EXPECT_GT(track["steps"].size(), 3U);
  for (const Json& step : track["steps"]) {
    const double t = step["t"][0].get<double>();
    EXPECT_NEAR(step["x"][0][0].get<double>(), -std::sqrt(1 + 3 * t), 1e-8) << t;
  }
}

TEST(TrackCommand, MatchesVariablesOfAStartSystemByName) {
  Scene scene;
  scene.write("f.phc", "2\nx^2 - 4;\ny^2 - 9*x;\n");
  scene.write("g.phc", "2\n-1 + 0*y + x^2;\ny^2 - 1;\n");
  scene.write("swapped.phc", "2\ny - y + x^2 - 1;\ny^2 - 1;\n");
  scene.write("points.csv", "y.re,y.im,x.re,x.im\n1,0,1,0\n");
  for (const char* g : {"g.phc", "swapped.phc"}) {
    const Outcome outcome = scene.run(
        {"track", "f.phc", "--from", g, "--points", "points.csv", "--path", "0", "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json end = Json::parse(outcome.out)["end"];
    EXPECT_NEAR(end["x"][0][0].get<double>(), 2, 1e-9);
    EXPECT_NEAR(end["x"][1][0].get<double>(), std::sqrt(18), 1e-9);
  }
}

TEST(TrackCommand, TakesTheRootsThatSolveWrote) {
  Scene scene;
  scene.write("g.phc", kCircleAndHyperbola);
  scene.write("f.phc", "2\nx^2 + y^2 - 5.2;\nx*y - 2.1;\n");
  ASSERT_EQ(scene.run({"solve", "g.phc", "--csv", "g.csv", "--phc", "g.roots"}).exit_code, 0);
  for (const char* points : {"g.csv", "g.roots"}) {
    const Outcome outcome = scene.run(
        {"track", "f.phc", "--from", "g.phc", "--points", points, "--path", "3", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
}

TEST(TrackCommand, SaysThatAPointIsNoRootOfTheStartSystem) {
  Scene scene;
  scene.write("f.phc", "1\nx^2 - 4;\n");
  scene.write("g.phc", "1\nx^2 - 1;\n");
  scene.write("points.txt", "0 0\n");
  const Outcome outcome =
      scene.run({"track", "f.phc", "--from", "g.phc", "--points", "points.txt", "--path", "0"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "path 0: failed at t = 0: bad start; 0 steps and 0 rejected\n");
}

TEST(TrackCommand, RefusesAStartSystemThatDoesNotFit) {
  Scene scene;
  scene.write("f.phc", "1\nx^2 - 4;\n");
  scene.write("g.phc", "1\nz^2 - 1;\n");
  scene.write("fit.phc", "1\nx^2 - 1;\n");
  scene.write("points.txt", "1 0\n");
  Outcome outcome =
      scene.run({"track", "f.phc", "--from", "g.phc", "--points", "points.txt", "--path", "0"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "moivre: g.phc: the start system is in z, the problem in x\n");
  outcome =
      scene.run({"track", "f.phc", "--from", "fit.phc", "--points", "points.txt", "--path", "1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "moivre: there is no path 1: points.txt lists 1 start point, numbered from 0 to 0\n");
  outcome = scene.run({"track", "f.phc", "--from", "fit.phc", "--path", "0"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "moivre: --from and --points belong together: a start system and its roots\n");
}

}  // namespace
}  // namespace moivre::test
