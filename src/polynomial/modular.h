// SPDX-License-Identifier: MIT
// Exact algebra at the price of machine words: numbers modulo a prime, and rows of a matrix reduced as they come.
//
// The prime 2^61 - 31 is 1 modulo 4, so that -1 has a square root and Gaussian rationals have images. What is independent modulo
// the prime is independent; the converse, and that an image 0 comes from 0, fails with probability about 1e-18.
// Private to the module.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "integer_polynomial.h"

namespace moivre {

/// In [0, 2^61 - 31).
using Residue = std::uint64_t;

inline constexpr Residue kPrime = (Residue{1} << 61) - 31;

__extension__ using WideSum = unsigned __int128;

// 2^61 is 31 modulo the prime: a sum is folded twice, and is then less than twice the prime.
constexpr Residue reduced(WideSum a) {
  constexpr Residue kLow = (Residue{1} << 61) - 1;
  const WideSum once = (a & kLow) + 31 * (a >> 61);
  const auto twice = static_cast<Residue>(once & kLow) + 31 * static_cast<Residue>(once >> 61);
  return twice < kPrime ? twice : twice - kPrime;
}
/// So many products of residues and one residue are no more than a sum holds.
inline constexpr int kMostProducts = 63;

constexpr Residue times(Residue a, Residue b) { return reduced(WideSum{a} * b); }
constexpr Residue plus(Residue a, Residue b) { return a + b < kPrime ? a + b : a + b - kPrime; }
constexpr Residue minus(Residue a) { return a == 0 ? 0 : kPrime - a; }
/// Of a nonzero residue.
Residue inverse(Residue a);
Residue residue(const GaussianInteger& a);
/// Throws std::invalid_argument where the prime divides a denominator.
Residue residue(const Coefficient& a);
/// nullopt where the prime divides a denominator, or a nonzero number has the image 0.
std::optional<Residue> residue_if_faithful(const Coefficient& a);

/// Column and nonzero value, sorted by column.
using ModularRow = std::vector<std::pair<std::size_t, Residue>>;

/// Echelon form: every row has its first column to itself.
class ModularRows {
 public:
  /// The first column of what is left of the row beside the others; nullopt where nothing is.
  std::optional<std::size_t> add(const ModularRow& row);
  /// The row is a combination of them.
  bool span(const ModularRow& row) const { return rest_of(row).empty(); }
  std::size_t rank() const { return rank_; }

 private:
  /// Its first column is none of theirs; what comes behind may be.
  ModularRow rest_of(const ModularRow& row) const;

  std::vector<ModularRow>
      pivots_;  ///< by first column, where the value is 1; empty where there is none
  std::size_t rank_ = 0;
};

}  // namespace moivre
