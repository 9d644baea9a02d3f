// SPDX-License-Identifier: MIT
// Do the commands that draw keep their contract: where pictures go, and what is refused before the work?
#include <gtest/gtest.h>

#include "program.h"

namespace moivre::test {
namespace {

constexpr const char* kFourBar = MOIVRE_SOURCE_DIR "/problems/mechanisms/four-bar.toml";

TEST(Pictures, OfClosuresGoToAFileBesideTheText) {
  const Scene scene;
  const Outcome outcome = scene.run({"closures", kFourBar, "--svg", "closures.svg"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "closure A"));
  EXPECT_EQ(scene.read("closures.svg").substr(0, 5), "<svg ");
}

TEST(Pictures, OfClosuresOnStandardOutputStandAlone) {
  const Scene scene;
  const Outcome outcome = scene.run({"closures", kFourBar, "--svg", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 5), "<svg ");
  EXPECT_FALSE(contains(outcome.out, "closure A"));
}

TEST(Pictures, ThatCannotBeWrittenAreRefusedBeforeTheWork) {
  const Scene scene;
  const Outcome outcome = scene.run({"closures", kFourBar, "--svg", "no/such/folder.svg"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "moivre: cannot write no/such/folder.svg: No such file or directory\n");
}

TEST(Pictures, DoNotOverwriteTheMechanismOrAnotherResult) {
  const Scene scene;
  scene.write("triangle.toml", "title = \"nothing\"\n");
  EXPECT_EQ(scene.run({"closures", "triangle.toml", "--svg", "triangle.toml"}).exit_code, 1);
  EXPECT_EQ(scene.read("triangle.toml"), "title = \"nothing\"\n");
  const Outcome outcome = scene.run({"closures", kFourBar, "--svg", "a", "--json", "a"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "moivre: two results would go to a\n");
}

}  // namespace
}  // namespace moivre::test
