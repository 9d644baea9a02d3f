// SPDX-License-Identifier: MIT
// The one list of what people type or copy, and of what is meant by it.
#include "moivre/expression/lookalikes.h"

#include <algorithm>
#include <array>

namespace moivre {
namespace {

constexpr std::string_view kComment = "a comment begins with `#`, in Bertini's form with `%`";
constexpr std::string_view kUnequal =
    "conditions have `<`, `<=`, `>` or `>=`; --nonzero (nonzero=True) leaves out roots with a 0";

/// What stands in the place of what is typed, and why; no advice: type it.
struct Lookalike {
  std::string_view printed;
  std::string_view typed;
  std::string_view advice = "";
};
constexpr std::array kLookalikes = std::to_array<Lookalike>({
    {"\u2212", "-"},
    {"\u2013", "-"},
    {"\u00B7", "*"},
    {"\u22C5", "*"},
    {"\u2217", "*"},
    {"\u00D7", "*"},
    {"\u00F7", "/"},
    {"\u2215", "/"},
    {"\u2044", "/"},
    {"\u2070", "^0"},
    {"\u00B9", "^1"},
    {"\u00B2", "^2"},
    {"\u00B3", "^3"},
    {"\u2074", "^4"},
    {"\u2075", "^5"},
    {"\u2076", "^6"},
    {"\u2077", "^7"},
    {"\u2078", "^8"},
    {"\u2079", "^9"},
    {"\u207B", "^-", "type `x^(-1)` for `x\u207B\u00B9`"},
    {"\u00BD", "1/2"},
    {"\u2153", "1/3"},
    {"\u2154", "2/3"},
    {"\u00BC", "1/4"},
    {"\u00BE", "3/4"},
    {"\u221A", "sqrt", "type `sqrt(2)` for `\u221A2`"},
    {"\u221B", "cbrt", "type `2^(1/3)` for `\u221B2`"},
    {"\u2264", "<="},
    {"\u2A7D", "<="},
    {"\u2265", ">="},
    {"\u2A7E", ">="},
    {"\u2260", "!=", kUnequal},
    {"\u2192", "="},
    {"\u21D2", "="},
    {"\u2261", "="},
    {"\u00A0", " "},
    {"//", "#", kComment},
    {"/*", "#", kComment},
    {"%", "#", kComment},
    {"_{", "_", "an index is typed `a_1`"},
    {"^{", "^(", "an exponent is typed `x^2` or `x^(-2)`"},
});

const Lookalike* at_front(std::string_view text) {
  const auto* const found =
      std::find_if(kLookalikes.begin(), kLookalikes.end(),
                   [&](const Lookalike& one) { return text.starts_with(one.printed); });
  return found == kLookalikes.end() ? nullptr : found;
}

}  // namespace

std::string lookalike_advice(std::string_view text, std::size_t at) {
  const Lookalike* one = at_front(text.substr(at));
  // The sign before it may be an operator by itself: `/` of `//`.
  if (one == nullptr && at > 0) {
    one = at_front(text.substr(at - 1));
    if (one != nullptr && one->printed.size() < 2) one = nullptr;
  }
  if (one == nullptr) return "";
  if (!one->advice.empty()) return "; " + std::string(one->advice);
  return "; type `" + std::string(one->typed) + "` for it";
}

std::string with_what_is_meant(std::string_view text) {
  std::string meant;
  while (!text.empty()) {
    const Lookalike* one = at_front(text);
    meant += one == nullptr ? text.substr(0, 1) : one->typed;
    text.remove_prefix(one == nullptr ? 1 : one->printed.size());
  }
  return meant;
}

}  // namespace moivre
