// SPDX-License-Identifier: MIT
// Is what is told of a four-bar within rounding of a dead point true of the numbers as typed?
//
// Truth: |AD| against coupler + rocker and |coupler - rocker| in 60 digits (mpmath), decimals as
// typed, cosine and sine of the typed angle. The rocker is what would make a dead point, rounded to
// double, up to three units in the last place from that.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "mechanisms.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

struct FourBar {
  double x, y;  ///< of the rocker's pivot
  double crank, coupler;
  const char* rocker;
  const char* angle;
  const char* unit;
  bool can_be_assembled;
};
void PrintTo(const FourBar& bar, std::ostream* out) { *out << bar.rocker << " at " << bar.angle; }

std::string text_of(const FourBar& bar) {
  std::ostringstream text;
  text << "[units]\nangle = \"" << bar.unit << "\"\n[ground.points]\nO2 = [0, 0]\nO4 = [" << bar.x
       << ", " << bar.y << "]\n[body.crank.points]\nO2 = [0, 0]\nA = [" << bar.crank
       << ", 0]\n[body.coupler.points]\nA = [0, 0]\nB = [" << bar.coupler
       << ", 0]\n[body.rocker.points]\nO4 = [0, 0]\nB = [" << bar.rocker << ", 0]\n";
  for (const char* at : {"ground.O2\", \"crank.O2", "crank.A\", \"coupler.A",
                         "coupler.B\", \"rocker.B", "ground.O4\", \"rocker.O4"}) {
    text << "[[joint]]\ntype = \"revolute\"\nat = [\"" << at << "\"]\n";
  }
  text << "[[driver]]\nangle = \"crank\"\nstart = " << bar.angle << "\nvelocity = 1\n";
  return text.str();
}

ClosureResult closures_of(const std::string& text) {
  return find_closures(mechanism_text(text), *make_lane_tracker());
}

class NearADeadPoint : public testing::TestWithParam<FourBar> {};

TEST_P(NearADeadPoint, AFourBarIsSaidToBeAssembledWhereItCan) {
  const ClosureResult result = closures_of(text_of(GetParam()));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.real, GetParam().can_be_assembled ? 2U : 0U);
  EXPECT_EQ(result.counts.complex, 2U);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
}

constexpr FourBar kFourBars[] = {
    {7, 0, 3, 4.5, "11.871530289200361", "85", "deg", false},
    {6.5, 0, 3, 2, "4.229814358179164", "288.6", "deg", false},
    {5, 0, 1.5, 2, "4.099909277176474", "131.6", "deg", false},
    {4, -1, 1.5, 2, "0.6316446422582771", "341.082", "deg", false},
    {3.25, 0, 3, 4.5, "1.5512286471160204", "3.647761", "rad", false},
    {3.25, 0, 0.75, 3.5, "0.2913821212918494", "279.8", "deg", false},
    {90, 0, 1.25, 1.75, "87.0490913152487", "344", "deg", false},
    {3.25, 1.5, 2, 1.75, "3.345109735983447", "20", "deg", false},
    {5, 0, 2, 4.5, "9.17254117254134", "69", "deg", false},
    {7, 0, 3, 2, "6.153020526846472", "14", "deg", true},
    {4, 0, 0.75, 4.5, "0.09986593921104059", "220", "deg", true},
    {5, 0, 2, 2, "1.8227220659141534", "44", "deg", false},
    {3.25, 2, 1.25, 1.75, "4.63925341805845", "67", "deg", true},
    {5, 0, 0.75, 1.75, "2.8963001967426685", "58", "deg", false},
    {6.5, -1, 0.75, 2, "5.237319369587993", "2.470068", "rad", true},
    {6.5, 0, 0.75, 2, "7.843759080506397", "0.476707", "rad", true},
    {7, 2, 1.25, 2, "8.621980005142772", "322", "deg", false},
    {6.5, -1, 0.75, 4.5, "2.2413939549887605", "251.72", "deg", false},
    {6.5, 1.5, 3, 2, "7.203007779543306", "154.2", "deg", true},
    {7, 2, 2, 4.5, "0.8509037776927201", "29", "deg", true},
    {3.25, 1.5, 3, 4.5, "11.072245915623661", "3.48", "rad", false},
    {5, 0, 2, 3.5, "9.567505465163217", "247", "deg", false},
    {6.5, 0, 1.5, 4.5, "0.5337281276365635", "349.31", "deg", false},
    {6.5, 2, 1.25, 3.5, "9.12628997443561", "0.615", "rad", false},
    {4, 1.5, 2, 3.5, "7.256461219070241", "319", "deg", true},
    {5, 0, 3, 3.5, "2.678607693388694", "262", "deg", false},
    {4, 2, 1.25, 3.5, "1.0467182298142454", "112", "deg", true},
    {5, 1.5, 2, 1.75, "4.970585144068947", "15.764", "deg", true},
    {3.25, 0, 1.25, 3.5, "5.50044543708817", "1.2", "deg", true},
    {90, -1, 1.25, 4.5, "84.7902000022495", "304.6", "deg", true},
    {6.5, 2, 1.25, 3.5, "10.67249144082706", "119.438", "deg", true},
    {6.5, 0, 1.5, 1.75, "9.473622611728967", "141", "deg", false},
    {6.5, 0, 0.75, 3.5, "10.54169149508662", "134", "deg", false},
    {7, 0, 0.75, 2, "8.29559806183711", "19", "deg", false},
    {6.5, 0, 2, 2, "10.134319610212856", "220", "deg", false},
    {5, 1.5, 3, 2, "5.40221116241967", "143", "deg", true},
    {6.5, -1, 3, 3.5, "8.252369573540244", "310", "deg", true},
    {5, 2, 1.5, 3.5, "7.85809109704852", "1.09", "rad", false},
    {3.25, 1.5, 1.25, 2, "0.5194194702860478", "51", "deg", false},
    {90, 1.5, 1.25, 2, "87.8632011805809", "83.7", "deg", false},
};
INSTANTIATE_TEST_SUITE_P(Random, NearADeadPoint, testing::ValuesIn(kFourBars));

