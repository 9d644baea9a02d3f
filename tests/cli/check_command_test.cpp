// SPDX-License-Identifier: MIT
// Does moivre check pass what moivre solve says of its problems, find what was changed, and refuse
// what is no result?
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

// Files of problems/: regular roots, multiple ones, sets, ill-scaled and ill-conditioned ones, more
// equations than unknowns.
const char* const kHonest[] = {"polynomials/badvars.phc",
                               "polynomials/burmester-5.phc",
                               "polynomials/cascade-4.phc",
                               "polynomials/cassou.phc",
                               "polynomials/chandra-5.phc",
                               "polynomials/cyclic-5.phc",
                               "polynomials/dense-complex-4-3.phc",
                               "polynomials/double-lines-4.phc",
                               "polynomials/duplicated-equation.phc",
                               "polynomials/eco-6.phc",
                               "polynomials/griewank-osborne.phc",
                               "polynomials/katsura-6.phc",
                               "polynomials/lotka-volterra-3.bertini",
                               "polynomials/multiplicity-3.phc",
                               "polynomials/multiplicity-4.phc",
                               "polynomials/near-double.phc",
                               "polynomials/noon-3.phc",
                               "polynomials/one-root.phc",
                               "polynomials/puma.phc",
                               "polynomials/reimer-4.phc",
                               "polynomials/wilkinson-15.phc",
                               "polynomials/wnt.phc",
                               "extremes/denormal.phc",
                               "extremes/large-root.phc",
                               "extremes/four-near.phc",
                               "extremes/overdetermined.phc",
                               "rectangular/minors-2-3.phc"};

TEST(CheckCommand, PassesWhatSolveSaysOfItsProblems) {
  if (!MOIVRE_WITH_CERTIFY) GTEST_SKIP() << "needs more digits";
  const Scene scene;
  for (const char* name : kHonest) {
    const std::string file = std::string(MOIVRE_SOURCE_DIR) + "/problems/" + name;
    const Outcome solved =
        scene.run({"solve", file, "--tracker", "lanes", "--quiet", "--json", "r.json"});
    ASSERT_EQ(solved.exit_code, 0) << name << solved.err;
    const Outcome outcome = scene.run({"check", file, "r.json"});
    EXPECT_EQ(outcome.exit_code, 0) << name << '\n' << outcome.out << outcome.err;
  }
}

TEST(CheckCommand, FindsWhichOfTwoRootsWithOneDoubleIsClaimed) {
  if (!MOIVRE_WITH_CERTIFY) GTEST_SKIP() << "needs more digits";
  const Scene scene;
  scene.write("near.phc",
              "(1e60*x - 606980913381131154936909844056454082055736521972196800997507)*"
              "(1e60*x - 606980913381131154936909844056454082055636521972196800997507);");
  for (const char* seed : {"101", "102", "103", "104", "105"}) {
    const Outcome solved = scene.run(
        {"solve", "near.phc", "--tracker", "lanes", "--seed", seed, "--quiet", "--json", "r.json"});
    ASSERT_EQ(solved.exit_code, 0) << solved.err;
    const Outcome outcome = scene.run({"check", "near.phc", "r.json"});
    EXPECT_EQ(outcome.exit_code, 0) << seed << '\n' << outcome.out << outcome.err;
  }
}

