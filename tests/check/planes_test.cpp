// SPDX-License-Identifier: MIT
// Is a coordinate plane refuted on which an equation is not zero, or that has another dimension?
#include <gtest/gtest.h>

#include <algorithm>

#include "results.h"

namespace moivre::test {
namespace {

/// Of x^2 - x*y and x^2*y - x: two roots, and the line x = 0.
Judgement judged_with(const Json& planes) {
  Json result = honest("line");
  result["planes"] = planes;
  return judged("line", result);
}

Json plane(const Json& zero, int dimension) { return {{"zero", zero}, {"dimension", dimension}}; }

TEST(CheckPlanes, ThoseOfSolveHold) {
  const Json result = honest("line");
  ASSERT_EQ(result["planes"], Json::array({plane({"x"}, 1)}));
  const Judgement judgement = judged("line", result);
  EXPECT_TRUE(judgement.holds()) << lines(judgement.refuted);
  const auto is_plane = [](const ClaimTally& tally) { return tally.claim == ClaimKind::plane; };
  const auto tally = std::find_if(judgement.claims.begin(), judgement.claims.end(), is_plane);
  ASSERT_NE(tally, judgement.claims.end());
  EXPECT_EQ(tally->holds, 1U);
}

TEST(CheckPlanes, APlaneOnWhichAnEquationIsNotZeroIsRefuted) {
  const Judgement judgement = judged_with(Json::array({plane({"x"}, 1), plane({"y"}, 1)}));
  EXPECT_TRUE(refutes(judgement, ClaimKind::plane));
  EXPECT_NE(lines(judgement.refuted).find("plane: where y = 0: equation 1 is not zero"),
            std::string::npos)
      << lines(judgement.refuted);
}

TEST(CheckPlanes, AnotherDimensionIsRefuted) {
  EXPECT_TRUE(refutes(judged_with(Json::array({plane({"x"}, 2)})), ClaimKind::plane));
  EXPECT_TRUE(refutes(judged_with(Json::array({plane({"x", "y"}, 0)})), ClaimKind::plane))
      << "a point";
}

TEST(CheckPlanes, ANameThatIsNoUnknownIsRefuted) {
  EXPECT_TRUE(refutes(judged_with(Json::array({plane({"z"}, 1)})), ClaimKind::plane));
}

TEST(CheckPlanes, AResultThatTellsNoneClaimsNone) {
  Json result = honest("line");
  result.erase("planes");
  for (const ClaimTally& tally : judged("line", result).claims) {
    EXPECT_NE(tally.claim, ClaimKind::plane);
  }
}

}  // namespace
}  // namespace moivre::test
