// SPDX-License-Identifier: MIT
// Values of parameters as people type them, and every fault in them named.
#include <gtest/gtest.h>

#include "families.h"
#include "moivre/family/coefficients.h"
#include "moivre/family/members.h"

namespace moivre {
namespace {

std::string refusal(const std::string& text) {
  try {
    values_at(conics(), text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Values, AreExactAndInAnyOrder) {
  const ParameterValues values = values_at(conics(), "c = 1e-3, a=2/3 ,b=-(1 - 2*i)^2");
  EXPECT_EQ(values[0], (Coefficient{Rational(2, 3), 0}));
  EXPECT_EQ(values[1], (Coefficient{3, 4}));
  EXPECT_EQ(values[2], (Coefficient{Rational(1, 1000), 0}));
}

TEST(Values, NameEveryFault) {
  EXPECT_EQ(refusal("a=x, d=2, b"),
            "a=x: this is not a number; the family has no parameter d; its parameters are a, b, c; "
            "b: write name=value; no value for b, c");
  EXPECT_EQ(refusal("a=1,a=2,b=0,c=0"), "a is given twice");
  for (const std::string bad : {"a=", "a=1/0", "a=2^0.5", "a=sin(1)", "a=1)"}) {
    EXPECT_EQ(refusal(bad), bad + ": this is not a number; no value for b, c");
  }
}

TEST(Table, HasARowForEachMember) {
  const std::vector<Point> members =
      read_members({"t.csv", "# poses\nb, a,c\n1,2,3\r\n\n-1e-3,i,1/4\n"}, conics());
  ASSERT_EQ(members.size(), 2U);
  EXPECT_EQ(members[0], (Point{2, 1, 3}));
  EXPECT_EQ(members[1], (Point{Complex(0, 1), -1e-3, 0.25}));
}

TEST(Table, NamesLineAndColumnOfEveryFault) {
  try {
    read_members({"t.csv", "a,b,d\n1,zwei,3\n1,2\n"}, conics());
    FAIL();
  } catch (const ParseError& error) {
    ASSERT_EQ(error.diagnostics().size(), 4U) << error.what();
    EXPECT_EQ(error.diagnostics()[0].at.column, 5U);
    EXPECT_EQ(error.diagnostics()[1].message, "the table has no value for c");
    EXPECT_EQ(error.diagnostics()[2].at.line, 2U);
    EXPECT_EQ(error.diagnostics()[2].at.column, 3U);
    EXPECT_EQ(error.diagnostics()[3].at.line, 3U);
  }
  EXPECT_THROW(read_members({"t.csv", "# nothing\n"}, conics()), ParseError);
  for (const std::string number : {"1e308*10", "1e-200*1e-200", "-1e300^2*i"}) {
    EXPECT_THROW(read_members({"t.csv", "a,b,c\n1,1," + number + "\n"}, conics()), ParseError)
        << number << " is no double";
  }
}

TEST(Coefficients, MakeEverySystemOfTheMonomialsAMember) {
  const System f = read_system({"test", "2\nx*y - 3*x + i; y^2 + x*y - 2;\n"});
  const Family family = coefficient_family(f);
  EXPECT_EQ(family.parameters(), 6U);
  EXPECT_EQ(member_system(family, *coefficients_in(family, f)), f);
  const System part = read_system({"test", "2\nx*y + i; y^2 - 2;\n"});
  EXPECT_EQ(member_system(family, *coefficients_in(family, part)), part);
  EXPECT_FALSE(coefficients_in(family, read_system({"test", "2\nx*y - x^2; y^2 - 2;\n"})));
}

}  // namespace
}  // namespace moivre
