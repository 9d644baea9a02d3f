// SPDX-License-Identifier: MIT
// Which family contains every system with these monomials? The one in which each coefficient is a
// parameter.
//
//   F_i(x; p) = sum_k p_ik x^{a_ik},  p_ik: named c<i>_<k>, of the size of the coefficient in
//                                     `member`
//
// A system with zero or dependent coefficients is at worst a special member. Its roots are still
// ends of paths.
#pragma once

#include <optional>

#include "moivre/family/family.h"

namespace moivre {

/// Not learned. Throws std::invalid_argument when `member` is not square, or an equation is 0.
Family coefficient_family(const System& member);

/// The parameters that make f a member; nullopt where f has other unknowns or a monomial that the
/// family has not.
std::optional<ParameterValues> coefficients_in(const Family& family, const System& f);

}  // namespace moivre
