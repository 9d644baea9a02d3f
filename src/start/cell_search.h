// SPDX-License-Identifier: MIT
// Which mixed cells are there at the end of the last stage? A walk through the tree of cells that
// pass into each other.
//
// Within a stage the cell's slacks are w + t rate (over det). The next event is the least t = w_g /
// -rate_g over the points g with rate_g < 0: there g reaches the lower hull of its block j, on a
// line with the edge {a_j, b_j}. Let g divide the edge in lambda = C_gj / det:
//   0 < lambda < 1  the cell splits into {a_j, g} and {g, b_j};
//   lambda <= 0     {g, b_j}; for lambda < 0 it comes from two cells, this one and {g, a_j};
//   lambda >= 1     {a_j, g}; for lambda > 1 it comes from two cells, this one and {b_j, g}.
// Of two cells that merge the larger one goes on (of equal ones that whose point off the other edge
// has the lower number): both can tell, so that every cell is met exactly once, without a memory of
// those met.
// A stage is over for a cell when both ends of its edge s are terms of A_s; where no event is left
// before that, the cell goes to infinity with the simplex and is dropped.
// Equal t of two points: the second lifting, infinitely smaller, decides; equal again: NotGeneric.
// Source: [Jensen16].
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cell_stages.h"
#include "exact_word.h"
#include "moivre/start/mixed_cells.h"
#include "moving_cell.h"

namespace moivre {

/// Never leaves the module: the lifting has ties.
struct NotGeneric : std::runtime_error {
  NotGeneric() : std::runtime_error("the lifting is not generic") {}
};

/// Steps between two reports of progress.
inline constexpr std::uint64_t kStepsPerReport = 4096;

template <class Word>
class CellWalk {
 public:
  /// `steps` counts on from where an earlier walk left off.
  CellWalk(const CellStages& stages, const std::vector<std::size_t>& sizes,
           const CellSearchOptions& options, std::uint64_t& steps)
      : stages_(stages), sizes_(sizes), options_(options), steps_(steps) {}

  /// Throws WordTooShort, NotGeneric.
  CellSearchEnd run() {
    begin();
    while (!open_.empty()) {
      MovingCell<Word> cell = std::move(open_.back());
      open_.pop_back();
      const CellSearchEnd end = follow(cell);
      if (end != CellSearchEnd::complete) return end;
    }
    return CellSearchEnd::complete;
  }

  std::vector<MixedCell>& cells() { return cells_; }
  std::uint64_t volume() const { return volume_; }

 private:
  /// The one cell of n simplices, and on to stage 0.
  void begin() {
    MovingCell<Word> cell;
    const std::size_t n = stages_.n;
    cell.inverse.assign(n * n, Word(0));
    for (std::size_t i = 0; i < n; ++i) {
      cell.inverse[i * n + i] = 1;
      cell.a.push_back(static_cast<std::uint32_t>(n));
      cell.b.push_back(static_cast<std::uint32_t>(i));
    }
    enter(std::move(cell), 0);
  }

  /// Block s, so far a simplex, becomes A_s with d_s times that simplex.
  void enter(MovingCell<Word> cell, std::size_t s) {
    const std::size_t n = stages_.n;
    const CellStage& stage = stages_.stages[s];
    const Word d = Word(stages_.degrees[s]);
    require_room(Word(), approximate(d) * (approximate(cell.det) + magnitude(cell.inverse)));
    cell.stage = s;
    cell.a[s] += static_cast<std::uint32_t>(sizes_[s]);
    cell.b[s] += static_cast<std::uint32_t>(sizes_[s]);
    cell.det *= d;
    for (std::size_t k = 0; k < n * n; ++k) {
      if (k / n != s) cell.inverse[k] *= d;
    }
    cell.w = scaled_slacks(stage, cell, scaled_normal(stage, cell));
    cell.rate.assign(stage.points(), Word(0));
    const std::size_t begin = stage.block_begin[s];
    for (std::size_t k = 0; k < sizes_[s]; ++k) cell.rate[begin + k] = -cell.det;
    open_.push_back(std::move(cell));
  }

  /// Until the cell has become one of the next stage, has merged into another, or is dropped.
  CellSearchEnd follow(MovingCell<Word>& cell) {
    for (;;) {
      const std::size_t s = cell.stage;
      if (cell.a[s] < sizes_[s] && cell.b[s] < sizes_[s]) return leave(cell);
      const CellSearchEnd end = count_step();
      if (end != CellSearchEnd::complete) return end;
      const std::size_t g = next_event(cell);
      if (g == kNone || !pass(cell, g)) {
        done_ += cell.share;
        return CellSearchEnd::complete;
      }
    }
  }

  CellSearchEnd count_step() {
    if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) {
      return CellSearchEnd::interrupted;
    }
    if (steps_ >= options_.most_steps) return CellSearchEnd::too_many_steps;
    ++steps_;
    if (steps_ % kStepsPerReport == 0 && options_.progress) {
      options_.progress({cells_.size(), steps_, std::min(done_, 1.0)});
    }
    return CellSearchEnd::complete;
  }

