// SPDX-License-Identifier: MIT
// Do the commands that draw keep their contract: where pictures go, and what is refused before the
// work?
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

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

TEST(Pictures, CountWhatClosesWithinFit) {
  const Scene scene;
  const std::string bars = MOIVRE_SOURCE_DIR "/problems/people/fit-not-assembled.toml";
  const Outcome drawn = scene.run({"closures", bars, "--fit", "0.05", "--svg", "closures.svg"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  // The page drives the bars through a whole turn, which is not all decided.
  scene.run({"closures", bars, "--fit", "0.05", "--html", "closures.html"});
  for (const char* file : {"closures.svg", "closures.html"}) {
    EXPECT_TRUE(contains(scene.read(file), "0 complex closures, 0 real, 1 within fit")) << file;
  }
}

/// A slider-crank drawn with the slider on the right: closure A has it on the left.
constexpr const char* kDrawnSliderCrank = R"([units]
angle = "deg"
[ground.points]
O = [0, 0]
[body.crank.points]
O = [0, 0]
A = [1, 0]
[body.slider.points]
B = [4, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "rod"
at = ["crank.A", "slider.B"]
length = 3
[[joint]]
type = "prismatic"
at = ["ground.O", "slider.B"]
along = [1, 0]
name = "guide"
[[driver]]
angle = "crank"
velocity = 360
)";

TEST(Pictures, AreTitledByTheFilesNameAndNotItsFolder) {
  Scene scene;
  std::filesystem::create_directory(scene.path("folder"));
  scene.write("folder/drawn.toml", kDrawnSliderCrank);
  const std::string file = scene.path("folder/drawn.toml");
  scene.run({"closures", file, "--svg", "closures.svg", "--html", "closures.html"});
  scene.run({"motion", file, "--svg", "motion.svg"});
  scene.run({"sweep", file, "--vary", "crank=0:90:2", "--svg", "sweep.svg", "--html", "s.html"});
  for (const char* picture :
       {"closures.svg", "closures.html", "motion.svg", "sweep.svg", "s.html"}) {
    EXPECT_TRUE(contains(scene.read(picture), ">drawn.toml<")) << picture;
    EXPECT_FALSE(contains(scene.read(picture), "folder")) << picture;
  }
}

TEST(Pictures, OfMotionsShowTheMechanismAsItIsDrawn) {
  Scene scene;
  scene.write("drawn.toml", kDrawnSliderCrank);
  const Outcome outcome = scene.run({"motion", "drawn.toml", "--svg", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::vector<double> x;
  const std::string pin = "class=\"pin\" cx=\"";
  for (std::size_t at = outcome.out.find(pin); at != std::string::npos;
       at = outcome.out.find(pin, at + 1)) {
    x.push_back(std::stod(outcome.out.substr(at + pin.size())));
  }
  ASSERT_GE(x.size(), 3U);
  EXPECT_EQ(*std::min_element(x.begin(), x.end()), x.front());
}

TEST(Pictures, NameARodOnlyAsItsFileDoes) {
  Scene scene;
  scene.write("drawn.toml", kDrawnSliderCrank);
  EXPECT_FALSE(contains(scene.run({"closures", "drawn.toml", "--svg", "-"}).out, "crank.A-"));
  std::string named = kDrawnSliderCrank;
  named.replace(named.find("length = 3"), 10, "length = 3\nname = \"pitman\"");
  scene.write("named.toml", named);
  EXPECT_TRUE(contains(scene.run({"closures", "named.toml", "--svg", "-"}).out, ">pitman<"));
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
