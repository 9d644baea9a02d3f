// SPDX-License-Identifier: MIT
// With which options did a tracker run? Names and values, for the report; numbers stay numbers.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace moivre {

using OptionValue = std::variant<std::string, double, std::int64_t>;

struct OptionInForce {
  std::string name;
  OptionValue value;
};

using OptionsInForce = std::vector<OptionInForce>;

}  // namespace moivre
