// SPDX-License-Identifier: MIT
// Is none of a hundred thousand fabricated candidates certified where no root lies?
#include "false_roots.h"

namespace moivre::test {
namespace {

TEST(FalseRoots, OfAHundredThousandNoneIsCertifiedWhereNoRootLies) {
  const FalseRootCounts counts = expect_no_untruth(1001, 1700);
  EXPECT_GE(counts.candidates, 100000U);
  RecordProperty("certified", static_cast<int>(counts.certified));
  RecordProperty("elsewhere", static_cast<int>(counts.elsewhere));
  RecordProperty("refused", static_cast<int>(counts.refused));
  RecordProperty("without_root", static_cast<int>(counts.without_root));
}

}  // namespace
}  // namespace moivre::test
