// SPDX-License-Identifier: MIT
// Facts of a system, and the refusal of those that are not square.
#include "facts.h"

#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {

SystemFacts facts_of(const System& f) {
  return {f.variables, degrees(f), total_degree(degrees(f))};
}

void require_square(const System& f) {
  const std::size_t equations = f.polynomials.size();
  const std::size_t unknowns = f.variables.size();
  if (equations == unknowns) return;
  throw InvalidInput(
      "the system has " + counted(equations, "equation") + " in " + counted(unknowns, "unknown") +
      ": " +
      (equations > unknowns
           ? "it is overdetermined, and paths belong to the system that solve squares it up to"
           : "it is underdetermined: its roots form sets of dimension " +
                 std::to_string(unknowns - equations) +
                 " or more, and none is isolated. `slice` cuts them by random linear "
                 "equations"));
}

}  // namespace moivre
