// SPDX-License-Identifier: MIT
// How is a family learned? A random complex member is solved like any other system, and its regular
// roots are kept.
//
//   p*_j = s_j r_j e^{i phi_j},  r_j in [1/2, 3/2], phi_j at random from the seed;  s_j: the
//                                typical size of p_j
//
// Throws std::invalid_argument, before any tracking, when names are unknown or occur twice, or when
// the number of equations is not that of the other names. A set `stop` ends the solve; what it has
// found is kept, and the learning is not complete.
#pragma once

#include "moivre/family/family.h"

namespace moivre {

/// A name of the system, and the size that values of it typically have.
struct NamedParameter {
  std::string name;
  double size = 1;
};

/// The system with the parameters behind the unknowns, each in the order given; nothing is learned
/// yet.
Family unlearned_family(const System& system, const std::vector<NamedParameter>& parameters);

/// p* of a seed.
Point generic_member(const Family& family, std::uint64_t seed);

/// The family with its roots. options: of the solve.
Family learn(Family unlearned, const Tracker& tracker, const SolveOptions& options = {},
             const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
