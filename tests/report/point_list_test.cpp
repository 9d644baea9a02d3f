// SPDX-License-Identifier: MIT
// Are point lists of all three forms read, and are faults named with their line?
#include "moivre/report/point_list.h"

#include <gtest/gtest.h>

namespace moivre::test {
namespace {

const std::vector<std::string> kNames = {"x", "y"};

std::vector<Point> points_of(const std::string& text) {
  return read_points({"points", text}, kNames);
}

std::string fault_of(const std::string& text) {
  try {
    points_of(text);
  } catch (const ParseError& error) {
    return error.what();
  }
  return "no fault";
}

// As phc -b of PHCpack 2.4.86 leaves it, with other text before and behind, y before x.
constexpr const char* kPhcList = R"(THE SOLUTIONS :
2 2
===========================================================================
solution 1 :    start residual :  6.476E-17   #iterations : 1   success
t :  1.00000000000000E+00   0.00000000000000E+00
m : 1
the solution for t :
 y :  2.00000000000000E+00   0.00000000000000E+00
 x :  1.00000000000000E+00  -5.00000000000000E-01
== err :  6.476E-17 = rco :  3.102E-01 = res :  5.551E-17 = complex regular ==
solution 2 :
t :  1.00000000000000E+00   0.00000000000000E+00
m : 1
the solution for t :
 x : -2.00000000000000E+00   0.00000000000000E+00
 y : -1.00000000000000E+00   3.00000000000000E-01
== err :  3.109E-76 = rco :  3.102E-01 = res :  3.068E-92 ==
===========================================================================
A list of 2 solutions has been refined :
)";

TEST(PointList, ReadsPhcpacksSolutionsByTheirNames) {
  const std::vector<Point> expected = {{{1, -0.5}, {2, 0}}, {{-2, 0}, {-1, 0.3}}};
  EXPECT_EQ(points_of(kPhcList), expected);
}

TEST(PointList, ReadsATableByItsHead) {
  const std::vector<Point> expected = {{{1, 2}, {3, 4}}};
  EXPECT_EQ(points_of("path,y.re,y.im,x.re,x.im,\n0,3,4,1,2,\n"), expected);
}

TEST(PointList, ReadsPlainNumbersBetweenBlanksOrCommas) {
  const std::vector<Point> expected = {{{1, 2}, {3, -4}}, {{0.5, 0}, {1e-3, 0}}};
  EXPECT_EQ(points_of("# x and y\n+1 2 3 -4  # the first\n\n0.5,0, 1e-3,0\r\n"), expected);
}

TEST(PointList, NamesTheLineThatIsTooShort) {
  EXPECT_EQ(fault_of("1 2 3 4\n1 2 3\n"),
            "points:2:1: error: expected 4 numbers, re and im of each variable, found 3\n    1 2 "
            "3\n    ^\n");
}

TEST(PointList, NamesEveryWordThatIsNoNumber) {
  EXPECT_EQ(fault_of("1 2 3 four\n1 two 3 4\n1 2 nan 4\n"),
            "points:1:7: error: not a number\n    1 2 3 four\n          ^\n"
            "points:2:3: error: not a number\n    1 two 3 4\n      ^\n"
            "points:3:5: error: not a finite number\n    1 2 nan 4\n        ^\n");
}

TEST(PointList, NamesAMissingColumn) {
  EXPECT_EQ(fault_of("x.re,x.im,y.re\n1,2,3\n"),
            "points:1:1: error: there is no column y.im\n    x.re,x.im,y.re\n    ^\n");
}

TEST(PointList, NamesAVariableThatASolutionLeavesOut) {
  const std::string fault =
      fault_of("solution 1 :\nt : 1 0\nm : 1\nthe solution for t :\n x : 1 0\n==\n");
  EXPECT_EQ(fault, "points:1:1: error: the solution does not say y\n    solution 1 :\n    ^\n");
}

TEST(PointList, RefusesAnEmptyFile) {
  EXPECT_EQ(fault_of("# nothing\n"),
            "points:1:1: error: the file lists no point\n    # nothing\n    ^\n");
  EXPECT_EQ(fault_of(""), "points:1:1: error: the file lists no point\n    \n    ^\n");
}

}  // namespace
}  // namespace moivre::test
