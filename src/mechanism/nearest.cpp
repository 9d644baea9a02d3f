// SPDX-License-Identifier: MIT
// How near are two words? Edit distance with swapped neighbours, letters' case ignored.
#include "moivre/mechanism/nearest.h"

#include <algorithm>
#include <cctype>

namespace moivre {
namespace {

constexpr std::size_t kLongestWord = 64;  // beyond it nobody mistyped a name
constexpr std::size_t kListed = 8;        // known words listed where none is near

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// "bodies" -> "body".
std::string singular(const std::string& word) {
  return word.ends_with("ies") ? word.substr(0, word.size() - 3) + "y" : word;
}

/// Insertions, deletions, substitutions and swaps of neighbours that turn a into b.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = last;
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                           lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::optional<std::string> nearest_word(const std::string& word,
                                        const std::vector<std::string>& known) {
  // A third of the letters may be wrong, never all of them.
  const std::size_t allowed = word.size() < 2 ? 0 : std::max<std::size_t>(1, (word.size() + 1) / 3);
  std::size_t best = allowed + 1;
  std::optional<std::string> nearest;
  for (const std::string& candidate : known) {
    if (word.size() > kLongestWord || candidate.size() > kLongestWord) continue;
    const std::size_t d = std::min(distance(word, candidate), distance(singular(word), candidate));
    if (d < best) {
      best = d;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  if (known.empty()) return "";
  if (const auto nearest = nearest_word(word, known)) return "; did you mean '" + *nearest + "'?";
  std::string list = known.size() == 1 ? "; known is" : "; known are";
  for (std::size_t k = 0; k < std::min(known.size(), kListed); ++k) {
    list += (k == 0 ? " '" : ", '") + known[k] + "'";
  }
  return known.size() > kListed ? list + ", ..." : list;
}

}  // namespace moivre
