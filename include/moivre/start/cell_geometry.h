// SPDX-License-Identifier: MIT
// Where does a mixed cell lie? Its inner normal, and by how much every other term of the supports
// clears it.
//
//   alpha: the rational solution of <alpha, b_i - a_i> = omega(a_i) - omega(b_i), i = 1..n, for the
//   edges {a_i, b_i};
//   w_ik = omega_ik + <alpha, a_ik> - omega(a_i) - <alpha, a_i>: 0 at the ends of edge i, > 0 at
//   all other terms.
//
// In the toric homotopy with x_j = y_j s^{alpha_j} term k of equation i carries the factor
// s^{w_ik}. Everything is computed in exact integers from the cell's edges, independently of the
// search that found it; doubles are the exact values rounded once.
// Edges: a cell of volume 0, or edges that do not fit the supports: std::invalid_argument.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "moivre/numeric/rational.h"
#include "moivre/start/mixed_cells.h"

namespace moivre {

/// V: row i = b_i - a_i, a_i the first term of edge i; row by row.
std::vector<std::int64_t> edge_matrix(const MixedSubdivision& subdivision, const MixedCell& cell);

/// alpha, n rationals.
std::vector<Rational> inner_normal(const MixedSubdivision& subdivision, const MixedCell& cell);

/// w_ik, concatenated over the supports in the order of their terms.
std::vector<Rational> exact_cell_weights(const MixedSubdivision& subdivision,
                                         const MixedCell& cell);

/// w_ik as doubles, in the same order.
std::vector<double> cell_weights(const MixedSubdivision& subdivision, const MixedCell& cell);

/// The least of the weights that are not 0; infinity where there is none.
double least_positive_weight(std::span<const double> weights);

}  // namespace moivre
