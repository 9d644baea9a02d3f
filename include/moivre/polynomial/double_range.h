// SPDX-License-Identifier: MIT
// Which equations does double hold? Those of which no coefficient rounds to infinity or, not being
// zero, to zero; and others, multiplied by a power of two.
//
// An equation says the same whatever it is multiplied by, and its coefficients are exact:
// 1e400 x^2 = 2e400 is x^2 = 2. One that double holds stays as it is. The middle of the sizes of
// another one is brought to 1, so that as much room is left above as below; where they are too far
// apart for that the largest is brought to the end of double's range, and the smallest lose digits.
//
// Not supported: units of the unknowns, which would hold x^2 = 1e-700. A root is told in the
// unknowns of the file, and double does not hold it either.
#pragma once

#include <optional>

#include "moivre/polynomial/system.h"

namespace moivre {

/// k for which double holds 2^k p, 0 where it holds p; nullopt where there is none.
std::optional<int> log2_into_double(const Polynomial& p);

/// 2^k p.
Polynomial times_power_of_two(Polynomial p, int k);

/// What is said where there is none.
inline constexpr const char* kBeyondDouble =
    "a coefficient is out of the range of double (4.9e-324 to 1.8e308), whatever the whole is "
    "multiplied by";

/// Adds p = 0 to the equations, as double holds it; false where it holds no multiple of it.
bool add_equation(Polynomial p, System& f);

/// Its equations as double holds them. Throws InvalidInput with each one of which it holds no
/// multiple.
System held_by_double(System f);
/// Its equations as they were before.
System as_typed(System f);

}  // namespace moivre
