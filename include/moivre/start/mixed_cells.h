// SPDX-License-Identifier: MIT
// Which binomial systems does a sparse system degenerate into? The mixed cells of its supports for
// a random lifting.
//
//   A_1, ..., A_n: supports in n variables; omega_ik: integer lifting of term a_ik.
//   Mixed cell: an edge {a_i, b_i} of every A_i and alpha in Q^n with, for all k,
//     w_ik = omega_ik + <alpha, a_ik> - min_l (omega_il + <alpha, a_il>) = 0 at the two ends of the
//     edge, > 0 elsewhere.
//   Volume of a cell: |det V|, row i of V = b_i - a_i. The volumes add up to the mixed volume,
//   which bounds the number of isolated roots without zero coordinates and is it for generic
//   coefficients (Bernstein).
//
// The cells are followed while the lifting moves (tropical homotopy continuation). It begins with
// standard simplices, which have one cell; the supports replace them one after the other. Every
// decision is made in exact integers of 64 bits, then of 128, then of any length where those would
// overflow. Ties are broken by a second, infinitely smaller lifting. If the cells of the lifting
// itself are not strict, another lifting is tried. The result depends only on supports, seed and
// lifting.
//
// Edges: a support of fewer than two terms, or supports of too low a dimension, have mixed volume 0
// and no cell; no variables at all: one cell, of volume 1. Equal terms in a support are allowed.
// Not supported: supports that are not square (std::invalid_argument).
// Sources: [HuberSturmfels95], [Jensen16].
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "moivre/start/support.h"

namespace moivre {

struct MixedCell {
  std::vector<std::array<std::uint32_t, 2>>
      edges;                 ///< of support i: two terms, the lower index first
  std::uint64_t volume = 0;  ///< |det V|

  friend bool operator==(const MixedCell&, const MixedCell&) = default;
};

/// omega_ik: one number for every term of every support.
using Lifting = std::vector<std::vector<std::int64_t>>;

struct MixedSubdivision {
  std::vector<Support> supports;
  Lifting lifting;
  std::vector<MixedCell> cells;    ///< sorted by their edges
  std::uint64_t mixed_volume = 0;  ///< sum of the volumes
};

enum class CellSearchEnd {
  complete,
  interrupted,     ///< by the stop flag
  too_many_cells,  ///< more than `most_cells`
  too_many_steps,  ///< more than `most_steps`
  too_large,       ///< the mixed volume is beyond 2^63
  not_generic,     ///< the lifting has ties: only for a lifting from outside
  too_many_points  ///< of all stages of the search: some three hundred unknowns and more
};

/// In words, for a sentence such as "mixed volume not computed: ...".
const char* description(CellSearchEnd end);

struct CellSearchProgress {
  std::uint64_t cells = 0;  ///< found so far
  std::uint64_t steps = 0;
  double fraction = 0;  ///< of the work, estimated; in [0, 1], never falls within one lifting
};

struct CellSearchOptions {
  std::uint64_t most_cells = std::numeric_limits<std::uint64_t>::max();
  /// A step passes one cell into the next; it takes about 10 n multiply-adds per term of the
  /// system.
  std::uint64_t most_steps = std::numeric_limits<std::uint64_t>::max();
  const std::atomic<bool>* stop = nullptr;  ///< set: the search ends soon, interrupted
  std::function<void(const CellSearchProgress&)> progress;  ///< called every few thousand steps
};

struct CellSearch {
  CellSearchEnd end = CellSearchEnd::complete;
  std::optional<MixedSubdivision> subdivision;  ///< where complete
  std::uint64_t steps = 0;                      ///< of all liftings and word lengths tried
};

/// The mixed cells for a lifting that follows from the seed.
CellSearch mixed_cells(const std::vector<Support>& supports, std::uint64_t seed,
                       const CellSearchOptions& options = {});

/// The mixed cells for this lifting; `seed` affects only how they are found.
CellSearch mixed_cells_of_lifting(const std::vector<Support>& supports, const Lifting& lifting,
                                  std::uint64_t seed, const CellSearchOptions& options = {});

}  // namespace moivre
