// SPDX-License-Identifier: MIT
// Does the program say what is odd, and what to do about a slip?
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>
#include <vector>

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
  const std::string warning =
      "coordinates minus constraints are 1, drivers are 2: too many drivers, unless constraints "
      "are redundant (moivre mobility tells)";
  for (const std::string command : {"closures", "mobility", "newton"}) {
    const Answer answer = answered(command, "18-two-drivers");
    ASSERT_GE(answer.json.at("warnings").size(), 1U) << command;
    EXPECT_EQ(answer.json.at("warnings").at(0), warning) << command;
    EXPECT_TRUE(has_line(tried(command, "18-two-drivers").out, "warning: " + warning)) << command;
  }
}

TEST(RedundantConstraints, AreNoDrivers) {
  const std::string bennett = MOIVRE_SOURCE_DIR "/problems/mechanisms/bennett.toml";
  const Outcome outcome = Scene().run({"mobility", bennett});
  EXPECT_TRUE(has_line(outcome.out,
                       "warning: coordinates minus constraints are -2: it closes only where "
                       "constraints are redundant (moivre mobility names them)"))
      << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "drivers are"));
}

TEST(AnglesOfManyTurns, AreWarnedOfWhereNoUnitIsNamed) {
  Scene scene;
  scene.write("typed.toml", changed("roller", "angle = \"deg\"", ""));
  const std::string warning =
      "warning: angles are radians where [units] names none: driver crank = 40 is 6.37 turns; for "
      "degrees write angle = \"deg\" under [units]";
  EXPECT_TRUE(has_line(scene.run({"closures", "typed.toml"}).out, warning));
  std::string from_zero = changed("roller", "angle = \"deg\"", "");
  const std::string law = "start = 40\nvelocity = 1432.3944878270581";
  from_zero.replace(from_zero.find(law), law.size(), "start = 0\nvelocity = 360");
  scene.write("typed.toml", from_zero);
  EXPECT_TRUE(contains(scene.run({"closures", "typed.toml"}).out,
                       "the velocity of driver crank = 360 is 57.3 turns per second;"));
  scene.write("typed.toml", changed("roller", "angle = \"deg\"", "angle = \"rad\""));
  EXPECT_FALSE(contains(scene.run({"closures", "typed.toml"}).out, "warning"));
}

TEST(NoDriver, IsSaidByClosuresAndRefusedByMotion) {
  EXPECT_EQ(
      answered("closures", "nodriver").json.at("message"),
      "moves: the closures form a set of positive dimension; there is no driver that holds it");
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, std::vector<std::string>{"--from-guess"}}) {
    const Outcome motion = tried("motion", "nodriver", options);
    EXPECT_EQ(motion.exit_code, 1);
    EXPECT_EQ(motion.err,
              "moivre: there is no driver, so that nothing moves: add a [[driver]], such as angle "
              "= \"crank\", start = 0, velocity = 10\n");
  }
}

TEST(LoosePivot, IsWarnedOf) {
  const Answer answer = answered("closures", "17-wrong-closing");
  ASSERT_EQ(answer.json.at("warnings").size(), 1U);
  EXPECT_EQ(answer.json.at("warnings").at(0),
            "no joint holds anything at 'ground.O4': is one tied elsewhere?");
  EXPECT_EQ(answered("closures", "roller").json.at("warnings").size(), 0U);
}

TEST(DecimalComma, IsPointedOut) {
  const Outcome point = tried("closures", "01-decimal-comma");
  EXPECT_EQ(point.err, trial("01-decimal-comma") +
                           ":16:6: error: point 'crank.A' must be 2 numbers in brackets, not 3 "
                           "entries; decimals have a point: 40.5, not 40,5\n"
                           "    A  = [40,5, 0]\n"
                           "         ^\n");
  const std::string start = said_of(changed("roller", "start = 40", "start = 40,5"));
  EXPECT_TRUE(contains(start, "; decimals have a point: 40.5, not 40,5\n    start = 40,5\n"))
      << start;
  const std::string space = said_of(changed("roller", "[40, 0]", "[40, 0, 0]"));
  EXPECT_EQ(space,
            "typed.toml:16:6: error: point 'crank.A' must be 2 numbers in brackets, not 3 entries\n"
            "    A  = [40, 0, 0]\n"
            "         ^\n");
}

