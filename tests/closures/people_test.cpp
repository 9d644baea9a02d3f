// SPDX-License-Identifier: MIT
// Is the pose that a mechanism was typed in among its closures, and is what they say of it true?
#include "people.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mechanisms.h"
#include "moivre/mechanism/phi.h"

namespace moivre {
namespace {

using test::person;
constexpr std::uint64_t kFewSeeds = 5;

const Closure* drawn_of(const std::vector<Closure>& closures) {
  const auto found = std::find_if(closures.begin(), closures.end(),
                                  [](const Closure& one) { return one.is_drawn; });
  return found == closures.end() ? nullptr : &*found;
}

TEST(PeoplesClosures, OfThreeCranksWithARoundedPivotCloseWithinFit) {
  Mechanism m = person("fit-not-assembled");
  m.fit = 0.05;
  for (std::uint64_t seed = 1; seed <= kFewSeeds; ++seed) {
    for (const double time : {0.0, 0.1, 0.2}) {
      const ClosureResult result = closures_of(m, seed, time);
      EXPECT_TRUE(result.complete) << result.message;
      ASSERT_GE(result.counts.fitted, 1U) << "t = " << time << ": " << result.message;
      const bool is_near = std::any_of(
          result.closures.begin(), result.closures.end(),
          [](const Closure& closure) { return closure.is_fitted && closure.misfit < 0.01; });
      EXPECT_TRUE(is_near) << time;
      if (time == 0) {
        ASSERT_NE(drawn_of(result.closures), nullptr);
        EXPECT_NEAR(drawn_of(result.closures)->misfit, 0.0043, 1e-3);
      }
    }
  }
}

TEST(PeoplesClosures, OfFivePosesOfAFourBarAreItsFourBurmesterPoints) {
  for (std::uint64_t seed = 1; seed <= kFewSeeds; ++seed) {
    const ClosureResult result = closures_of(person("burmester-5-moves"), seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_FALSE(result.moves);
    EXPECT_EQ(result.counts.complex, 4U);
    EXPECT_EQ(result.counts.real, 4U);
  }
}

TEST(PeoplesClosures, OfACardanJointWhoseShaftPassesThroughItsCentreAreTwo) {
  for (std::uint64_t seed = 1; seed <= kFewSeeds; ++seed) {
    const ClosureResult result = closures_of(person("cardan-single"), seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.real, 2U);
  }
}

TEST(PeoplesClosures, ContainTheDrawnPoseOfTwoLegs) {
  const ClosureResult result = closures_of(person("letters-collide-jansen-double"));
  ASSERT_EQ(result.sub_chains.size(), 2U);
  const Closure* const drawn = drawn_of(result.closures);
  ASSERT_NE(drawn, nullptr);
  EXPECT_LT(drawn->q.cwiseAbs().maxCoeff(), 0.05);
  EXPECT_EQ(drawn->of, (std::vector<std::string>{"E", "H"}));
  EXPECT_EQ(drawn->id, "AT");
}

TEST(PeoplesClosures, ContainTheDrawnPoseOfFourLegsThoughTheyAreNotAllListed) {
  const ClosureResult result = closures_of(person("strandbeest-4-drawn-pose-not-listed"));
  EXPECT_EQ(result.counts.real, 3072U);
  EXPECT_FALSE(result.all_listed);
  const Closure* const drawn = drawn_of(result.closures);
  ASSERT_NE(drawn, nullptr);
  EXPECT_EQ(drawn->id, "G.H.C.B");
}

TEST(PeoplesMechanisms, AreToldOfThePointThatOneBodyHasElsewhere) {
  const Mechanism m = person("mistyped-shared-point-silent");
  const auto is_told = [](const std::string& warning) {
    return warning.find("coupler.B = [11, 70]") != std::string::npos &&
           warning.find("99 mm") != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(m.warnings.begin(), m.warnings.end(), is_told));
}

TEST(PeoplesMechanisms, AreGuessedAsDrawn) {
  for (const char* name :
       {"guess-not-drawn-pose", "walschaerts-motion-slow", "letters-collide-jansen-double",
        "strandbeest-4-drawn-pose-not-listed"}) {
    EXPECT_TRUE(initial_guess(person(name)).isZero(0)) << name;
  }
}

}  // namespace
}  // namespace moivre
