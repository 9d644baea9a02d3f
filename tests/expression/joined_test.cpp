// SPDX-License-Identifier: MIT
// Are lists said with separators between their parts only?
#include "moivre/expression/joined.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

TEST(Joined, PutsTheSeparatorBetweenPartsOnly) {
  EXPECT_EQ(joined({}, ", "), "");
  EXPECT_EQ(joined({"a"}, ", "), "a");
  EXPECT_EQ(joined({"a", "", "b"}, ", "), "a, , b");
}

}  // namespace
}  // namespace moivre
