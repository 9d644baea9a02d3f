// SPDX-License-Identifier: MIT
// Do the commands meet the course notes where a user would meet them? A test a page, files typed as
// on the slides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

constexpr double kSixDigits = 5e-7;  // half a unit of the sixth printed decimal
constexpr double kDegree = 0.017453292519943295769;

Json run(const Scene& scene, std::vector<std::string> command, int exit_code = 0) {
  command.insert(command.end(), {"--json", "-"});
  const Outcome outcome = scene.run(command);
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  return Json::parse(outcome.out);
}

std::vector<double> iterates(const Json& report, std::size_t coordinate) {
  std::vector<double> values;
  for (const Json& row : report["iterations"]) values.push_back(row["q"][coordinate].get<double>());
  return values;
}

/// Values of one coordinate over all closures, ascending.
std::vector<double> of_closures(const Json& report, const std::string& name) {
  std::vector<double> values;
  for (const Json& closure : report["closures"]) values.push_back(closure["coordinates"][name]);
  std::sort(values.begin(), values.end());
  return values;
}

const std::string kSquareRoot = "1\nx^2 - 4;\n";

const std::string kRedundantSystem = R"toml(
[units]
angle = "deg"
[unknowns]
angles  = ["phi1", "phi2"]
lengths = ["l1", "l2", "l3"]
[equations]
Phi1 = "6*cos(phi1) - l2"
Phi2 = "6*sin(phi1) - l3"
Phi3 = "l1*cos(phi1) - 2*cos(phi2)"
Phi4 = "l1*sin(phi1) - 2*sin(phi2) - l3 + 3"
Phi5 = "2*cos(phi2) + (6 - l1)*cos(phi1) - l2"
Phi6 = "2*sin(phi2) + (6 - l1)*sin(phi1) - 3"
[[driver]]
unknown = "phi1"
start = )toml";

const std::string kSliderCrank = R"toml(
[units]
angle = "deg"
[unknowns]
angles  = ["phi1", "phi2"]
lengths = ["d"]
[constants]
a = 2
r = 4
b = 10
[equations]
horizontal = "b*cos(phi1) + a*cos(phi2) - d"
vertical   = "b*sin(phi1) + a*sin(phi2) - r"
[[driver]]
unknown = "phi1"
start = 30
[guess]
phi2 = 320.2834
d = 10
)toml";

TEST(SeedP12, TypedAsOnTheSlideThroughClosures) {
  Scene scene;
  scene.write("at30.toml", kRedundantSystem + "30\n");
  scene.write("at60.toml", kRedundantSystem + "60\n");
  const Json at30 = run(scene, {"closures", "at30.toml"});
  EXPECT_EQ(at30["counts"]["complex"], 2);
  EXPECT_EQ(at30["counts"]["real"], 2);
  EXPECT_EQ(at30["mobility"]["rank"], 4);
  EXPECT_EQ(at30["mobility"]["degrees_of_freedom"], 1);
  EXPECT_EQ(at30["mobility"]["redundant"],
            Json::parse(R"(["Phi5 = [Phi1] - [Phi3]", "Phi6 = [Phi2] - [Phi4]"])"));
  EXPECT_NEAR(of_closures(at30, "l1")[0], -2, kSixDigits);
  EXPECT_NEAR(of_closures(at30, "l1")[1], 2, kSixDigits);
  EXPECT_NEAR(of_closures(at30, "phi2")[0] / kDegree, -150, 5e-6);
  EXPECT_NEAR(of_closures(at30, "phi2")[1] / kDegree, 30, 5e-6);
  const Json at60 = run(scene, {"closures", "at60.toml"});
  EXPECT_NEAR(of_closures(at60, "l1")[0], 0.230329, kSixDigits);
  EXPECT_NEAR(of_closures(at60, "l1")[1], 3.573518, kSixDigits);
  EXPECT_NEAR(of_closures(at60, "phi2")[0] / kDegree, -86.69895, 5e-6);
  EXPECT_NEAR(of_closures(at60, "phi2")[1] / kDegree, 26.69895, 5e-6);
  for (const double l2 : of_closures(at60, "l2")) EXPECT_NEAR(l2, 3, kSixDigits);
  for (const double l3 : of_closures(at60, "l3")) EXPECT_NEAR(l3, 5.196152, kSixDigits);
}

TEST(SeedP24, OneNewtonStepThroughTheCommand) {
  Scene scene;
  scene.write("f.phc", kSquareRoot);
  const Json report =
      run(scene, {"newton", "f.phc", "--guess", "x=10", "--max-iterations", "1"}, 2);
  EXPECT_EQ(report["status"], "iteration_limit");
  EXPECT_DOUBLE_EQ(iterates(report, 0).at(1), 10 - 96.0 / 20);
}

