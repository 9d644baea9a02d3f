// SPDX-License-Identifier: MIT
// Do mixed volumes and stable mixed volumes agree with PHCpack's, between liftings, and with what
// is known by hand?
#include "moivre/start/mixed_volume.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "families.h"
#include "moivre/polynomial/read.h"
#include "phcpack_rows.h"

namespace moivre {
namespace {

TEST(MixedVolume, AgreesWithPhcpackOnTheProblemsAndOnRandomSupports) {
  const std::vector<PhcpackRow> rows = phcpack_rows();
  ASSERT_GE(rows.size(), 250u);
  for (const PhcpackRow& row : rows) {
    const auto total = with_origin(row.supports, row.supports.size()).supports;
    EXPECT_EQ(mixed_volume(row.supports, 1).value, row.common) << row.name;
    EXPECT_EQ(mixed_volume(total, 1).value, row.total) << row.name;
    EXPECT_EQ(stable_mixed_volume(row.supports, 1).value, row.stable) << row.name;
  }
}

TEST(MixedVolume, TwoLiftingsAgree) {
  for (const auto& supports : {cyclic(7), noon(6), eco(8), katsura(6), reimer(5)}) {
    const MixedVolume one = mixed_volume(supports, 3);
    const MixedVolume two = verified_mixed_volume(supports, 3);
    EXPECT_EQ(one.value, two.value);
    EXPECT_GT(two.steps, one.steps);
  }
}

TEST(MixedVolume, CassouNoguesHas24) {
  const System f = read_system(Source{"cassou", R"(4
 15*b^4*c*d^2 + 6*b^4*c^3 + 21*b^4*c^2*d - 144*b^2*c - 8*b^2*c^2*e - 28*b^2*c*d*e - 648*b^2*d + 36*b^2*d^2*e
 + 9*b^4*d^3 - 120;
 30*c^3*b^4*d - 32*d*e^2*c - 720*d*b^2*c - 24*c^3*b^2*e - 432*c^2*b^2 + 576*e*c - 576*d*e + 16*c*b^2*d^2*e
 + 16*d^2*e^2 + 16*e^2*c^2 + 9*c^4*b^4 + 5184 + 39*d^2*b^4*c^2 + 18*d^3*b^4*c - 432*d^2*b^2 + 24*d^3*b^2*e
 - 16*c^2*b^2*d*e - 240*c;
 216*d*b^2*c - 162*d^2*b^2 - 81*c^2*b^2 + 5184 + 1008*e*c - 1008*d*e + 15*c^2*b^2*d*e - 15*c^3*b^2*e
 - 80*d*e^2*c + 40*d^2*e^2 + 40*e^2*c^2;
 261 + 4*d*b^2*c - 3*d^2*b^2 - 4*c^2*b^2 + 22*e*c - 22*d*e;
)"});
  EXPECT_EQ(verified_mixed_volume(supports_of(f), 1).value, 24u);
}

TEST(MixedVolume, AVolumeThatIsNotComputedHasItsReason) {
  CellSearchOptions options;
  options.most_steps = 50;
  for (const MixedVolume& v :
       {mixed_volume(cyclic(7), 1, options), verified_mixed_volume(cyclic(7), 1, options),
        stable_mixed_volume(cyclic(7), 1, options)}) {
    EXPECT_FALSE(v.value);
    EXPECT_EQ(v.end, CellSearchEnd::too_many_steps);
    EXPECT_EQ(v.steps, 50u);
  }
}

TEST(StableMixedVolume, CountsTheRootsWithZeroCoordinatesThatTheTorusMisses) {
  // x (x - a)(y - b), y (x - c): roots (0, 0), (a, 0) and (c, b).
  const std::vector<Support> supports{{{{2, 1}, {2, 0}, {1, 1}, {1, 0}}}, {{{1, 1}, {0, 1}}}};
  EXPECT_EQ(mixed_volume(supports, 1).value, 1u);
  EXPECT_EQ(stable_mixed_volume(supports, 1).value, 3u);
}

TEST(StableMixedVolume, GrowsLikeAVolumeWithTheExponents) {
  const std::uint32_t m = 1000;
  std::size_t compared = 0;
  for (const PhcpackRow& row : phcpack_rows()) {
    const std::size_t n = row.supports.size();
    if (n > 3) continue;
    std::uint64_t factor = 1;
    for (std::size_t j = 0; j < n; ++j) factor *= m;
    EXPECT_EQ(stable_mixed_volume(stretched(row.supports, m), 1).value, row.stable * factor)
        << row.name;
    ++compared;
  }
  EXPECT_GT(compared, 50u);
}

TEST(StableMixedVolume, TheAddedZerosAreLiftedHighEnoughWhateverTheExponents) {
  // x^{d-1} (a x + b): the slack of x^d over the edge {0, x^{d-1}} is only 1/(d-1) of the zero's
  // height.
  for (const std::uint32_t d : {10u, 1000u, 100000u, 100000000u}) {
    const std::vector<Support> supports{{{{d}, {d - 1}}}};
    EXPECT_EQ(mixed_volume(supports, 1).value, 1u);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const CellSearch search = stable_mixed_cells(supports, seed);
      ASSERT_TRUE(search.subdivision) << d;
      EXPECT_EQ(search.subdivision->mixed_volume, d);
      EXPECT_EQ(search.subdivision->cells.size(), 2u);
    }
  }
}

TEST(StableMixedVolume, ItsCellsAreCellsOfTheSupportsWithZeroAdded) {
  const CellSearch search = stable_mixed_cells(katsura(4), 1);
  ASSERT_TRUE(search.subdivision);
  EXPECT_EQ(search.subdivision->supports, with_origin(katsura(4), 5).supports);
  EXPECT_EQ(search.subdivision->mixed_volume, 16u);
}

TEST(StableMixedVolume, RefusesSupportsThatAreNotSquare) {
  EXPECT_THROW(stable_mixed_cells({Support{{{1, 0}}}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