TEST(SlipsOfTheHand, AreToldWhatWasMeant) {
  const std::vector<std::array<std::string, 3>> slips{
      {"[40, 0]", "[40 0]", "',' is missing before this entry of the array"},
      {"[40, 0]", "[40; 0]", "; the entries of an array are parted by commas"},
      {"[40, 0]", "[.5, 0]", "; digits stand on both sides of the point: 0.5, 5.0"},
      {"[40, 0]", "[5., 0]", "; digits stand on both sides of the point: 0.5, 5.0"},
      {"[40, 0]", "[4.5; 0]", "; the entries of an array are parted by commas"},
      {"[40, 0]", "[1e, 0]", "; an exponent is a whole number, as in 1e-3"},
      {"start = 40", "start = 4e+", "; an exponent is a whole number, as in 1e-3"},
      {"start = 40", "start = 4.5e1.5", "; an exponent is a whole number, as in 1e-3"},
      {"[40, 0]", "[1.2.3, 0]", "; a number has one decimal point"},
      {"[40, 0]", "[--40, 0]", "; a number has one sign"},
      {"[40, 0]", "[040, 0]", "; a number has no zeros in front: 7, not 007"},
      {"start = 40", "start = \"40 deg\"", "; numbers stand without quotes and units"},
      {"start = 40", "start = .5", "; digits stand on both sides of the point: 0.5, 5.0"},
      {"start = 40", "start = 40;", "; a value ends with its line, without ';'"},
      {"start = 40", "start = 40 ; upright", "; comments begin with #"},
      {"start = 40", "start = pi/3",
       "; numbers are written out, such as 1.0471976 for pi/3; only a driver's value = \"...\" is "
       "an "
       "expression"},
      {"start = 40", "start = piston", "; text stands in quotes, as in title = \"...\""},
      {"start = 40", "start = 4 000", "; the digits of a number stand without blanks"},
      {"start = 40", "start: 40", "; a key and its value are joined by '='"},
      {"start = 40", "start 40", "; a key and its value are joined by '='"},
      {"start = 40", "sta rt = 40", "; names have letters, digits, '_' and '-', and no blanks"},
      {"\"deg\"", "\u201cdeg\u201d",
       "; quotes are straight, \"...\", not those of a word processor"},
      {"[ground.points]", "[ground;points]",
       "; names have letters, digits, '_' and '-', and no blanks"},
      {"[ground.points]", "[points]", "; points stand under [ground.points] or [body.NAME.points]"},
      {"[ground.points]", "[Ground.points]", "did you mean 'ground'?"}};
  for (const auto& [right, wrong, advice] : slips) {
    const std::string said = said_of(changed("roller", right, wrong));
    EXPECT_TRUE(contains(said, advice + "\n")) << wrong << '\n' << said;
  }
}

TEST(UnitOnANumber, IsPointedOut) {
  for (const std::string& text : {changed("roller", "[40, 0]", "[40 mm, 0]"),
                                  changed("roller", "start = 40", "start = 40 deg"),
                                  changed("roller", "start = 40", "start = 40deg"),
                                  changed("roller", "start = 40", "start = 4.5deg"),
                                  changed("roller", "start = 40", "start = 40\xc2\xb0")}) {
    const std::string said = said_of(text);
    EXPECT_TRUE(
        contains(said, "; numbers stand without a unit, [units] says it once for the whole file\n"))
        << said;
  }
}

TEST(ArrayThatIsOpen, IsSaidAtTheEndOfTheFileToo) {
  for (const std::string end : {"", "\n", "\n\n", " # mm\n\n"}) {
    EXPECT_EQ(said_of("x = [40, 0" + end),
              "typed.toml:1:11: error: ']' is missing: the array is not closed\n"
              "    x = [40, 0" +
                  end.substr(0, end.find('\n')) + "\n" + "              ^\n");
  }
}

TEST(BracketsOfAJoint, AreTwo) {
  std::string text = changed("roller", "[[joint]]", "@");
  text.replace(text.find("[[joint]]"), 9, "[joint]");
  text.replace(text.find('@'), 1, "[[joint]]");
  const std::string later = said_of(text);
  EXPECT_TRUE(contains(later, "; every joint begins with [[joint]], in two brackets\n")) << later;
  const std::string first = said_of(changed("roller", "[[joint]]", "[joint]"));
  EXPECT_TRUE(contains(first, "; every joint begins with [[joint]], in two brackets\n")) << first;
}

TEST(UnitsByOtherNames, AreToldTheirOwn) {
  const std::string inch = said_of(changed("roller", "\"mm\"", "\"inch\""));
  EXPECT_EQ(inch,
            "typed.toml:7:10: error: unknown length 'inch'; here it is called 'in'\n"
            "    length = \"inch\"\n"
            "             ^\n");
  const std::string degrees = said_of(changed("roller", "\"deg\"", "\"degrees\""));
  EXPECT_EQ(degrees,
            "typed.toml:8:9: error: unknown angle 'degrees'; here it is called 'deg'\n"
            "    angle = \"degrees\"\n"
            "            ^\n");
}

TEST(UnitOnAnOption, IsPointedOut) {
  const Outcome unit = tried("motion", "roller", {"--to", "10s"});
  EXPECT_EQ(unit.exit_code, 1);
  EXPECT_EQ(unit.err, "moivre: --to takes a number, not 10s: write 10, without a unit\n");
  const Outcome comma = tried("motion", "roller", {"--to=0,5"});
  EXPECT_EQ(comma.err, "moivre: --to takes a number, not 0,5: decimals have a point\n");
}

TEST(NewtonsVerdict, IsSaidOnce) {
  const Outcome outcome = tried("newton", "roller");
  EXPECT_TRUE(contains(outcome.out, "\nconverged after ")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, ", misfit ")) << outcome.out;
}

}  // namespace
}  // namespace moivre::test
