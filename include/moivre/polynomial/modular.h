// SPDX-License-Identifier: MIT
// Which rows modulo a prime are independent? Rows of a matrix reduced as they come. Private to the
// module.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "moivre/polynomial/prime_field.h"

namespace moivre {

/// Column and nonzero value, sorted by column.
using ModularRow = std::vector<std::pair<std::size_t, Residue>>;

/// Echelon form: every row has its first column to itself.
class ModularRows {
 public:
  explicit ModularRows(const PrimeField& field) : field_(field) {}

  /// The first column of what is left of the row beside the others; nullopt where nothing is.
  std::optional<std::size_t> add(const ModularRow& row);
  /// The row is a combination of them.
  bool span(const ModularRow& row) const { return rest_of(row).empty(); }
  std::size_t rank() const { return rank_; }

 private:
  /// Its first column is none of theirs; what comes behind may be.
  ModularRow rest_of(const ModularRow& row) const;
  /// The nonzero entries from a column on.
  ModularRow sparse(const std::vector<WideSum>& values, std::size_t first) const;

  PrimeField field_;
  std::vector<ModularRow>
      pivots_;  ///< by first column, where the value is 1; empty where there is none
  std::size_t rank_ = 0;
};

}  // namespace moivre
