// SPDX-License-Identifier: MIT
// One table: the library's name, and what the command line calls it.
#include "option_words.h"

#include <array>
#include <utility>

namespace moivre {
namespace {

// Longer ones first, where one is a part of another.
constexpr std::array<std::pair<const char*, const char*>, 6> kWords{{
    {"by `held`", "by --hold JOINT=VALUE"},
    {"`held`", "--hold"},
    {"`tip`", "--tip"},
    {"`slice`", "moivre solve --slice"},
    {"`start`", "--start"},
    {"`follow_guesses`", "--from-guess"},
}};

}  // namespace

std::string in_option_words(std::string refusal) {
  for (const auto& [own, option] : kWords) {
    const std::string word = own;
    for (std::size_t at = 0; (at = refusal.find(word, at)) != std::string::npos;) {
      refusal.replace(at, word.size(), option);
    }
  }
  return refusal;
}

}  // namespace moivre
