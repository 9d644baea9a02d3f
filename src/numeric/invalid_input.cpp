// SPDX-License-Identifier: MIT
// How are broken rules said in one message?
#include "moivre/numeric/invalid_input.h"

#include <utility>

namespace moivre {
namespace {

std::string in_one_message(const std::vector<std::string>& rules) {
  std::string text;
  for (const std::string& rule : rules) text += (text.empty() ? "" : "; ") + rule;
  return text;
}

}  // namespace

InvalidInput::InvalidInput(const std::string& broken_rule)
    : std::invalid_argument(broken_rule), broken_rules_{broken_rule} {}

InvalidInput::InvalidInput(std::vector<std::string> broken_rules)
    : std::invalid_argument(in_one_message(broken_rules)), broken_rules_(std::move(broken_rules)) {}

InvalidInput::InvalidInput(const std::string& message, std::vector<std::string> broken_rules)
    : std::invalid_argument(message), broken_rules_(std::move(broken_rules)) {}

InvalidInput::~InvalidInput() = default;

void require_unbroken(const std::vector<std::string>& broken_rules) {
  if (!broken_rules.empty()) throw InvalidInput(broken_rules);
}

}  // namespace moivre