// |AD| exceeds coupler + rocker by 4.9e-16, and by 5e-18.
TEST(NearADeadPoint, WhatMissesByLessThanRoundingCannotBeAssembled) {
  for (const FourBar& bar : {FourBar{7, 2, 1.25, 3.5, "2.530365515209935", "17", "deg", false},
                             FourBar{4, 0, 3, 2, "0.5719512758107466", "40", "deg", false}}) {
    const ClosureResult result = closures_of(text_of(bar));
    EXPECT_EQ(result.counts.real, 0U);
    EXPECT_EQ(result.message.substr(0, 19), "cannot be assembled");
  }
}

TEST(NearADeadPoint, WhatMissesByLessThanRoundingIsWithinAFit) {
  for (const FourBar& bar : {FourBar{7, 2, 1.25, 3.5, "2.530365515209935", "17", "deg", false},
                             FourBar{4, 0, 3, 2, "0.5719512758107466", "40", "deg", false}}) {
    const ClosureResult result = closures_of("fit = 1e-9\n" + text_of(bar));
    EXPECT_EQ(result.counts.complex, 2U);
    EXPECT_EQ(result.counts.real, 0U);
    ASSERT_EQ(result.closures.size(), 1U) << result.message;
    EXPECT_TRUE(result.closures[0].is_fitted);
  }
}

// A crank of 3 at 60 degrees and a frame of 8: |AD| = 7, exactly coupler + rocker.
TEST(NearADeadPoint, ADeadPointItselfIsNotProvedToBeTwoClosures) {
  const ClosureResult result = closures_of(text_of({8, 0, 3, 3, "4", "60", "deg", true}));
  EXPECT_NE(result.completeness, RootCompleteness::proved);
  for (const Closure& closure : result.closures) EXPECT_NE(closure.certified, true);
}

