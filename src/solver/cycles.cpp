// SPDX-License-Identifier: MIT
// The permutation of the sheets, by hashes in the order of their real parts.
#include "cycles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "point_hash.h"

namespace moivre {
namespace {

/// Where turns begin, by radius and then by the hash's real part.
class TurnBeginnings {
 public:
  explicit TurnBeginnings(const std::vector<Turn>& turns) : turns_(turns) {
    for (std::size_t k = 0; k < turns.size(); ++k) {
      if (std::isfinite(std::abs(turns[k].begin))) order_.push_back(k);
    }
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return key(turns_[a]) < key(turns_[b]); });
  }

  /// The one turn that begins where this one ends.
  std::optional<std::size_t> next_of(const Turn& turn) const {
    if (!std::isfinite(std::abs(turn.end))) return std::nullopt;
    const double reach = tolerance_at(turn.end);
    const double least = turn.end.real() - reach;
    const double most = turn.end.real() + reach;
    std::optional<std::size_t> found;
    auto at = std::lower_bound(order_.begin(), order_.end(), std::pair(turn.radius, least),
                               [&](std::size_t k, const std::pair<double, double>& sought) {
                                 return key(turns_[k]) < sought;
                               });
    for (; at != order_.end() && key(turns_[*at]) <= std::pair(turn.radius, most); ++at) {
      if (std::abs(turns_[*at].begin - turn.end) > reach) continue;
      if (found) return std::nullopt;
      found = *at;
    }
    return found;
  }

 private:
  static std::pair<double, double> key(const Turn& turn) {
    return {turn.radius, turn.begin.real()};
  }

  const std::vector<Turn>& turns_;
  std::vector<std::size_t> order_;
};

/// Of each ring of two sheets and more the smallest position.
std::vector<std::size_t> smallest_of_rings(const std::vector<std::optional<std::size_t>>& next) {
  constexpr std::size_t kNotSeen = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> seen_from(next.size(), kNotSeen);
  std::vector<std::size_t> result;
  for (std::size_t first = 0; first < next.size(); ++first) {
    std::optional<std::size_t> at = first;
    for (; at && seen_from[*at] == kNotSeen; at = next[*at]) seen_from[*at] = first;
    if (!at || seen_from[*at] != first || next[*at] == at) continue;
    std::size_t smallest = *at;
    for (std::size_t k = *next[*at]; k != *at; k = *next[k]) smallest = std::min(smallest, k);
    result.push_back(smallest);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

std::vector<SheetChain> chains_of(const std::vector<Turn>& turns) {
  const TurnBeginnings beginnings(turns);
  const std::size_t count = turns.size();
  std::vector<std::optional<std::size_t>> next;
  for (const Turn& turn : turns) next.push_back(beginnings.next_of(turn));
  std::vector<SheetChain> chains;
  std::vector<bool> is_taken(count);
  // From `first` on, as far as sheets are free.
  const auto take_chain = [&](std::size_t first) {
    SheetChain chain;
    std::optional<std::size_t> at = first;
    for (; at && !is_taken[*at]; at = next[*at]) {
      is_taken[*at] = true;
      chain.sheets.push_back(*at);
    }
    chain.is_closed = chain.sheets.size() > 1 && at == first;
    chains.push_back(std::move(chain));
  };
  for (const std::size_t first : smallest_of_rings(next)) take_chain(first);
  std::vector<bool> has_predecessor(count);
  for (std::size_t k = 0; k < count; ++k) {
    if (!is_taken[k] && next[k] && *next[k] != k) has_predecessor[*next[k]] = true;
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (!is_taken[k] && !has_predecessor[k]) take_chain(k);
  }
  return chains;
}

}  // namespace moivre
