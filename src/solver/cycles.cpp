// SPDX-License-Identifier: MIT
// The permutation of the sheets, by hashes in the order of their real parts.
#include "cycles.h"

#include <algorithm>
#include <cmath>
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

}  // namespace

std::vector<std::vector<std::size_t>> cycles_of(const std::vector<Turn>& turns, std::size_t most) {
  const TurnBeginnings beginnings(turns);
  std::vector<std::optional<std::size_t>> next;
  for (const Turn& turn : turns) next.push_back(beginnings.next_of(turn));
  std::vector<std::vector<std::size_t>> cycles;
  std::vector<bool> is_taken(turns.size());
  for (std::size_t first = 0; first < turns.size(); ++first) {
    if (is_taken[first]) continue;
    std::vector<std::size_t> cycle{first};
    auto at = next[first];
    while (at && *at != first && !is_taken[*at] && cycle.size() < most) {
      cycle.push_back(*at);
      at = next[*at];
    }
    if (at != first) cycle.resize(1);
    for (const std::size_t k : cycle) is_taken[k] = true;
    cycles.push_back(std::move(cycle));
  }
  return cycles;
}

}  // namespace moivre
