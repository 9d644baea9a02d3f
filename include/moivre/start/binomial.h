// SPDX-License-Identifier: MIT
// What are the roots of a system of binomials g_a x^a + g_b x^b = 0? As many as |det V|, each
// computed from its number.
//
//   x^{v_i} = beta_i = -g_{a_i} / g_{b_i}, v_i = b_i - a_i the rows of V;
//   log x = V^{-1} (log beta + 2 pi i k), k in Z^n up to V Z^n: De Moivre's theorem in n variables.
//   The classes of Z^n / V Z^n are counted by the diagonal h of the column Hermite form of V: 0 <=
//   k_i < h_i, h_1 ... h_n = |det V|; root number = k_1 + h_1 (k_2 + h_2 (k_3 + ...)).
//
// Angles are fractions of a turn in 64 binary digits, so that overflow reduces them modulo a whole
// turn. adj(V) and det V are exact integers. So whatever the size of the entries, the computation
// adds an error of only n 2^-64 turns to that of the angles of beta. Roots are never stored. x
// itself may leave the range of double; log x does not.
// Edges: det V = 0 or a coefficient 0: std::invalid_argument; |det V| of 2^63 or more:
// std::overflow_error.
// Sources: [Cohen93, algorithm 2.4.8] (Hermite form modulo the determinant); [HuberSturmfels95].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/start/mixed_cells.h"

namespace moivre {

/// x^{v_i} = beta_i with V taken apart.
struct BinomialSystem {
  std::uint64_t roots = 1;           ///< |det V|
  std::vector<std::uint64_t> radix;  ///< h_i
  std::vector<std::uint64_t>
      steps;  ///< n x n: k_j moves arg x_i by steps[i n + j] / roots of a turn
  std::vector<std::uint64_t> turns;  ///< arg x_i of root 0, in units of 2^-64 turns
  std::vector<double> log_modulus;   ///< log |x_i|, the same for all roots
};

/// `exponents`: V, n x n row by row, entries of any sign.
BinomialSystem binomial_system(std::span<const std::int64_t> exponents,
                               std::span<const Complex> beta);

/// The binomial system of a cell; `coefficients`: g of every term, concatenated over the supports.
BinomialSystem binomial_system(const MixedSubdivision& subdivision, const MixedCell& cell,
                               std::span<const Complex> coefficients);

/// x of root `number`, 0 <= number < roots.
Point binomial_root(const BinomialSystem& system, std::uint64_t number);

/// log x, imaginary parts in [-pi, pi).
Point binomial_root_logarithm(const BinomialSystem& system, std::uint64_t number);

}  // namespace moivre
