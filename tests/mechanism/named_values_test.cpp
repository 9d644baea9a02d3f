// SPDX-License-Identifier: MIT
// Are values by the names of coordinates put into q, in the file's units, and is what cannot be one
// refused with all others?
#include "moivre/mechanism/named_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "files.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

Mechanism four_bar() { return test::example("four-bar"); }

TEST(NamedValues, AreInTheUnitsOfTheFileOrInRadians) {
  const Mechanism mechanism = four_bar();
  const Eigen::VectorXd base = Eigen::VectorXd::Zero(9);
  const std::vector<NamedValue> given{{"crank.phi", 90, "crank.phi=90"}, {"crank.x", 3, ""}};
  const Eigen::VectorXd q = with_values(mechanism, given, base, AngleUnit::of_the_file);
  EXPECT_DOUBLE_EQ(q[2], std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(q[0], 3);
  EXPECT_DOUBLE_EQ(with_values(mechanism, given, base, AngleUnit::radians)[2], 90);
}

TEST(NamedValues, AreRefusedAllAtOnce) {
  const Mechanism mechanism = four_bar();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::string> broken = broken_rules(mechanism,
                                                       {{"crank.ph", 1, "crank.ph=1"},
                                                        {"crank.x", nan, "crank.x=nan"},
                                                        {"crank.y", 1e51, "crank.y=1e51"},
                                                        {"crank.phi", 4e8, "crank.phi=4e8"},
                                                        {"crank.phi", 4, "crank.phi=4"}},
                                                       AngleUnit::of_the_file);
  ASSERT_EQ(broken.size(), 5U);
  EXPECT_EQ(broken[0], "there is no coordinate crank.ph, did you mean crank.phi?");
  EXPECT_EQ(broken[1], "crank.x=nan is not finite");
  EXPECT_EQ(broken[2], "crank.y=1e51 is beyond 1e50");
  EXPECT_EQ(broken[3], "crank.phi=4e8 is more than a million turns");
  EXPECT_EQ(broken[4], "crank.phi is given twice");
  EXPECT_THROW(
      with_values(mechanism, {{"a", 1, "a=1"}}, Eigen::VectorXd::Zero(9), AngleUnit::radians),
      InvalidInput);
}

}  // namespace
}  // namespace moivre
