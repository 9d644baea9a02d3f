// SPDX-License-Identifier: MIT
// Through which systems of supports does the search for mixed cells go? Stage by stage one simplex
// gives way to a support.
//
// Notation: D = {0, e_1, ..., e_n}, the standard simplex; supports in the order in which they are
// brought in, each moved to the coordinate planes; d_s: degree of support s, so that A_s lies in
// d_s D.
//   stage s: blocks A_0, ..., A_{s-1}, A_s with d_s D, D, ..., D (n blocks).
// The lifting of d_s D's corners is d_s times that of D's, plus t, from t = -infinity to +infinity:
// at the beginning the cells are those of the stage before; at the end the corners are out of the
// way. In between cells split and merge;
// none comes from nowhere.
// The first cell: D_s has the edge {0, e_s}, and its other corners are lifted so high that this is
// the only cell.
// Source: [Jensen16], the tropical form of regeneration.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact_word.h"
#include "moivre/start/mixed_cells.h"

namespace moivre {

/// variable^exponent of a point; sparse, as most exponents are 0.
struct PointExponent {
  std::uint32_t variable;
  std::int64_t exponent;
};

/// The points of one stage. Point numbers count through the blocks.
struct CellStage {
  std::vector<std::uint32_t> block_begin;  ///< n + 1 point numbers
  std::vector<std::uint32_t> block_of;     ///< of each point
  std::vector<std::uint32_t> coordinate_begin;
  std::vector<PointExponent> coordinates;  ///< of all points
  std::vector<Int128> lifting;             ///< omega at t = 0
  std::vector<Int128> tie_lifting;         ///< the infinitely smaller second lifting
  double largest_exponent_sum = 0;         ///< max over points
  double largest_lifting = 0;

  std::size_t points() const { return block_of.size(); }
};

struct CellStages {
  std::size_t n = 0;
  std::vector<std::size_t> order;     ///< support of block s, as the caller numbers them
  std::vector<std::int64_t> degrees;  ///< d_s
  std::vector<CellStage> stages;
};

/// No more than these, of all stages together; each takes some 60 bytes.
std::uint64_t points_of_stages(const std::vector<Support>& supports);

/// Requires square supports of two terms at least, and a lifting of their shape. nullopt where it
/// is to stop.
std::optional<CellStages> make_stages(const std::vector<Support>& supports, const Lifting& lifting,
                                      std::uint64_t seed, const std::atomic<bool>* stop);

}  // namespace moivre
