// SPDX-License-Identifier: MIT
// Is a certified root real? Its enclosure's conjugate lies in the ball, or some imaginary part
// cannot vanish, or neither.
#pragma once

#include "moivre/certify/certificate.h"

namespace moivre {

/// Requires a certificate that holds a root. real_system: every coefficient of F is real.
Reality reality_of(const Certificate& c, bool real_system);

}  // namespace moivre
