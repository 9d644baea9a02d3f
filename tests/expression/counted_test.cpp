// SPDX-License-Identifier: MIT
// Numbers of things, as they are said.
#include "moivre/expression/counted.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

TEST(Counted, KnowsThePlural) {
  EXPECT_EQ(counted(1, "path"), "1 path");
  EXPECT_EQ(counted(0, "path"), "0 paths");
  EXPECT_EQ(counted(2, "is", "are"), "2 are");
}

}  // namespace
}  // namespace moivre
