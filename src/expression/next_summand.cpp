// SPDX-License-Identifier: MIT
// One pass over the characters with a stack of open parentheses.
#include "next_summand.h"

#include <utility>

namespace moivre {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_sign(char c) { return c == '+' || c == '-'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Behind the number or name that begins at `at`; `at` itself where neither does.
std::size_t word_end(std::string_view text, std::size_t at) {
  const bool is_number = at < text.size() && (is_digit(text[at]) || text[at] == '.');
  std::size_t end = at;
  while (end < text.size()) {
    const char c = text[end];
    const bool is_sign_of_exponent = is_number && end > at && is_sign(c) &&
                                     (text[end - 1] == 'e' || text[end - 1] == 'E') &&
                                     end + 1 < text.size() && is_digit(text[end + 1]);
    if (!is_digit(c) && !is_letter(c) && c != '.' && !is_sign_of_exponent) break;
    ++end;
  }
  return end;
}

}  // namespace

NextSummand next_summand(std::string_view text, std::size_t from, std::vector<std::size_t> open) {
  NextSummand next;
  std::size_t at = from;
  while (at < text.size()) {
    const std::size_t end = word_end(text, at);
    if (end > at) {
      at = end;
      continue;
    }
    const char c = text[at];
    if (c == '(') open.push_back(at);
    if (c == ')' && open.empty()) next.unopened.push_back(at);
    if (c == ')' && !open.empty()) open.pop_back();
    ++at;
    if (is_sign(c) && open.empty()) {
      // Signs in a row are one fault, not many.
      while (at < text.size() && (is_sign(text[at]) || text[at] == ' ')) ++at;
      next.begin = at;
      return next;
    }
  }
  if (!open.empty()) next.unclosed = open.back();
  return next;
}

}  // namespace moivre
