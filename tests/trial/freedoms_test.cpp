// SPDX-License-Identifier: MIT
// Is the mobility without a guess that of the mechanism, and not of a folded pose?
#include <gtest/gtest.h>

#include "files.h"

namespace moivre::test {
namespace {

TEST(MobilityWithoutAGuess, IsThatOfTheClosures) {
  for (const std::string name : {"peaucellier", "nodriver", "chain6", "roller"}) {
    const Answer answer = answered("mobility", name);
    EXPECT_EQ(answer.exit_code, 0) << name;
    EXPECT_EQ(answer.json.at("assembled"), true) << name;
    EXPECT_EQ(answer.json.at("degrees_of_freedom"), name == "roller" ? 2 : 1) << name;
    EXPECT_EQ(answer.json.at("generic_degrees_of_freedom"), name == "roller" ? 2 : 1) << name;
  }
}

TEST(MobilityWithoutAGuess, TellsEveryKindOfClosure) {
  const Answer answer = answered("mobility", "peaucellier");
  const auto& kinds = answer.json.at("kinds");
  ASSERT_GE(kinds.size(), 1U);
  EXPECT_EQ(kinds.at(0).at("degrees_of_freedom"), 1);
  std::size_t closures = 0;
  for (const auto& kind : kinds) closures += kind.at("closures").size();
  EXPECT_EQ(closures, answered("closures", "peaucellier").json.at("closures").size());
  EXPECT_TRUE(
      has_line(tried("mobility", "peaucellier").out,
               "generic: 1 degree of freedom, 0 with the drivers held: closures A, B, C, D"));
}

}  // namespace
}  // namespace moivre::test
