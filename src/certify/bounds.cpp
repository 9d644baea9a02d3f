// SPDX-License-Identifier: MIT
// Bezout's number, where it may be asked for.
#include "moivre/certify/bounds.h"

#include <stdexcept>
#include <string>

namespace moivre {

std::optional<std::uint64_t> bezout_bound(const System& f) {
  if (f.polynomials.size() != f.variables.size()) {
    throw std::invalid_argument(
        "Bezout's number bounds the roots of square systems; this one has " +
        std::to_string(f.polynomials.size()) + " equations in " +
        std::to_string(f.variables.size()) + " unknowns");
  }
  return total_degree(degrees(f));
}

}  // namespace moivre
