// SPDX-License-Identifier: MIT
// What does one equation tell of its last unknown, above each of many partial roots? a x + b = 0, a
// and b of known values: x, solved exactly.
//
// Edges: a or b that cancelled is zero. Where a vanishes there is no x, and where b does too any x
// is one.
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/closures/stages.h"
#include "moivre/formulation/block_structure.h"
#include "moivre/polynomial/system.h"
#include "shared_above.h"

namespace moivre {

class LoneEquation {
 public:
  /// Whether the block is one equation, and of degree 1 in its unknown whatever the values before.
  static bool is_one(const System& all, const Block& block);

  /// `block`: as is_one() says; `all` must outlive it.
  LoneEquation(const System& all, const Block& block);

  struct Answer {
    KnownValue x;          ///< null: there is none, or any is one
    bool is_free = false;  ///< any is one
  };
  /// All other variables of the equation are known.
  const Answer& above(const PartialRoot& root);

 private:
  Answer solved(const PartialRoot& root) const;

  const Polynomial& equation_;
  std::vector<std::uint32_t> place_;  ///< of all variables: 0
  double size_ = 0;                   ///< of its largest coefficient
  SharedAbove<Answer> answers_;
};

}  // namespace moivre
