// SPDX-License-Identifier: MIT
// Is every four-bar loop found, and is its type that of the books?
#include "moivre/closures/four_bars.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "linkages.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

using test::example;
using test::four_bar;

/// The signs of [McCarthySoh11]: T1 = g + h - a - b, T2 = b + g - a - h, T3 = b + h - a - g.
FourBarType type_by_signs(const std::array<double, 4>& lengths) {
  const auto [g, a, h, b] = lengths;
  const bool t1 = g + h - a - b > 0;
  const bool t2 = b + g - a - h > 0;
  const bool t3 = b + h - a - g > 0;
  if (t1 && t2 && t3) return FourBarType::crank_rocker;
  if (t1 && !t2 && !t3) return FourBarType::rocker_crank;
  if (!t1 && !t2 && t3) return FourBarType::double_crank;
  if (!t1 && t2 && !t3) return FourBarType::double_rocker;
  if (!t1 && !t2 && !t3) return FourBarType::triple_rocker_input;
  if (t1 && t2) return FourBarType::triple_rocker_frame;
  return t1 ? FourBarType::triple_rocker_coupler : FourBarType::triple_rocker_output;
}

TEST(FourBars, TypesAreThoseOfTheSignsOfTheSums) {
  constexpr std::uint64_t kSeed = 1;
  std::vector<int> counts(static_cast<std::size_t>(FourBarType::cannot_be_closed) + 1);
  for (std::uint64_t k = 0; k < 2000; ++k) {
    std::array<double, 4> lengths{};
    double sum = 0;
    for (std::uint64_t j = 0; j < 4; ++j) {
      lengths[j] = 0.1 + random_unit(kSeed, RandomStream::test, 4 * k + j);
      sum += lengths[j];
    }
    const double longest = *std::max_element(lengths.begin(), lengths.end());
    const FourBarType expected =
        2 * longest > sum ? FourBarType::cannot_be_closed : type_by_signs(lengths);
    EXPECT_EQ(four_bar_type(lengths), expected) << k;
    ++counts[static_cast<std::size_t>(four_bar_type(lengths))];
  }
  for (std::size_t type = 0; type < 8; ++type) EXPECT_GT(counts[type], 50) << type;
}

TEST(FourBars, ChangePointsAreToldByTheirShortestLink) {
  EXPECT_EQ(barker_letters(four_bar_type({1, 2, 4, 3})), "SCCC");
  EXPECT_EQ(barker_letters(four_bar_type({3, 1, 4, 2})), "SCRR");
  EXPECT_EQ(barker_letters(four_bar_type({3, 2, 1, 4})), "SRCR");
  EXPECT_EQ(barker_letters(four_bar_type({2, 3, 4, 1})), "SRRC");
  EXPECT_EQ(barker_letters(four_bar_type({4, 2, 4, 2})), "S2X");
  EXPECT_EQ(barker_letters(four_bar_type({4, 4, 2, 2})), "S2X");
  EXPECT_EQ(barker_letters(four_bar_type({0.1, 0.1, 0.1, 0.1})), "S3X");
  EXPECT_EQ(four_bar_rule({3.3, 1.1, 4.4, 2.2}), FourBarRule::change_point);
}

TEST(FourBars, NortonsExampleIsACrankRocker) {
  const std::vector<FourBar> found = four_bars(example("four-bar"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].links[0], "ground");
  EXPECT_EQ(found[0].links[1], "crank");
  EXPECT_EQ(found[0].type, FourBarType::crank_rocker);
}

TEST(FourBars, InputIsTheLinkNearerToTheDriver) {
  Mechanism driven_at_output = four_bar({6, 5, 7, 2});
  driven_at_output.drivers[0].bodies[1] = 3;
  const std::vector<FourBar> found = four_bars(driven_at_output);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].links, (std::array<std::string, 4>{"ground", "output", "coupler", "input"}));
  EXPECT_EQ(found[0].type, FourBarType::crank_rocker);
}

TEST(FourBars, SixBarsHaveTheLoopsOfTheirChains) {
  // Watt II: two loops with the ground; Watt I: one, and one that floats; Stephenson III: one.
  const std::vector<std::array<double, 2>> places{{0, 0}, {0, 1},   {3, 2.5}, {4, 2},
                                                  {3, 0}, {6, 0.5}, {6.5, 2}};
  const std::vector<FourBar> watt_2 = four_bars(test::watt_2(places, "crank"));
  ASSERT_EQ(watt_2.size(), 2U);
  EXPECT_EQ(watt_2[1].links, (std::array<std::string, 4>{"ground", "rocker", "link", "output"}));
  EXPECT_TRUE(watt_2[0].type && watt_2[1].type);
  const std::vector<FourBar> watt_1 = four_bars(example("watt-1"));
  ASSERT_EQ(watt_1.size(), 2U);
  EXPECT_NE(watt_1[0].type.has_value(), watt_1[1].type.has_value());
  EXPECT_EQ(four_bars(example("stephenson-3")).size(), 1U);
}

TEST(FourBars, PinsOfSeveralLinksAndRodsAreSeen) {
  // Jansen's leg: two loops over the crank, the links between its pin and P, those between P and
  // the foot.
  const std::vector<FourBar> jansen = four_bars(example("jansen-leg"));
  std::size_t on_crank = 0;
  for (const FourBar& loop : jansen) on_crank += loop.links[1] == "crank" ? 1 : 0;
  EXPECT_EQ(jansen.size(), 4U);
  EXPECT_EQ(on_crank, 2U);
  EXPECT_EQ(four_bars(example("slider-crank")).size(), 0U);
  EXPECT_EQ(four_bars(example("rssr")).size(), 0U);
}

}  // namespace
}  // namespace moivre
