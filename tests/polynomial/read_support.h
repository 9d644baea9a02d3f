// SPDX-License-Identifier: MIT
// What the tests of the readers share: a text in, its system or its faults out.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "moivre/polynomial/read.h"

namespace moivre {

/// A fault as the tests state it: where, and a piece of what is said.
struct ExpectedFault {
  std::size_t line;
  std::size_t column;
  std::string part;
};

inline System system_of(const std::string& text) { return read_system({"file", text}); }

inline std::vector<Diagnostic> faults_of(const std::string& text) {
  try {
    system_of(text);
  } catch (const ParseError& error) {
    return error.diagnostics();
  }
  return {};
}

inline void expect_faults(const std::string& text, const std::vector<ExpectedFault>& expected) {
  const std::vector<Diagnostic> faults = faults_of(text);
  std::string said;
  for (const Diagnostic& fault : faults) said += to_text(fault, {"file", text});
  ASSERT_EQ(faults.size(), expected.size()) << said;
  for (std::size_t k = 0; k < faults.size(); ++k) {
    EXPECT_EQ(faults[k].at.line, expected[k].line) << said;
    EXPECT_EQ(faults[k].at.column, expected[k].column) << said;
    EXPECT_NE(faults[k].message.find(expected[k].part), std::string::npos)
        << "expected: " << expected[k].part << "\nsaid: " << said;
  }
}

}  // namespace moivre