/// A crank of 4, a rod and a slide that ends at (12, 0, 0): 0.36 + 0.64 is 1, so that crank and rod
/// are in line where the rod is 8.
std::string slide_in_space(const std::string& rod) {
  return "space = \"spatial\"\n[ground.points]\nO = [0, 0, 0]\nG = [12, -1.2, -1.6]\n"
         "[body.crank.points]\nO = [0, 0, 0]\nA = [4, 0, 0]\n[body.slider.points]\nB = [12, 0, 0]\n"
         "[[joint]]\ntype = \"revolute\"\nat = [\"ground.O\", \"crank.O\"]\naxis = [0, 0, 1]\n"
         "[[joint]]\ntype = \"prismatic\"\nname = \"guide\"\nat = [\"ground.G\", \"slider.B\"]\n"
         "axis = [0, 0.6, 0.8]\n"
         "[[joint]]\ntype = \"rod\"\nat = [\"crank.A\", \"slider.B\"]\nlength = " +
         rod + "\n[[driver]]\nslide = \"guide\"\nstart = 2\n";
}

TEST(NearADeadPoint, InSpaceNothingIsProvedOfClosuresThatTheAxesRoundingMayMerge) {
  const ClosureResult result = closures_of(slide_in_space("8"));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.completeness, RootCompleteness::shown);
  ASSERT_EQ(result.closures.size(), 1U);
  EXPECT_TRUE(result.closures[0].is_drawn);
  EXPECT_NE(result.closures[0].certified, true);
  EXPECT_EQ(result.closures[0].multiplicity, 2U);
}

TEST(NearADeadPoint, InSpaceWhatRoundingCannotMergeIsProved) {
  const ClosureResult apart = closures_of(slide_in_space("8.0000001"));
  EXPECT_EQ(apart.completeness, RootCompleteness::proved);
  EXPECT_EQ(apart.counts.real, 2U);
  const ClosureResult beyond = closures_of(slide_in_space("7.9999999"));
  EXPECT_EQ(beyond.completeness, RootCompleteness::proved);
  EXPECT_EQ(beyond.counts.real, 0U);
}

// A strut on a wheel carrier: one of six equations is spare, and nothing is proved. Its tie rod of
// 3 is in the plane of the steering axis, where two closures meet. They were told as two closures.
TEST(NearADeadPoint, OfRedundantEquationsTwoClosuresThatRoundingMayMergeAreACluster) {
  for (const char* rod : {"3", "3.0000000000000004", "2.9999999999999996"}) {
    const ClosureResult result = closures_of(std::string(R"toml(
space = "spatial"
[ground.points]
G = [-2, 0, 0]
T = [0, 0, 5]
W = [0, 5, 1]
[body.arm.points]
G = [-2, 0, 0]
B = [0, 0, 0]
[body.carrier.points]
B = [0, 0, 0]
S = [0, 0, 1]
A = [0, 2, 1]
[body.strut.points]
S = [0, 1.2, 2.6]
T = [0, 0, 5]
[[joint]]
type = "revolute"
at = ["ground.G", "arm.G"]
axis = [0, 1, 0]
name = "arm"
[[joint]]
type = "spherical"
at = ["arm.B", "carrier.B"]
[[joint]]
type = "spherical"
at = ["ground.T", "strut.T"]
[[joint]]
type = "prismatic"
at = ["carrier.S", "strut.S"]
axis = [0, 0.6, 0.8]
[[driver]]
angle = "arm"
start = 0
[[joint]]
type = "rod"
at = ["ground.W", "carrier.A"]
length = )toml") + rod);
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_EQ(result.closures.size(), 1U);
    EXPECT_TRUE(result.closures[0].is_drawn);
    EXPECT_EQ(result.closures[0].multiplicity, 2U);
  }
}

// A flat loop of which one equation is spare: two complex roots 5e-8 apart, of a condition of 5e6.
// It was said that it cannot be assembled.
TEST(NearADeadPoint, OfRedundantEquationsRootsWhoseMidpointIsARootButForRoundingAreACluster) {
  const std::string text = R"toml(
space = "spatial"
[ground.points]
P0 = [-40.0, 0.0, 0.0]
P7 = [20.0, 0.0, 0.0]
[body.b1.points]
P1 = [-40.0, 0.0, 0.0]
P2 = [-60.0, 0.0, 0.0]
[body.b2.points]
P3 = [-60.0, 0.0, 0.0]
P4 = [0.0, 0.0, 0.0]
[body.b3.points]
P5 = [6.0, 0.0, 8.0]
P6 = [20.0, 0.0, 0.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [0.0, 0.0, 1.0]
[[joint]]
type = "spherical"
name = "j1"
at = ["b1.P2", "b2.P3"]
[[joint]]
type = "cylindrical"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [0.6, 0.0, 0.8]
[[joint]]
type = "revolute"
name = "j3"
at = ["b3.P6", "ground.P7"]
axis = [0.6, 0.0, 0.8]
[[driver]]
angle = "j0"
start = 0.0
)toml";
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result = closures_of(mechanism_text(text), seed);
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_EQ(result.closures.size(), 1U) << result.message;
    EXPECT_TRUE(result.closures[0].is_drawn);
    EXPECT_EQ(result.closures[0].multiplicity, 2U);
  }
}

