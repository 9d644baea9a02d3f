// SPDX-License-Identifier: MIT
// Does a command refuse what it cannot do, with exit code 1, nothing on stdout and the reasons on
// stderr?
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program.h"

namespace moivre::test {

/// What a command says to wrong options.
struct Refusal {
  std::vector<std::string> options;
  std::string message;
};

class RefusingCommands : public testing::Test {
 protected:
  void expect_refusal(const std::vector<std::string>& command,
                      const std::vector<std::string>& parts) const {
    const Outcome outcome = scene.run(command);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
    EXPECT_EQ(outcome.out, "");
    for (const std::string& part : parts) EXPECT_TRUE(contains(outcome.err, part)) << outcome.err;
  }

  Scene scene;
};

}  // namespace moivre::test
