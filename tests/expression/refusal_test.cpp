// SPDX-License-Identifier: MIT
// Are all broken rules told at once, and lists said with separators between their parts only?
#include "moivre/expression/refusal.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

TEST(Joined, PutsTheSeparatorBetweenPartsOnly) {
  EXPECT_EQ(joined({}, ", "), "");
  EXPECT_EQ(joined({"a"}, ", "), "a");
  EXPECT_EQ(joined({"a", "", "b"}, ", "), "a, , b");
}

TEST(Refusal, NamesEveryBrokenRule) {
  EXPECT_NO_THROW(require_unbroken({}));
  try {
    require_unbroken({"threads are too many", "steps are too few"});
    FAIL() << "broken rules were not refused";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_STREQ(refusal.what(), "threads are too many; steps are too few");
  }
}

}  // namespace
}  // namespace moivre
