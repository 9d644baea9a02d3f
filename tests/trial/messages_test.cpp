// SPDX-License-Identifier: MIT
// Does the program say what is odd, and what to do about a slip?
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "files.h"

namespace moivre::test {
namespace {

/// The trial's file with `from` replaced by `to`, the first time that it stands there.
std::string changed(const std::string& name, const std::string& from, const std::string& to) {
  std::ifstream file(trial(name));
  std::ostringstream text;
  text << file.rdbuf();
  std::string all = text.str();
  const std::size_t at = all.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return all.replace(at, from.size(), to);
}

/// What is said of a file with this text.
std::string said_of(const std::string& text) {
  Scene scene;
  scene.write("typed.toml", text);
  const Outcome outcome = scene.run({"closures", "typed.toml"});
  EXPECT_EQ(outcome.exit_code, 1);
  return outcome.err;
}

TEST(TooManyDrivers, AreWarnedOf) {
  for (const std::string command : {"closures", "mobility", "newton"}) {
    const Answer answer = answered(command, "18-two-drivers");
    ASSERT_GE(answer.json.at("warnings").size(), 1U) << command;
    EXPECT_TRUE(contains(answer.json.at("warnings").at(0), "too many drivers")) << command;
    EXPECT_TRUE(contains(tried(command, "18-two-drivers").out, "warning: ")) << command;
  }
}

TEST(NoDriver, IsSaidByClosuresAndRefusedByMotion) {
  const std::string message = answered("closures", "nodriver").json.at("message");
  EXPECT_TRUE(contains(message, "moves")) << message;
  EXPECT_TRUE(contains(message, "no driver")) << message;
  EXPECT_FALSE(contains(message, "though the drivers stand")) << message;
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, std::vector<std::string>{"--from-guess"}}) {
    const Outcome motion = tried("motion", "nodriver", options);
    EXPECT_EQ(motion.exit_code, 1);
    EXPECT_TRUE(contains(motion.err, "no driver")) << motion.err;
  }
}

TEST(LoosePivot, IsWarnedOf) {
  const Answer answer = answered("closures", "17-wrong-closing");
  ASSERT_EQ(answer.json.at("warnings").size(), 1U);
  EXPECT_TRUE(contains(answer.json.at("warnings").at(0), "ground.O4"));
  EXPECT_EQ(answered("closures", "roller").json.at("warnings").size(), 0U);
}

TEST(DecimalComma, IsPointedOut) {
  const Outcome point = tried("closures", "01-decimal-comma");
  EXPECT_TRUE(contains(point.err, "decimals have a point: 40.5, not 40,5")) << point.err;
  const std::string start = said_of(changed("roller", "start = 40", "start = 40,5"));
  EXPECT_TRUE(contains(start, "decimals have a point")) << start;
  const std::string space = said_of(changed("roller", "[40, 0]", "[40, 0, 0]"));
  EXPECT_FALSE(contains(space, "decimals have a point")) << space;
}

TEST(UnitOnANumber, IsPointedOut) {
  for (const std::string& text : {changed("roller", "[40, 0]", "[40 mm, 0]"),
                                  changed("roller", "start = 40", "start = 40 deg"),
                                  changed("roller", "start = 40", "start = 40\xc2\xb0")}) {
    const std::string said = said_of(text);
    EXPECT_TRUE(contains(said, "without a unit")) << said;
  }
}

TEST(BracketsOfAJoint, AreTwo) {
  std::string text = changed("roller", "[[joint]]", "@");
  text.replace(text.find("[[joint]]"), 9, "[joint]");
  text.replace(text.find('@'), 1, "[[joint]]");
  const std::string later = said_of(text);
  EXPECT_TRUE(contains(later, "[[joint]], in two brackets")) << later;
  const std::string first = said_of(changed("roller", "[[joint]]", "[joint]"));
  EXPECT_TRUE(contains(first, "[[joint]], in two brackets")) << first;
}

TEST(UnitsByOtherNames, AreToldTheirOwn) {
  const std::string inch = said_of(changed("roller", "\"mm\"", "\"inch\""));
  EXPECT_TRUE(contains(inch, "here it is called 'in'")) << inch;
  const std::string degrees = said_of(changed("roller", "\"deg\"", "\"degrees\""));
  EXPECT_TRUE(contains(degrees, "here it is called 'deg'")) << degrees;
}

TEST(UnitOnAnOption, IsPointedOut) {
  const Outcome unit = tried("motion", "roller", {"--to", "10s"});
  EXPECT_EQ(unit.exit_code, 1);
  EXPECT_TRUE(contains(unit.err, "--to takes a number, not 10s: write 10, without a unit"))
      << unit.err;
  const Outcome comma = tried("motion", "roller", {"--to=0,5"});
  EXPECT_TRUE(contains(comma.err, "decimals have a point")) << comma.err;
}

TEST(NewtonsVerdict, IsSaidOnce) {
  const Outcome outcome = tried("newton", "roller");
  EXPECT_FALSE(contains(outcome.out, "converged: converged")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "converged after")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "misfit")) << outcome.out;
}

}  // namespace
}  // namespace moivre::test
