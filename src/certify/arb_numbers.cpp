// SPDX-License-Identifier: MIT
// Limbs of 64 bits, and arithmetic without rounding.
#include "arb_numbers.h"

#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

namespace moivre {

static_assert(sizeof(ulong) == sizeof(std::uint64_t), "FLINT's limbs have 64 bits");

void set(fmpz_t result, const Integer& value) {
  std::vector<std::uint64_t> limbs;
  export_bits(abs(value), std::back_inserter(limbs), 64, false);  // least significant first
  fmpz_set_ui_array(result, limbs.data(), static_cast<slong>(limbs.size()));
  if (value < 0) fmpz_neg(result, result);
}

void add_exactly(arb_t sum, double value) {
  arf_t term;
  arf_init_set_ui(term, 0);
  arf_set_d(term, value);
  arb_add_arf(sum, sum, term, ARF_PREC_EXACT);
  arf_clear(term);
}

double take_double(arb_t rest) {
  const double part = arf_get_d(arb_midref(rest), ARF_RND_NEAR);
  if (std::isfinite(part)) add_exactly(rest, -part);
  return part;
}

}  // namespace moivre
