// SPDX-License-Identifier: MIT
// How is a system written in projective space? One more coordinate, x_0, makes every term of an
// equation one degree.
//
//   F^h_i(x_0, x) = x_0^{d_i} F_i(x / x_0);  x_0 is the *last* variable, index n.  x_0 = 0 is
//                                            infinity.
// Terms keep F's order, so that what is known of term k of F is known of term k of F^h.
#pragma once

#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

/// F homogenized to the given degrees, d_i >= degree(F_i) (std::invalid_argument otherwise).
System homogenize(const System& f, const std::vector<std::uint64_t>& degrees);

}  // namespace moivre
