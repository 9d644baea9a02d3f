// SPDX-License-Identifier: MIT
// What is proved of a platform that is symmetric but for the digits with which it was typed?
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "mechanisms.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

/// Six legs between two circles, whose points are typed with so many digits.
Mechanism platform_of_circles(int digits) {
  const auto points = [&](double radius, const std::string& name,
                          const std::vector<double>& at_deg) {
    std::string text;
    for (std::size_t k = 0; k < at_deg.size(); ++k) {
      char point[128];
      const double angle = at_deg[k] * std::numbers::pi / 180;
      std::snprintf(point, sizeof point, "%s%zu = [%.*f, %.*f, 0]\n", name.c_str(), k, digits,
                    radius * std::cos(angle), digits, radius * std::sin(angle));
      text += point;
    }
    return text;
  };
  std::string text = "space = \"spatial\"\n[ground.points]\n" +
                     points(1, "B", {0, 50, 120, 170, 240, 290}) + "[body.plat.points]\n" +
                     points(0.6, "P", {25, 35, 145, 155, 265, 275});
  for (int k = 0; k < 6; ++k) {
    const std::string n = std::to_string(k);
    text += "[[joint]]\ntype = \"rod\"\nat = [\"ground.B" + n + "\", \"plat.P" + n +
            "\"]\nlength = 1." + std::to_string(20 + 2 * k) + "\n";
  }
  return mechanism_text(text);
}

ClosureResult closures_in_lanes(const Mechanism& mechanism) {
  return find_closures(mechanism, *make_lane_tracker());
}

// With more digits than rounding leaves it is taken for the symmetric one: closures of the numbers
// as typed are not proved to be all.
TEST(Platforms, ThatAreSymmetricButForRoundingHaveNoProofThatClosuresAreAll) {
  const ClosureResult rough = closures_in_lanes(platform_of_circles(6));
  EXPECT_EQ(rough.counts.complex, 40U);
  EXPECT_EQ(rough.completeness, RootCompleteness::proved);
  const ClosureResult fine = closures_in_lanes(platform_of_circles(15));
  EXPECT_EQ(fine.counts.complex, 28U);
  EXPECT_EQ(fine.counts.real, rough.counts.real);
  EXPECT_NE(fine.completeness, RootCompleteness::proved);
}

}  // namespace
}  // namespace moivre
