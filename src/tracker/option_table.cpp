// SPDX-License-Identifier: MIT
// What is said of a word that an option does not take?
#include "moivre/tracker/option_table.h"

namespace moivre {

std::string refusal_of_word(const OptionFacts& facts, const std::string& word) {
  std::string text = facts.flag + " " + word + ": ";
  const auto reason = facts.absent.find(word);
  if (reason != facts.absent.end()) return text + reason->second;
  text += "the " + facts.plural + " are ";
  for (std::size_t k = 0; k < facts.words.size(); ++k) {
    if (k > 0) text += k + 1 == facts.words.size() ? " and " : ", ";
    text += facts.words[k];
  }
  return text;
}

}  // namespace moivre
