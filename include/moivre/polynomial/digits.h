// SPDX-License-Identifier: MIT
// Which other system may a file as well mean? One whose coefficients differ by half a unit of the last digit, where they were rounded.
//
//   c = p / q:  q divides 10^k, k >= 1 least, ten or more significant digits:   c +- 0.5 10^-k; from 15 digits on at least a double's error
//               q = 2^k, k >= 40: a double, computed by a few operations:        c (1 +- 2^-49)
//               any other number, 31/10, 1/3, or a whole one, is meant as it stands
//
// What vanishes to within |c' - c| of its coefficients vanishes for some system that the file may mean. The signs are random,
// so that differences that matter do not cancel.
#pragma once

#include <optional>

#include "moivre/polynomial/system.h"

namespace moivre {

/// The same monomials as f; nullopt where no coefficient was rounded.
std::optional<System> other_reading(const System& f, std::uint64_t seed);

/// What the coefficients differ by: f's monomials, some with coefficient 0. Requires has_terms_of(f, g).
System differences(const System& f, const System& g);

/// The same variables and monomials.
bool has_terms_of(const System& f, const System& g);

}  // namespace moivre
