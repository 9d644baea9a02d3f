// SPDX-License-Identifier: MIT
// Bezout's number, where it may be asked for.
#include "moivre/certify/bounds.h"

#include <string>

#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {

std::optional<std::uint64_t> bezout_bound(const System& f) {
  if (f.polynomials.size() != f.variables.size()) {
    throw InvalidInput("Bezout's number bounds the roots of square systems; this one has " +
                       counted(f.polynomials.size(), "equation") + " in " +
                       counted(f.variables.size(), "unknown"));
  }
  return total_degree(degrees(f));
}

}  // namespace moivre
