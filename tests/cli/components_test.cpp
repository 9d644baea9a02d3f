// SPDX-License-Identifier: MIT
// Does the program say what was built into it, and what was not, when it is asked for it?
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

constexpr bool kWithCvode = MOIVRE_WITH_CVODE;
constexpr bool kWithLanes = MOIVRE_WITH_LANES;
constexpr bool kWithCertify = MOIVRE_WITH_CERTIFY;
constexpr bool kWithMechanism = MOIVRE_WITH_MECHANISM;

const std::string kConics = "2\nx^2 + y^2 - 5;\nx*y - 2;\n";

TEST(Components, AreListedWithTheVerboseVersion) {
  const Outcome outcome = Scene().run({"--version", "--verbose"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(contains(outcome.out, "moivre " MOIVRE_VERSION "\n"));
  EXPECT_TRUE(contains(outcome.out, "components:  numeric, factorization, expression"));
  EXPECT_EQ(contains(outcome.out, "tracker_cvode"), kWithCvode);
  EXPECT_EQ(contains(outcome.out, "tracker_lanes"), kWithLanes);
  EXPECT_EQ(contains(outcome.out, "kinematics"), kWithMechanism);
  EXPECT_TRUE(contains(outcome.out, "Eigen3 3."));
  EXPECT_EQ(contains(outcome.out, "SUNDIALS "), kWithCvode);
  EXPECT_EQ(contains(outcome.out, "tomlplusplus "), kWithMechanism);
  EXPECT_TRUE(contains(outcome.out, "compiler:    "));
}

TEST(Components, SolveWithWhatIsThere) {
  const Scene scene;
  scene.write("conics.phc", kConics);
  const bool solves = kWithCvode || kWithLanes;
  EXPECT_EQ(scene.run({"solve", "conics.phc"}).exit_code, solves ? 0 : 1);
  EXPECT_EQ(scene.run({"info", "conics.phc"}).exit_code, 0);
}

TEST(Components, ProveWhatTheyCan) {
  if (!kWithCvode && !kWithLanes) GTEST_SKIP() << "nothing solves here";
  const Scene scene;
  scene.write("conics.phc", kConics);
  const std::string tracker = kWithCvode ? "cvode" : "lanes";
  const auto solve = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"solve", "conics.phc", "--tracker", tracker});
    return scene.run(options).out;
  };
  const std::string text = solve({});
  EXPECT_EQ(contains(text, "this program was built without them (MOIVRE_WITH_CERTIFY)"),
            !kWithCertify)
      << text;
  const Json proved = Json::parse(solve({"--json", "-"}));
  EXPECT_EQ(proved["completeness"], "proved");
  EXPECT_EQ(proved["solutions"][0]["certified"], true);
  EXPECT_EQ(proved["bound"],
            Json({{"kind", "total degree"}, {"value", 4}, {"certainty", "theorem"}}));
  const Json without = Json::parse(solve({"--no-certify", "--json", "-"}));
  EXPECT_EQ(without["completeness"], nullptr);
  EXPECT_EQ(without["solutions"][0]["certified"], nullptr);
}

TEST(Components, AreNamedByTheTrackersThatMissThem) {
  const Scene scene;
  scene.write("conics.phc", kConics);
  const std::pair<const char*, bool> trackers[]{{"cvode", kWithCvode}, {"lanes", kWithLanes}};
  for (const auto& [tracker, is_built] : trackers) {
    const Outcome outcome = scene.run({"solve", "conics.phc", "--tracker", tracker});
    EXPECT_EQ(outcome.exit_code, is_built ? 0 : 1) << tracker;
    EXPECT_EQ(contains(outcome.err, "this program was built without the"), !is_built)
        << outcome.err;
  }
}

TEST(Components, AreNamedByTheCommandsThatMissThem) {
  const Scene scene;
  scene.write("conics.phc", kConics);
  for (const char* command : {"closures", "newton", "mobility", "guesses"}) {
    const Outcome outcome = scene.run({command, "conics.phc", "--json", "-"});
    EXPECT_EQ(
        contains(outcome.err, std::string(command) + ": this program was built without mechanisms "
                                                     "(MOIVRE_WITH_MECHANISM)"),
        !kWithMechanism)
        << outcome.err;
  }
}

}  // namespace
}  // namespace moivre::test
