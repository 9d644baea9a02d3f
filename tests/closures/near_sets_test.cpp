// SPDX-License-Identifier: MIT
// Is a four-bar whose two moving pivots nearly coincide told from one that moves, as it is typed?
//
// Coupler and rocker are equal: two circles of one radius about points that differ meet twice, on
// the line through their middle, across from one to the other. Where the points are one they meet
// everywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "mechanisms.h"
#include "moivre/mechanism/phi.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

struct NearBar {
  const char* crank;
  const char* coupler;
  const char* ground;
  const char* degrees;
  double rocker_degrees;  ///< of one closure; of the other it is half a turn more
};
void PrintTo(const NearBar& bar, std::ostream* out) {
  *out << bar.crank << ' ' << bar.coupler << ' ' << bar.ground << " at " << bar.degrees;
}

Mechanism near_bar(const NearBar& bar) {
  std::ostringstream text;
  text << "[units]\nangle = \"deg\"\n[ground.points]\nA = [0, 0]\nD = [" << bar.ground
       << ", 0]\n[body.crank.points]\nA = [0, 0]\nB = [" << bar.crank
       << ", 0]\n[body.coupler.points]\nB = [0, 0]\nC = [" << bar.coupler
       << ", 0]\n[body.rocker.points]\nD = [0, 0]\nC = [" << bar.coupler << ", 0]\n";
  for (const char* at : {"ground.A\", \"crank.A", "crank.B\", \"coupler.B",
                         "coupler.C\", \"rocker.C", "rocker.D\", \"ground.D"}) {
    text << "[[joint]]\ntype = \"revolute\"\nat = [\"" << at << "\"]\n";
  }
  text << "[[driver]]\nangle = \"crank\"\nstart = " << bar.degrees << "\nvelocity = 1\n";
  return mechanism_text(text.str());
}

std::vector<ClosureResult> by_both_trackers(const Mechanism& mechanism) {
  return {find_closures(mechanism, *make_cvode_tracker()),
          find_closures(mechanism, *make_lane_tracker())};
}

double degrees_of_last_turn(const Closure& closure) {
  return closure.q[closure.q.size() - 1] * 180 / std::numbers::pi;
}

/// In degrees, whole turns apart or not.
double turn_between(double a, double b) { return std::abs(std::remainder(a - b, 360)); }

class NearlyOnePivot : public testing::TestWithParam<NearBar> {};

TEST_P(NearlyOnePivot, HasBothClosuresProvedAndDoesNotMove) {
  for (const ClosureResult& result : by_both_trackers(near_bar(GetParam()))) {
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_FALSE(result.moves);
    EXPECT_EQ(result.completeness, RootCompleteness::proved);
    ASSERT_EQ(result.closures.size(), 2U) << result.message;
    for (const double expected : {GetParam().rocker_degrees, GetParam().rocker_degrees + 180}) {
      EXPECT_LE(std::min(turn_between(degrees_of_last_turn(result.closures[0]), expected),
                         turn_between(degrees_of_last_turn(result.closures[1]), expected)),
                1e-3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    AsTyped, NearlyOnePivot,
    testing::Values(NearBar{"1", "1", "1", "1e-7", 0}, NearBar{"1", "1", "1", "1e-9", 0},
                    NearBar{"1", "1", "1", "1e-11", 0}, NearBar{"1", "1", "1", "1e-13", 0},
                    NearBar{"1", "1.3", "1", "-1e-12", 0}, NearBar{"70", "35", "70", "1e-9", 0},
                    NearBar{"1", "1", "1.0000000001", "0", 90},
                    NearBar{"1", "1", "1.000000000001", "0", 90},
                    NearBar{"1", "1", "1.00000000000001", "0", 90},
                    NearBar{"1", "1", "1.000000000000001", "0", 90},
                    NearBar{"7.000000000001", "3", "7", "0", 90},
                    NearBar{"1e-12", "2", "1e-12", "61", 30.5},
                    NearBar{"1e-16", "2", "1e-16", "61", 30.5}));

// Nearer than the digits in which a driver's direction is known, or roots are followed.
TEST(NearlyOnePivot, IsNotSaidToMoveWhereDigitsEnd) {
  for (const NearBar& bar :
       {NearBar{"1", "1", "1", "1e-20", 0}, NearBar{"1", "1", "1", "1e-40", 0},
        NearBar{"1", "1", "1", "1e-300", 0}, NearBar{"1e-60", "2", "1e-60", "61", 30.5}}) {
    for (const ClosureResult& result : by_both_trackers(near_bar(bar))) {
      EXPECT_FALSE(result.complete) << result.message;
      EXPECT_EQ(result.message.substr(0, 9), "undecided") << result.message;
    }
  }
}

TEST(OnePivot, LetsCouplerAndRockerTurnTogether) {
  for (const NearBar& bar : {NearBar{"1", "1", "1", "0", 0}, NearBar{"-1", "3", "1", "180", 0},
                             NearBar{"0.3", "0.1", "0.3", "360", 0}}) {
    for (const ClosureResult& result : by_both_trackers(near_bar(bar))) {
      EXPECT_TRUE(result.complete) << result.message;
      ASSERT_TRUE(result.moves) << result.message;
      EXPECT_EQ(result.moves->dimension, 1U);
    }
  }
}

/// Two links of length 5 on a base of 6 meet 4 above its middle; from there, and from a pin of the
/// ground next to it, two links of equal length meet.
Mechanism pair_above_triangle(const std::string& x) {
  std::string text = "[ground.points]\nP = [0, 0]\nQ = [6, 0]\nR = [" + x + R"toml(, 4]
[body.a.points]
P = [0, 0]
E = [5, 0]
[body.b.points]
Q = [0, 0]
E = [5, 0]
[body.c.points]
E = [0, 0]
F = [1, 0]
[body.d.points]
R = [0, 0]
F = [1, 0]
)toml";
  for (const char* at : {"ground.P\", \"a.P", "ground.Q\", \"b.Q", "a.E\", \"b.E", "a.E\", \"c.E",
                         "c.F\", \"d.F", "d.R\", \"ground.R"}) {
    text += "[[joint]]\ntype = \"revolute\"\nat = [\"" + std::string(at) + "\"]\n";
  }
  return mechanism_text(text);
}

// A block above others knows their roots to more digits than double's where that matters.
TEST(NearlyOnePivot, AboveATriangleToo) {
  for (const char* x : {"3.0000000001", "3.000000000001", "3.0000000000001", "3.000000000000001"}) {
    for (const ClosureResult& result : by_both_trackers(pair_above_triangle(x))) {
      EXPECT_TRUE(result.complete) << x << ": " << result.message;
      EXPECT_FALSE(result.moves) << x;
      EXPECT_EQ(result.counts.complex, 4U) << x;
      EXPECT_EQ(result.counts.real, 2U) << x;
    }
  }
  for (const ClosureResult& result : by_both_trackers(pair_above_triangle("3"))) {
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(result.moves) << result.message;
  }
}

}  // namespace
}  // namespace moivre
