// SPDX-License-Identifier: MIT
// Are all broken rules told at once, in one exception that others may catch as what it is?
#include "moivre/numeric/invalid_input.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

TEST(InvalidInput, NamesEveryBrokenRule) {
  EXPECT_NO_THROW(require_unbroken({}));
  try {
    require_unbroken({"threads are too many", "steps are too few"});
    FAIL() << "broken rules were not refused";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_STREQ(refusal.what(), "threads are too many; steps are too few");
    const auto* input = dynamic_cast<const InvalidInput*>(&refusal);
    ASSERT_NE(input, nullptr);
    EXPECT_EQ(input->broken_rules(),
              (std::vector<std::string>{"threads are too many", "steps are too few"}));
  }
}

TEST(InvalidInput, HasOneRuleWhereOneIsBroken) {
  EXPECT_EQ(InvalidInput("no number").broken_rules(), std::vector<std::string>{"no number"});
}

}  // namespace
}  // namespace moivre
