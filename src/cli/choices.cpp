// SPDX-License-Identifier: MIT
// Words ride on a check of CLI11 that accepts everything: as its name, since an option has no other
// place for them.
#include "choices.h"

#include <sstream>

#include "moivre/expression/joined.h"

namespace moivre {
namespace {

const std::string kMark = "words:";

std::vector<std::string> cut_at_commas(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

/// All checks of the option, in their order.
std::vector<const CLI::Validator*> validators_of(CLI::Option& option) {
  std::vector<const CLI::Validator*> validators;
  try {
    for (int k = 0;; ++k) validators.push_back(option.get_validator(k));
  } catch (const CLI::OptionNotFound&) {
    return validators;
  }
}

}  // namespace

void offer(CLI::Option& option, const std::vector<std::string>& words) {
  if (words.empty()) return;
  option.check(
      CLI::Validator([](std::string&) { return std::string(); }, "", kMark + joined(words, ",")));
}

std::vector<std::string> checks_of(CLI::Option& option) {
  std::vector<std::string> told;
  for (const CLI::Validator* check : validators_of(option)) {
    const std::string description = check->get_description();
    if (!description.empty()) told.insert(told.begin(), description);
  }
  return told;
}

std::vector<std::string> offered(CLI::Option& option) {
  for (const CLI::Validator* check : validators_of(option)) {
    const std::string& name = check->get_name();
    if (name.starts_with(kMark)) return cut_at_commas(name.substr(kMark.size()));
    const std::string said = check->get_description();
    if (said.starts_with('{') && said.ends_with('}')) {
      return cut_at_commas(said.substr(1, said.size() - 2));
    }
  }
  return {};
}

}  // namespace moivre