TEST(SeedP25, ACycleIsToldWithItsLengthAndExitCodeTwo) {
  Scene scene;
  scene.write("f.phc", "1\nx^3 - 2*x + 2;\n");
  const Outcome outcome = scene.run({"newton", "f.phc", "--guess", "x=0"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(has_line(
      outcome.out,
      "cycling: cycles after 2 steps: the iterates repeat every 2 steps; try another guess"))
      << outcome.out;
  const Json report = run(scene, {"newton", "f.phc", "--guess", "x=0"}, 2);
  EXPECT_EQ(report["cycle_length"], 2);
}

TEST(SeedP25, DivergenceAndASingularJacobianAreTold) {
  Scene scene;
  scene.write("flat.phc", "1\nx^2 + 1;\n");
  EXPECT_EQ(run(scene, {"newton", "flat.phc", "--guess", "x=0"}, 2)["status"], "singular");
  scene.write("away.toml", "[unknowns]\nlengths = [\"x\"]\n[equations]\ne = \"exp(-x)\"\n");
  const Json away = run(scene, {"newton", "away.toml", "--guess", "x=1"}, 2);
  EXPECT_NE(away["status"], "converged");
}

TEST(SeedP26, SquareRootOfFourFromTenInSevenRows) {
  Scene scene;
  scene.write("f.phc", kSquareRoot);
  const std::vector<std::string> command{"newton",      "f.phc", "--guess",          "x=10",
                                         "--tolerance", "1e-6",  "--max-iterations", "1000"};
  const std::vector<double> printed{10, 5.2, 2.984615, 2.162411, 2.006099, 2.0000093, 2.0};
  const std::vector<double> x = iterates(run(scene, command), 0);
  ASSERT_EQ(x.size(), printed.size());
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(x[k], printed[k], kSixDigits) << k;
  // The last column of the table.
  std::istringstream table(scene.run(command).out);
  std::vector<std::string> shown;
  for (std::string line; std::getline(table, line);) {
    if (contains(line, "  LU  ")) shown.push_back(line.substr(line.rfind(' ') + 1));
  }
  EXPECT_EQ(shown, (std::vector<std::string>{"10", "5.2", "2.9846154", "2.1624108", "2.006099",
                                             "2.0000093", "2"}));
}

TEST(SeedP26, GuessesAreBothRoots) {
  Scene scene;
  scene.write("f.phc", kSquareRoot);
  const Json report = run(scene, {"guesses", "f.phc"});
  ASSERT_EQ(report["guesses"].size(), 2U);
  std::vector<double> roots{report["guesses"][0]["q"][0], report["guesses"][1]["q"][0]};
  std::sort(roots.begin(), roots.end());
  EXPECT_DOUBLE_EQ(roots[0], -2);
  EXPECT_DOUBLE_EQ(roots[1], 2);
}

TEST(SeedP27, TwoByTwoFromAPolynomialFile) {
  Scene scene;
  scene.write("f.phc", "2\nx^2 + y^2 - 25;\nx*y - 12;\n");
  const Json report = run(scene, {"newton", "f.phc", "--guess", "x=5", "--guess", "y=2"});
  // J = [10 4; 2 5], Phi = (4, -2): dq = (-14/21, 14/21).
  EXPECT_NEAR(iterates(report, 0).at(1), 5 - 2.0 / 3, 1e-14);
  EXPECT_NEAR(iterates(report, 1).at(1), 2 + 2.0 / 3, 1e-14);
  EXPECT_NEAR(report["coordinates"]["x"].get<double>(), 4, 1e-14);
  EXPECT_NEAR(report["coordinates"]["y"].get<double>(), 3, 1e-14);
  EXPECT_EQ(run(scene, {"guesses", "f.phc"})["guesses"].size(), 4U);
}

TEST(SeedP28, NByNFromAPolynomialFile) {
  constexpr int kSize = 6;  // x_k^2 + x_1 + ... + x_n = n + 1: all ones
  std::ostringstream text;
  text << kSize << '\n';
  std::vector<std::string> command{"newton", "f.phc"};
  for (int k = 1; k <= kSize; ++k) {
    text << 'x' << k << "^2";
    for (int j = 1; j <= kSize; ++j) text << " + x" << j;
    text << " - " << kSize + 1 << ";\n";
    std::ostringstream guess;
    guess << 'x' << k << "=1." << k;
    command.insert(command.end(), {"--guess", guess.str()});
  }
  Scene scene;
  scene.write("f.phc", text.str());
  const Json report = run(scene, command);
  EXPECT_EQ(report["status"], "converged");
  EXPECT_EQ(report["iterations"][0]["method"], "LU");
  for (const auto& [name, value] : report["coordinates"].items()) {
    EXPECT_NEAR(value.get<double>(), 1, 1e-14) << name;
  }
}

TEST(SeedP29, TypedAsOnTheSlideThroughNewtonAndClosures) {
  Scene scene;
  scene.write("f.toml", kSliderCrank);
  const Json newton =
      run(scene, {"newton", "f.toml", "--guess", "phi2=320.283407294986", "--guess", "d=10"});
  const double printed[][2] = {
      {5.59, 10}, {5.770692, 10.429604}, {5.759621, 10.392446}, {5.759587, 10.392305}};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(iterates(newton, 1).at(k), printed[k][0], kSixDigits) << k;
    EXPECT_NEAR(iterates(newton, 2).at(k), printed[k][1], kSixDigits) << k;
  }
  const Json closures = run(scene, {"closures", "f.toml"});
  EXPECT_EQ(closures["paths"]["tracked"], 2);
  EXPECT_NEAR(of_closures(closures, "d")[0], 4 * std::sqrt(3.0), 1e-13);
  EXPECT_NEAR(of_closures(closures, "d")[1], 6 * std::sqrt(3.0), 1e-13);
  EXPECT_NEAR(of_closures(closures, "phi2")[0] / kDegree, 210 - 360, 1e-12);
  EXPECT_NEAR(of_closures(closures, "phi2")[1] / kDegree, 330 - 360, 1e-12);
  EXPECT_EQ(run(scene, {"guesses", "f.toml"})["guesses"].size(), 2U);
}

// b cos 30 + a c - d = 0, b sin 30 + a s - r = 0, c^2 + s^2 = 1.
TEST(SeedP30, Example313AsPolynomialsHasBothRoots) {
  Scene scene;
  scene.write("f.phc", "3\n8.660254037844386 + 2*c - d;\n5 + 2*s - 4;\nc^2 + s^2 - 1;\n");
  const Json report = run(scene, {"solve", "f.phc"});
  ASSERT_EQ(report["solutions"].size(), 2U);
  std::vector<double> d;
  for (const Json& root : report["solutions"]) d.push_back(root["x"][1][0]);
  std::sort(d.begin(), d.end());
  EXPECT_NEAR(d[0], 4 * std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(d[1], 6 * std::sqrt(3.0), 1e-14);
}

// Three legs from (0,0), (15.91,0), (0,10) to a platform at (x, y) turned by (c, s).
TEST(SeedP30, A3RprPlatformInCosinesHasSixRootsAndTenPathsToInfinity) {
  Scene scene;
  scene.write("f.phc",
              "4\n"
              "x^2 + y^2 - 14.98^2;\n"
              "(x + 17.04*c - 15.91)^2 + (y + 17.04*s)^2 - 15.38^2;\n"
              "(x + 13.236373239436617*c - 16.09670846683651*s)^2 +"
              " (y + 13.236373239436617*s + 16.09670846683651*c - 10)^2 - 12^2;\n"
              "c^2 + s^2 - 1;\n");
  const Json report = run(scene, {"solve", "f.phc"});
  EXPECT_EQ(report["paths"]["tracked"], 16);
  EXPECT_EQ(report["paths"]["finite"], 6);
  EXPECT_EQ(report["paths"]["at_infinity"], 10);
  EXPECT_EQ(report["paths"]["failed"], 0);
}

TEST(SeedP36, WeightedMinimumNormStepThroughTheCommand) {
  Scene scene;
  scene.write("sphere.phc", "1 3\nx^2 + y^2 + z^2 - 4;\n");
  std::vector<std::string> command{"newton",  "sphere.phc", "--guess", "x=2",
                                   "--guess", "y=1",        "--guess", "z=2"};
  const Json plain = run(scene, command);
  EXPECT_EQ(plain["iterations"][0]["method"], "minimum norm");
  const double by_plain[] = {-0.555556, -0.277778, -0.555556};
  command.insert(command.end(), {"--weight", "y=2", "--weight", "z=4"});
  const Json weighted = run(scene, command);
  const double by_weights[] = {-0.909091, -0.227273, -0.227273};
  const double guess[] = {2, 1, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(iterates(plain, k).at(1) - guess[k], by_plain[k], kSixDigits) << k;
    EXPECT_NEAR(iterates(weighted, k).at(1) - guess[k], by_weights[k], kSixDigits) << k;
  }
}

}  // namespace
}  // namespace moivre::test