// A flat loop whose numbers are fractions: its double root is one, exactly. With an axis that is
// rounded its two real roots are farther apart than rounding of their numbers, and Newton's method
// comes from both to the flat pose.
TEST(NearADeadPoint, TwoRootsThatComeToOneSingularPoseAreOneClosure) {
  const std::string fractions = R"toml(
space = "spatial"
[ground.points]
P0 = [2.0, 0.0, 0.0]
P9 = [6.0, 0.0, 0.0]
[body.b1.points]
P1 = [2.0, 0.0, 0.0]
P2 = [-2.0, 0.0, 0.0]
[body.b2.points]
P3 = [-2.0, 0.0, 0.0]
P4 = [2.0, 0.0, 0.0]
[body.b3.points]
P5 = [2.0, 0.6, 0.8]
P6 = [0.0, 0.0, 0.0]
[body.b4.points]
P7 = [0.0, 0.0, 0.0]
P8 = [6.0, 0.0, 0.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [1.0, 0.0, 0.0]
[[joint]]
type = "revolute"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [0.6, 0.0, 0.8]
[[joint]]
type = "prismatic"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [0.0, 0.6, 0.8]
turn = 0.0
[[joint]]
type = "spherical"
name = "j3"
at = ["b3.P6", "b4.P7"]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "ground.P9"]
axis = [0.6, 0.0, 0.8]
[[driver]]
angle = "j0"
start = 0.0
)toml";
  for (const bool is_rounded : {false, true}) {
    const ClosureResult result = closures_of(mechanism_text(
        is_rounded ? replaced(fractions, "0.6, 0.8]", "0.5, 0.8660254037844386]") : fractions));
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_EQ(result.closures.size(), 1U);
    EXPECT_EQ(result.counts.real, 1U);
    EXPECT_EQ(result.counts.complex, 1U);
    EXPECT_EQ(result.closures[0].multiplicity, 2U);
    EXPECT_EQ(result.closures[0].cluster, is_rounded);
    EXPECT_TRUE(result.closures[0].singular);
    EXPECT_EQ(result.solutions[0].multiplicity, 2U);
  }
}