TEST(CheckCommand, JudgesSystemsBeyondDouble) {
  if (!MOIVRE_WITH_CERTIFY) GTEST_SKIP() << "needs more digits";
  const Scene scene;
  scene.write("f.phc", "1e400*(x^2 + 3*x*y - 10); 2e-400*x*y - 3e-400*y + 1e-401;");
  for (const char* tracker : {"lanes", "cvode"}) {
    const Outcome solved =
        scene.run({"solve", "f.phc", "--tracker", tracker, "--quiet", "--json", "r.json"});
    ASSERT_EQ(solved.exit_code, 0) << solved.err;
    EXPECT_EQ(Json::parse(scene.read("r.json"))["completeness"], "proved");
    const Outcome outcome = scene.run({"check", "f.phc", "r.json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  }
  scene.write("apart.phc", "1e400*x - 1e-400*y; x*y - 1;");
  const Outcome refused = scene.run({"solve", "apart.phc"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_TRUE(contains(refused.err, "out of the range of double")) << refused.err;
}

TEST(CheckCommand, RefutesARootThatDoesNotMeetAConditionOfTheFile) {
  const Scene scene;
  const std::string circle = "x^2 + y^2 = 5\nx*y = 2\n";  // +-(1, 2), +-(2, 1)
  scene.write("all.txt", circle);
  scene.write("wanted.txt", circle + "x > 0\nx*y <= 2\n");
  scene.run({"solve", "wanted.txt", "--quiet", "--json", "wanted.json"});
  const Outcome honest = scene.run({"check", "wanted.txt", "wanted.json"});
  EXPECT_EQ(honest.exit_code, 2) << "the two others are not listed\n" << honest.out;
  EXPECT_TRUE(contains(honest.out, "nothing that follows a path\n")) << honest.out;
  EXPECT_TRUE(contains(honest.out, "\nEvery claim that can be verified holds.\n")) << honest.out;
  EXPECT_TRUE(contains(honest.out, "  inequality        4       0       0\n")) << honest.out;
  scene.run({"solve", "all.txt", "--quiet", "--json", "all.json"});
  const Outcome lie = scene.run({"check", "wanted.txt", "all.json"});
  EXPECT_EQ(lie.exit_code, 2);
  EXPECT_TRUE(contains(lie.out, "inequality: does not meet x > 0\n")) << lie.out;
}

TEST(CheckCommand, AProofOfRootsThatAFilterLeftOutEndsWithExitCodeTwo) {
  if (!MOIVRE_WITH_CERTIFY) GTEST_SKIP() << "needs certificates";
  const Scene scene;
  scene.write("curves.txt", "x^2 + y^2 = 5\nx*y = 2\n");
  const auto checked = [&](const std::string& filter) {
    const Outcome solved =
        scene.run({"solve", "curves.txt", "--quiet", "--json", "r.json", filter});
    EXPECT_EQ(solved.exit_code, 0) << filter << solved.err;
    return scene.run({"check", "curves.txt", "r.json"});
  };
  EXPECT_EQ(checked("--real").exit_code, 0) << "all four are real";
  const Outcome outcome = checked("--positive");
  EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "and 2 are not listed")) << outcome.out;
}

TEST(CheckCommand, FindsWhatWasChanged) {
  const Scene scene;
  scene.write("plane.phc", "3\nx^2 + y^2 + z^2 - 6;\nx*y - z - 1;\nx + y + z - 4;\n");
  scene.run({"solve", "plane.phc", "--quiet", "--json", "r.json"});
  Json result = Json::parse(scene.read("r.json"));
  result["solutions"][1]["real"] = false;
  result["paths"]["at_infinity"] = 1;
  scene.write("lie.json", result.dump());
  const Outcome outcome = scene.run({"check", "plane.phc", "lie.json", "--json", "judged.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(has_line(outcome.out, "  root 2, real: called not real, and proved to be real"))
      << outcome.out;
  EXPECT_TRUE(has_line(
      outcome.out,
      "  paths: tracked, as finite + at_infinity + failed + not_needed: 4 stated, 5 found"))
      << outcome.out;
  const Json judged = Json::parse(scene.read("judged.json"));
  EXPECT_EQ(judged["holds"], false);
  const Json paths{
      {"root", nullptr},
      {"claim", "paths"},
      {"why", "tracked, as finite + at_infinity + failed + not_needed: 4 stated, 5 found"}};
  const Json real{
      {"root", 2}, {"claim", "real"}, {"why", "called not real, and proved to be real"}};
  EXPECT_EQ(judged["refuted"], Json::array({paths, real}));
  EXPECT_EQ(judged["proved_by"], "Bezout");
  const Outcome quiet = scene.run({"check", "plane.phc", "lie.json", "--quiet"});
  EXPECT_EQ(quiet.exit_code, 2);
  EXPECT_EQ(quiet.out, "");
}

TEST(CheckCommand, JudgesOurOwnSolutionLists) {
  const Scene scene;
  scene.write("conics.phc", "2\nx^2 + y^2 - 5;\nx*y - 2;\n");
  scene.run({"solve", "conics.phc", "--quiet", "--phc", "list.phc"});
  const Outcome outcome = scene.run({"check", "conics.phc", "list.phc", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const Json judged = Json::parse(outcome.out);
  EXPECT_EQ(judged["form"], "solution list");
  EXPECT_EQ(judged["roots"]["certified"], 4);
  EXPECT_EQ(judged["roots"]["distinct"], 4);
  EXPECT_EQ(judged["roots"]["real"], 4);
  EXPECT_EQ(judged["roots"]["not_real"], 0);
}

TEST(CheckCommand, ReadsOneFileFromStandardInput) {
  const Scene scene;
  scene.write("conics.phc", "2\nx^2 + y^2 - 5;\nx*y - 2;\n");
  scene.write(Scene::kInput, scene.run({"solve", "conics.phc", "--json", "-"}).out);
  EXPECT_EQ(scene.run({"check", "conics.phc", "-"}).exit_code, 0);
  const Outcome both = scene.run({"check", "-", "-"});
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_EQ(both.err, "moivre: system and result cannot both come from standard input\n");
}

TEST(CheckCommand, RefusesWhatIsNoResult) {
  const Scene scene;
  scene.write("conics.phc", "2\nx^2 + y^2 - 5;\nx*y - 2;\n");
  scene.write("foreign.json", R"({"command": "closures"})");
  scene.write("cut.json", R"({"command": "solve", "seed": )");
  const auto refused = [&](const std::string& file, const std::string& reason) {
    const Outcome outcome = scene.run({"check", "conics.phc", file, "--json", "never.json"});
    EXPECT_EQ(outcome.exit_code, 1) << file;
    EXPECT_EQ(outcome.err, reason);
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(scene.has("never.json"));
  };
  refused("foreign.json",
          "moivre: foreign.json: no result of moivre solve\n"
          "  command: expected the JSON of \"solve\"\n");
  refused("cut.json",
          "cut.json:1:30: error: the JSON is broken or cut off here\n"
          "    {\"command\": \"solve\", \"seed\": \n"
          "                                 ^\n");
  refused("conics.phc",
          "moivre: conics.phc: neither the JSON of moivre solve nor a solution list of PHCpack "
          "(THE SOLUTIONS)\n");
  refused("absent.json", "moivre: absent.json: cannot be opened: No such file or directory\n");
}

}  // namespace
}  // namespace moivre::test
