// SPDX-License-Identifier: MIT
// How are the tolerances of a body's points read? One for all of them, one a point, or one a
// coordinate.
//
//   [body.crank]             tolerance = 0.02
//   [body.crank.tolerances]  A = 0.01          or A = [0.01, 0]
// They stand in Mechanism::tolerances by the names of dimensions (dimensions.h).
#pragma once

#include "read_parts.h"

namespace moivre {

/// `in`: the body's table; the body has its points already.
void read_point_tolerances(Reading& reading, const toml::table& in, const Body& body,
                           Mechanism& mechanism);

}  // namespace moivre