// A dyad that is stretched but for the fourth decimal, between the ground and a wheel that a crank
// turns: as the wheel's angle is known exactly, its closures are proved.
TEST(NearADeadPoint, AboveAGearIsProvedAsTyped) {
  const ClosureResult result = closures_of(mechanism_text(R"toml(
[ground.points]
P0 = [1.0934, -9.5326]
P2 = [-5.7199, -8.4474]
P13 = [6.0066, 0.1753]
[body.b1.points]
P1 = [1.0934, -9.5326]
P7 = [-4.2897, -3.3119]
[body.b2.points]
P3 = [-5.7199, -8.4474]
P4 = [-9.43, -7.7405]
P8 = [-7.8424, -4.4442]
[body.b3.points]
P5 = [-9.43, -7.7405]
P6 = [-4.8148, -3.3954]
[body.b4.points]
P9 = [-7.8424, -4.4442]
P10 = [-14.7669, -6.754]
[body.b5.points]
P11 = [-14.7669, -6.754]
P12 = [6.0066, 0.1753]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
[[joint]]
type = "revolute"
name = "j1"
at = ["ground.P2", "b2.P3"]
[[joint]]
type = "gear"
name = "j2"
bodies = ["b1", "b2"]
ratio = [1, -2]
phase = 0.0
carrier = "ground"
[[joint]]
type = "revolute"
name = "j3"
at = ["b2.P4", "b3.P5"]
[[joint]]
type = "slot"
name = "j4"
at = ["b3.P6", "b1.P7"]
along = [0.9876, 0.1571]
[[joint]]
type = "revolute"
name = "j5"
at = ["b2.P8", "b4.P9"]
[[joint]]
type = "revolute"
name = "j6"
at = ["b4.P10", "b5.P11"]
[[joint]]
type = "revolute"
name = "j7"
at = ["b5.P12", "ground.P13"]
[[driver]]
angle = "b1"
start = 0.0
)toml"));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
  EXPECT_EQ(result.counts.real, 4U);
}

// A piston on three equal cranks at the end of its stroke, typed with fifteen digits in frames of
// their own. Rounding left a pair of complex roots, and it was said that it cannot be assembled.
TEST(NearADeadPoint, OfRedundantEquationsARealPoseThatRoundingMakesComplexIsListed) {
  const ClosureResult result = closures_of(R"toml(
[ground.points]
O = [0, 0]
P = [3, 0]
Q = [6, 0]
[body.b1.points]
O = [0, 0]
A = [1, 0]
[body.b2.points]
P = [0, 0]
B = [1, 1e-15]
[body.b3.points]
Q = [-1e-15, -1e-15]
C = [0.999999999999999, 0]
[body.b4.points]
A = [1e-15, 0]
B = [3, -1e-15]
C = [6, -2e-15]
[body.b5.points]
C = [4, 1e-15]
S = [0, 0]
[body.b6.points]
S = [0, 0]
[[joint]]
type = "revolute"
at = ["b5.S", "b6.S"]
[[joint]]
type = "revolute"
at = ["ground.O", "b1.O"]
[[joint]]
type = "revolute"
at = ["ground.P", "b2.P"]
[[joint]]
type = "revolute"
at = ["ground.Q", "b3.Q"]
[[joint]]
type = "revolute"
at = ["b1.A", "b4.A"]
[[joint]]
type = "revolute"
at = ["b2.B", "b4.B"]
[[joint]]
type = "revolute"
at = ["b3.C", "b4.C"]
[[joint]]
type = "revolute"
at = ["b3.C", "b5.C"]
[[joint]]
type = "prismatic"
at = ["ground.Q", "b6.S"]
along = [1, 0]
name = "g"
[[driver]]
slide = "g"
start = 3
)toml");
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.closures.size(), 1U) << result.message;
  EXPECT_EQ(result.closures[0].multiplicity, 2U);
}

// Five links and a spring hold a wheel carrier, typed where the spring's length turns back. The
// double root was taken for a point of a set, since frames are rounded.
TEST(NearADeadPoint, InSpaceADoubleRootWhosePoseStandsStillIsACluster) {
  const ClosureResult result = closures_of(R"toml(
space = "spatial"
[ground.points]
P0 = [1.2, 4.0, 4.6]
P2 = [-1.4, 4.1, 4.5]
P4 = [2.6, 4.6, 1.9]
P6 = [-1.9, 3.4, 1.8]
P8 = [-2.2, 3.6, 2.6]
P10 = [-0.2, 5.2, 7.4]
[body.b1.points]
P1 = [-0.020128157157004, 4.299821188578345, 7.276078200462782]
P3 = [-0.02851531789465, 3.687815887133481, 6.908139120534946]
P5 = [1.351331430607148, 5.585681093880722, 4.671147701761225]
P7 = [1.070125635609983, 4.616660721087569, 4.006374945120404]
P9 = [0.684599384640713, 3.501843702245467, 4.320305708687135]
P11 = [1.511046450394839, 4.67571790552887, 5.01240729254037]
[[joint]]
type = "rod"
name = "j0"
at = ["ground.P0", "b1.P1"]
length = 2.956349099818897
[[joint]]
type = "rod"
name = "j1"
at = ["ground.P2", "b1.P3"]
length = 2.801785145224379
[[joint]]
type = "rod"
name = "j2"
at = ["ground.P4", "b1.P5"]
length = 3.195309061734092
[[joint]]
type = "rod"
name = "j3"
at = ["ground.P6", "b1.P7"]
length = 3.894868418830089
[[joint]]
type = "rod"
name = "j4"
at = ["ground.P8", "b1.P9"]
length = 3.360059523282289
[[joint]]
type = "actuator"
name = "j5"
at = ["ground.P10", "b1.P11"]
[[driver]]
slide = "j5"
start = 2.983814774195312
)toml");
  EXPECT_TRUE(result.complete) << result.message;
  const auto drawn = std::find_if(result.closures.begin(), result.closures.end(),
                                  [](const Closure& closure) { return closure.is_drawn; });
  ASSERT_NE(drawn, result.closures.end());
  EXPECT_EQ(drawn->multiplicity, 2U);
}

