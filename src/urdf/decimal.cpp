// SPDX-License-Identifier: MIT
// The word is brought into the form that moivre/expression/expression.h reads, which keeps decimals
// exact.
#include "decimal.h"

#include "moivre/expression/expression.h"

namespace moivre {
namespace {

/// A message quotes at most this much of a word.
constexpr std::size_t kQuoted = 40;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Digits with at most one point and an exponent; `mantissa_end` is where that begins.
bool is_decimal(std::string_view word) {
  std::size_t k = 0;
  std::size_t digits = 0;
  const auto skip_digits = [&] {
    while (k < word.size() && is_digit(word[k])) ++k, ++digits;
  };
  skip_digits();
  if (k < word.size() && word[k] == '.') {
    ++k;
    skip_digits();
  }
  if (digits == 0) return false;
  if (k == word.size()) return true;
  if (word[k] != 'e' && word[k] != 'E') return false;
  ++k;
  if (k < word.size() && (word[k] == '-' || word[k] == '+')) ++k;
  digits = 0;
  skip_digits();
  return digits > 0 && k == word.size();
}

std::string refusal_of(std::string_view word) {
  const std::string quoted = std::string("'").append(word.substr(0, kQuoted)) + "'";
  if (word.find("${") != std::string_view::npos || word.find("$(") != std::string_view::npos) {
    return quoted + " is for xacro; run xacro first and give its result";
  }
  if (word.find(',') != std::string_view::npos) {
    return quoted + " is no number: blanks stand between numbers, and decimals have a point";
  }
  if (word.find("pi") != std::string_view::npos) {
    return quoted + " is no number: a URDF has numbers alone, pi is 3.141592653589793";
  }
  for (const std::string_view infinite : {"nan", "NaN", "inf", "Inf", "INF", "NAN"}) {
    if (word.find(infinite) != std::string_view::npos) return quoted + " is not finite";
  }
  return quoted + " is no number";
}

}  // namespace

Decimal read_decimal(std::string_view word) {
  const bool is_negative = word.starts_with('-');
  std::string_view unsigned_word = word;
  if (is_negative || word.starts_with('+')) unsigned_word.remove_prefix(1);
  if (!is_decimal(unsigned_word)) return {{}, refusal_of(word)};
  std::string text(unsigned_word);
  const std::size_t point = text.find('.');
  if (point != std::string::npos && (point + 1 == text.size() || !is_digit(text[point + 1]))) {
    text.insert(point + 1, "0");
  }
  std::vector<Diagnostic> faults;
  const Expression number = parse_expression(text, {}, faults);
  if (!faults.empty()) return {{}, faults.front().message};
  return {is_negative ? -number.number : number.number, ""};
}

}  // namespace moivre
