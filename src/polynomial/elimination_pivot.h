// SPDX-License-Identifier: MIT
// Which unknown is substituted next, from which linear equation? The one that leaves the fewest
// terms, as far as these are estimated: a form of l terms to the power e has C(l + e - 1, e), and
// no equation more than a dense one.
//
// Private to the module.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "elimination_state.h"

namespace moivre::elimination {

/// x_variable from row `row`, at an estimated number of new terms.
struct Pivot {
  std::size_t row = 0;
  std::uint32_t variable = 0;
  double fill = 0;
  double size_log2 = 0;
};

/// For each unknown the rows that hold it, ascending, and where in their occurrences it begins.
class Census {
 public:
  struct Place {
    std::size_t row = 0;
    std::size_t first = 0;
  };

  explicit Census(const State& s) : begin_(s.is_eliminated.size() + 1) {
    const auto visit = [&s](const auto& take) {
      for (std::size_t i = 0; i < s.rows.size(); ++i) {
        const auto& occurrences = s.rows[i].equation->occurrences;
        for (std::size_t k = 0; k < occurrences.size(); ++k) {
          const std::uint32_t v = occurrences[k].variable;
          if (k == 0 || occurrences[k - 1].variable != v) take(v, Place{i, k});
        }
      }
    };
    visit([this](std::uint32_t v, const Place&) { ++begin_[v + 1]; });
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    places_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    visit([&](std::uint32_t v, const Place& place) { places_[next[v]++] = place; });
  }

  std::span<const Place> of(std::uint32_t variable) const {
    return std::span(places_).subspan(begin_[variable], begin_[variable + 1] - begin_[variable]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<Place> places_;
};

/// The pivot of least fill; among equals the largest, then the first. `refused` holds origins. None
/// where the search is over.
std::optional<Pivot> choose_pivot(const State& s, const Census& census,
                                  const std::set<std::size_t>& refused, const Limits& limits);

}  // namespace moivre::elimination