// A quick return in two of its dead points. Above one angle of its arm rounding parts the two roots
// of the slider by 1e-17 of their size: their condition, 1e19, is not that of a set.
TEST(NearADeadPoint, APairOfRootsThatRoundingHardlyPartsIsNoSet) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result = closures_of(mechanism_text(R"toml(
[ground.points]
P0 = [8.0, -12.0]
P2 = [12.0, -4.0]
[body.b1.points]
P1 = [8.0, -12.0]
P4 = [0.0, -8.0]
[body.b2.points]
P3 = [12.0, -4.0]
P5 = [-4.0, 4.0]
[body.b3.points]
P6 = [-4.0, 4.0]
P7 = [12.0, -4.0]
[body.b4.points]
P8 = [12.0, -4.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
[[joint]]
type = "revolute"
name = "j1"
at = ["ground.P2", "b2.P3"]
[[joint]]
type = "slot"
name = "j2"
at = ["b2.P3", "b1.P4"]
along = [-12.0, -4.0]
[[joint]]
type = "revolute"
name = "j3"
at = ["b2.P5", "b3.P6"]
[[joint]]
type = "revolute"
name = "j4"
at = ["b3.P7", "b4.P8"]
[[joint]]
type = "prismatic"
name = "j5"
at = ["ground.P2", "b4.P8"]
along = [8.0, 16.0]
turn = 0.0
[[driver]]
angle = "b1"
start = 0.0
)toml"),
                                             seed);
    EXPECT_TRUE(result.complete) << result.message;
    const bool has_drawn = std::any_of(
        result.closures.begin(), result.closures.end(),
        [](const Closure& closure) { return closure.q.lpNorm<Eigen::Infinity>() < 1e-6; });
    EXPECT_TRUE(has_drawn) << "seed " << seed << ": " << result.message;
  }
}

// The double root of a flat loop comes twice, both alike to twelve digits: the Jacobian has a pivot
// of 0, and a condition of infinity was taken for a point of a set.
TEST(NearADeadPoint, TwoRootsAlikeWhoseConditionIsInfiniteAreACluster) {
  for (const std::uint64_t seed : {1U, 2U}) {
    const ClosureResult result = closures_of(mechanism_text(R"toml(space = "spatial"
[ground.points]
P0 = [0.0, 0.0, 0.0]
[body.b1.points]
P1 = [0.0, 0.0, 0.0]
P2 = [6.0, 0.0, 0.0]
[body.b2.points]
P3 = [6.0, 0.0, 0.0]
P4 = [-2.0, 0.0, 0.0]
[body.b3.points]
P5 = [-2.0, 1.0, 0.0]
P6 = [6.0, 0.0, 0.0]
[body.b4.points]
P7 = [6.0, 0.0, 0.0]
P8 = [0.0, 0.0, 0.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [0.6, 0.0, 0.8]
[[joint]]
type = "universal"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]
[[joint]]
type = "cylindrical"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [0.0, 1.0, 0.0]
[[joint]]
type = "revolute"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [0.6, 0.0, 0.8]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "ground.P0"]
axis = [0.0, 0.6, 0.8]
[[driver]]
angle = "j0"
start = 0.0
)toml"),
                                             seed);
    EXPECT_TRUE(result.complete) << result.message;
    const bool has_drawn = std::any_of(
        result.closures.begin(), result.closures.end(),
        [](const Closure& closure) { return closure.q.lpNorm<Eigen::Infinity>() < 1e-6; });
    EXPECT_TRUE(has_drawn) << "seed " << seed << ": " << result.message;
  }
}

}  // namespace
}  // namespace moivre
