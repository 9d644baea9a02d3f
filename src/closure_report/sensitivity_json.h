// SPDX-License-Identifier: MIT
// What does JSON tell of the dimensions, and of a closure's sensitivity to them?
#pragma once

#include "moivre/design/sensitivity.h"
#include "moivre/report/json.h"

namespace moivre {

/// [{"name", "kind", "value", "tolerance"}], in radians and the file's unit of length.
Json dimensions_json(const Sensitivities& told);

/// Of closure number `closure`; rates in the order of the dimensions.
Json sensitivity_json(const Sensitivities& told, std::size_t closure);

}  // namespace moivre
