// SPDX-License-Identifier: MIT
// What happens to options that cannot be used? They are refused before any work, with every broken rule in one message.
//
// Rules are what a validate(options) returns, a sentence each. Faults in a text are diagnostics (expression/source.h) instead.
#pragma once

#include <stdexcept>

#include "moivre/expression/joined.h"

namespace moivre {

/// Throws std::invalid_argument, the sentences separated by "; ", unless there are none.
inline void require_unbroken(const std::vector<std::string>& broken_rules) {
  if (!broken_rules.empty()) throw std::invalid_argument(joined(broken_rules, "; "));
}

}  // namespace moivre
