// SPDX-License-Identifier: MIT
// Which reader reads which form? One each.
#pragma once

#include "moivre/check/claims.h"

namespace moivre {

Claims read_solve_json(const Source& source);
Claims read_solution_list(const Source& source, const std::vector<std::string>& variables);

}  // namespace moivre