  CellSearchEnd leave(MovingCell<Word>& cell) {
    if (cell.stage + 1 < stages_.n) {
      const std::size_t next = cell.stage + 1;
      enter(std::move(cell), next);
      return CellSearchEnd::complete;
    }
    if (cells_.size() >= options_.most_cells) return CellSearchEnd::too_many_cells;
    check_strict(cell);
    const Word most = Word(kMostVolume);
    if (cell.det > most || cell.det > most - Word(static_cast<std::int64_t>(volume_)))
      return CellSearchEnd::too_large;
    MixedCell found;
    found.volume = static_cast<std::uint64_t>(cell.det);
    found.edges.resize(stages_.n);
    for (std::size_t j = 0; j < stages_.n; ++j) {
      found.edges[stages_.order[j]] = {std::min(cell.a[j], cell.b[j]),
                                       std::max(cell.a[j], cell.b[j])};
    }
    volume_ += found.volume;
    cells_.push_back(std::move(found));
    done_ += cell.share;
    return CellSearchEnd::complete;
  }

  /// The second lifting may have decided; the cell must be one of the first alone.
  void check_strict(const MovingCell<Word>& cell) const {
    const CellStage& stage = stages_.stages.back();
    for (std::size_t j = 0; j < stages_.n; ++j) {
      for (std::size_t k = 0; k < sizes_[j]; ++k) {
        const bool end = k == cell.a[j] || k == cell.b[j];
        if (!end && cell.w[stage.block_begin[j] + k] <= 0) throw NotGeneric();
      }
    }
  }

  static constexpr std::size_t kNone = ~std::size_t{0};
  static constexpr std::int64_t kMostVolume = std::numeric_limits<std::int64_t>::max();

  std::size_t next_event(const MovingCell<Word>& cell) const {
    // w and rate are rounded once each, their quotient once: 3 units of 2^-53.
    const double certain = 1e-14;
    std::size_t first = kNone;
    double first_t = 0;
    for (std::size_t g = 0; g < cell.w.size(); ++g) {
      if (cell.rate[g] >= 0) continue;
      const double t = approximate(cell.w[g]) / -approximate(cell.rate[g]);
      const double margin = certain * (std::abs(t) + std::abs(first_t));
      if (first == kNone || t < first_t - margin ||
          (!(t > first_t + margin) && is_earlier(cell, g, first))) {
        first = g;
        first_t = t;
      }
    }
    return first;
  }

  bool is_earlier(const MovingCell<Word>& cell, std::size_t g, std::size_t h) const {
    const Word g_falls = -cell.rate[g];
    const Word h_falls = -cell.rate[h];
    const int order = compare_fractions(cell.w[g], g_falls, cell.w[h], h_falls);
    if (order != 0) return order < 0;
    const Integer tie =
        tie_slack(cell, g) * to_integer(h_falls) - tie_slack(cell, h) * to_integer(g_falls);
    if (tie == 0) throw NotGeneric();
    return tie < 0;
  }

  /// det * slack of point g in the second lifting at t = 0.
  Integer tie_slack(const MovingCell<Word>& cell, std::size_t g) const {
    const CellStage& stage = stages_.stages[cell.stage];
    const auto omega = [&stage](std::size_t block, std::uint32_t point) {
      return to_integer(stage.tie_lifting[stage.block_begin[block] + point]);
    };
    const std::size_t j = stage.block_of[g];
    Integer slack = to_integer(cell.det) * (to_integer(stage.tie_lifting[g]) - omega(j, cell.a[j]));
    for (std::size_t i = 0; i < stages_.n; ++i) {
      slack -= to_integer(edge_coordinate(stage, cell, i, g)) *
               (omega(i, cell.b[i]) - omega(i, cell.a[i]));
    }
    return slack;
  }

  /// The event of point g. False: another cell goes on in this one's place.
  bool pass(MovingCell<Word>& cell, std::size_t g) {
    const CellStage& stage = stages_.stages[cell.stage];
    const std::size_t j = stage.block_of[g];
    const auto g_in_block = static_cast<std::uint32_t>(g - stage.block_begin[j]);
    const Word c = edge_coordinate(stage, cell, j, g);
    if (c > 0 && c < cell.det) {
      const double part = approximate(c) / approximate(cell.det);
      MovingCell<Word> other = cell;
      turn_edge(other, j);
      exchange_end(stage, other, j, g, column_);
      other.share = cell.share * (1 - part);
      open_.push_back(std::move(other));
      cell.share *= part;
    } else if (c <= 0) {
      const Word sibling = -c;
      if (!goes_on(cell.det, sibling, cell.b[j], g_in_block)) return false;
      turn_edge(cell, j);
    } else {
      const Word sibling = c - cell.det;
      if (!goes_on(cell.det, sibling, cell.a[j], g_in_block)) return false;
    }
    exchange_end(stage, cell, j, g, column_);
    return true;
  }

  static bool goes_on(const Word& volume, const Word& sibling, std::uint32_t outer,
                      std::uint32_t outer_of_sibling) {
    return volume > sibling || (volume == sibling && outer < outer_of_sibling);
  }

  const CellStages& stages_;
  const std::vector<std::size_t>& sizes_;  // of A_s, in the order of the stages
  const CellSearchOptions& options_;
  std::uint64_t& steps_;
  std::vector<MovingCell<Word>> open_;
  std::vector<Word> column_;
  std::vector<MixedCell> cells_;
  std::uint64_t volume_ = 0;
  double done_ = 0;
};

}  // namespace moivre
