// SPDX-License-Identifier: MIT
// Do larger systems and other seeds still have the right mixed volumes?
#include <gtest/gtest.h>

#include "families.h"
#include "moivre/start/mixed_volume.h"
#include "phcpack_rows.h"

namespace moivre {
namespace {

TEST(MixedVolume, LargerSystemsHaveThePublishedMixedVolumes) {
  EXPECT_EQ(verified_mixed_volume(cyclic(9), 1).value, 11016u);
  EXPECT_EQ(verified_mixed_volume(cyclic(10), 1).value, 35940u);
  EXPECT_EQ(verified_mixed_volume(noon(9), 1).value, 19665u);
  EXPECT_EQ(verified_mixed_volume(eco(12), 1).value, 1024u);
  EXPECT_EQ(verified_mixed_volume(reimer(6), 1).value, 5040u);
}

TEST(MixedVolume, EverySeedAgreesWithPhcpack) {
  for (const PhcpackRow& row : phcpack_rows()) {
    const auto total = with_origin(row.supports, row.supports.size()).supports;
    for (std::uint64_t seed = 2; seed <= 6; ++seed) {
      EXPECT_EQ(mixed_volume(row.supports, seed).value, row.common) << row.name;
      EXPECT_EQ(mixed_volume(total, seed).value, row.total) << row.name;
      EXPECT_EQ(stable_mixed_volume(row.supports, seed).value, row.stable) << row.name;
    }
  }
}

}  // namespace
}  // namespace moivre
