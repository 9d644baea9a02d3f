// SPDX-License-Identifier: MIT
// Which sign has a polynomial at a root that is known to its accuracy only?
//
// Each number stands with a bound on its error: x_j + d_j, |d_j| <= accuracy max(1, |x|_inf), or
// the radius of a cluster. Products and sums carry the bound along,
//
//   (a + da)(b + db):  |a| |db| + |da| |b| + |da| |db| + u |a b|,     u: a rounding,
//
// so the true value at the true root lies within it. The sign is unknown where that holds 0.
#pragma once

#include "moivre/solver/solve.h"

namespace moivre {

enum class Sign { positive, negative, unknown };

/// p: real coefficients. The root is real.
Sign sign_at(const Polynomial& p, const Solution& root);

}  // namespace moivre
