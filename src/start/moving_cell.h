// SPDX-License-Identifier: MIT
// How does a mixed cell pass into its neighbour? One end of one edge is exchanged, by one step of
// fraction-free elimination.
//
//   V: rows v_i = b_i - a_i of the cell's edges; det = |det V| > 0; inverse = det V^{-1}, integers;
//   point g of block j in the edges: g - a_j = sum_i (C_gi / det) v_i, C_gi = <g - a_j, column i of
//   inverse>;
//   w_g = det * slack of g at t = 0, rate_g = det * d(slack)/dt.
// Replacing b_j by g, p = C_gj > 0:
//   det' = p,  w' = (p w - C_.j w_g) / det, rate' and the other columns of the inverse alike,
//              column j stays:
//   the divisions leave no remainder [Bareiss68].
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cell_stages.h"
#include "exact_word.h"

namespace moivre {

template <class Word>
struct MovingCell {
  std::size_t stage = 0;
  double share = 1;  ///< of the whole search
  Word det = 1;
  std::vector<Word> inverse;     ///< n x n; column i of det V^{-1} at [i n, (i + 1) n)
  std::vector<std::uint32_t> a;  ///< ends of the edges, point numbers within the block
  std::vector<std::uint32_t> b;
  std::vector<Word> w;
  std::vector<Word> rate;
};

template <class Word>
Word times_point(const CellStage& stage, const Word* row, std::size_t point) {
  Word sum = 0;
  for (std::size_t k = stage.coordinate_begin[point]; k < stage.coordinate_begin[point + 1]; ++k) {
    const PointExponent& c = stage.coordinates[k];
    sum += row[c.variable] * Word(c.exponent);
  }
  return sum;
}

/// values of all points, each block's counted from its end a.
template <class Word>
void count_from_ends(const CellStage& stage, const std::vector<std::uint32_t>& a,
                     std::vector<Word>& values) {
  for (std::size_t j = 0; j < a.size(); ++j) {
    const Word base = values[stage.block_begin[j] + a[j]];
    for (std::size_t g = stage.block_begin[j]; g < stage.block_begin[j + 1]; ++g) values[g] -= base;
  }
}

/// C_gi of all points g.
template <class Word>
void edge_coordinates(const CellStage& stage, const MovingCell<Word>& cell, std::size_t i,
                      std::vector<Word>& column) {
  const std::size_t n = cell.a.size();
  const Word* row = &cell.inverse[i * n];
  require_room(Word(), 2 * magnitude(row, n) * stage.largest_exponent_sum);
  column.resize(stage.points());
  for (std::size_t g = 0; g < column.size(); ++g) column[g] = times_point(stage, row, g);
  count_from_ends(stage, cell.a, column);
}

/// C_gi of one point.
template <class Word>
Word edge_coordinate(const CellStage& stage, const MovingCell<Word>& cell, std::size_t i,
                     std::size_t g) {
  const std::size_t n = cell.a.size();
  const std::size_t j = stage.block_of[g];
  const Word* row = &cell.inverse[i * n];
  require_room(Word(), 2 * magnitude(row, n) * stage.largest_exponent_sum);
  return times_point(stage, row, g) - times_point(stage, row, stage.block_begin[j] + cell.a[j]);
}

/// The same cell with the ends of edge j named the other way round.
template <class Word>
void turn_edge(MovingCell<Word>& cell, std::size_t j) {
  const std::size_t n = cell.a.size();
  std::swap(cell.a[j], cell.b[j]);
  for (std::size_t k = 0; k < n; ++k) cell.inverse[j * n + k] = -cell.inverse[j * n + k];
}

/// Point g takes the place of b_j; requires C_gj > 0. `column` is room for all points.
template <class Word>
void exchange_end(const CellStage& stage, MovingCell<Word>& cell, std::size_t j, std::size_t g,
                  std::vector<Word>& column) {
  const std::size_t n = cell.a.size();
  edge_coordinates(stage, cell, j, column);
  const Word p = column[g];
  const ExactDivisor<Word> det(cell.det);
  const Word w_g = cell.w[g];
  const Word rate_g = cell.rate[g];
  eliminate(p, cell.w.data(), column.data(), w_g, column.size(), det);
  eliminate(p, cell.rate.data(), column.data(), rate_g, column.size(), det);
  for (std::size_t i = 0; i < n; ++i) {
    if (i == j) continue;
    const Word q = edge_coordinate(stage, cell, i, g);
    eliminate(p, &cell.inverse[i * n], &cell.inverse[j * n], q, n, det);
  }
  cell.det = p;
  cell.b[j] = static_cast<std::uint32_t>(g - stage.block_begin[j]);
}

/// det * alpha, from the edges' liftings at t = 0.
template <class Word>
std::vector<Word> scaled_normal(const CellStage& stage, const MovingCell<Word>& cell) {
  const std::size_t n = cell.a.size();
  require_room(Word(),
               2 * static_cast<double>(n) * magnitude(cell.inverse) * stage.largest_lifting);
  std::vector<Word> alpha(n, Word(0));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t begin = stage.block_begin[i];
    const Word rise =
        as_word<Word>(stage.lifting[begin + cell.b[i]] - stage.lifting[begin + cell.a[i]]);
    for (std::size_t k = 0; k < n; ++k) alpha[k] -= cell.inverse[i * n + k] * rise;
  }
  return alpha;
}

/// det * slack of all points for given det * alpha and lifting.
template <class Word>
std::vector<Word> scaled_slacks(const CellStage& stage, const MovingCell<Word>& cell,
                                const std::vector<Word>& alpha) {
  require_room(Word(), 2 * (approximate(cell.det) * stage.largest_lifting +
                            magnitude(alpha) * stage.largest_exponent_sum));
  std::vector<Word> w(stage.points());
  for (std::size_t g = 0; g < w.size(); ++g) {
    w[g] = cell.det * as_word<Word>(stage.lifting[g]) + times_point(stage, alpha.data(), g);
  }
  count_from_ends(stage, cell.a, w);
  return w;
}

}  // namespace moivre
