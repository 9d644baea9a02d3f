// SPDX-License-Identifier: MIT
// Do the joints of one pin begin at one body, whichever way they were typed?
#include "shared_pins.h"

#include <gtest/gtest.h>

#include "../mechanism/files.h"

namespace moivre {
namespace {

/// Four links on one pin, typed as the chain a-b, b-c, c-d, and a rod between two of them.
Mechanism chain_of_pins() {
  std::string text = "[ground.points]\nO = [0, 0]\n";
  for (const char* name : {"a", "b", "c", "d"}) {
    text += std::string("[body.") + name + ".points]\nO = [0, 0]\nP = [1, 0]\n";
  }
  for (const char* at :
       {"\"ground.O\", \"a.O\"", "\"a.P\", \"b.P\"", "\"c.P\", \"b.P\"", "\"c.P\", \"d.P\""}) {
    text += std::string("[[joint]]\ntype = \"revolute\"\nat = [") + at + "]\n";
  }
  text += "[[joint]]\ntype = \"rod\"\nlength = 1\nat = [\"b.O\", \"c.O\"]\n";
  return test::typed(text);
}

std::size_t body_of(const Mechanism& mechanism, const std::string& name) {
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    if (mechanism.bodies[i].name == name) return i;
  }
  return mechanism.bodies.size();
}

TEST(SharedPins, MakeAStarAboutTheBodyThatIsKnownFirst) {
  const Mechanism mechanism = chain_of_pins();
  const std::size_t c = body_of(mechanism, "c");
  const JointEnds ends =
      star_ends(mechanism, [&](PointOf point) { return point.body == c ? 0U : 1U; });
  EXPECT_TRUE(has_shared_pins(mechanism));
  ASSERT_EQ(ends.size(), 5U);
  EXPECT_EQ(ends[0][1].body, body_of(mechanism, "a"));
  for (const auto& [joint, farther] : {std::pair{1, "a"}, std::pair{2, "b"}, std::pair{3, "d"}}) {
    const auto& [from, to] = ends[static_cast<std::size_t>(joint)];
    EXPECT_EQ(from.body, c) << joint;
    EXPECT_EQ(to.body, body_of(mechanism, farther)) << joint;
  }
}

TEST(SharedPins, AreLeftAsTypedWhereTheirJointsSayOneThingTwice) {
  Mechanism mechanism = chain_of_pins();
  Joint again = mechanism.joints[3];
  again.at[0] = mechanism.joints[1].at[0];
  mechanism.joints.push_back(again);
  EXPECT_FALSE(has_shared_pins(mechanism));
}

TEST(SharedPins, AreNotThoseOfTwoBodies) {
  EXPECT_FALSE(has_shared_pins(test::example("four-bar")));
}

}  // namespace
}  // namespace moivre
