// SPDX-License-Identifier: MIT
// Which start system does the user bring along? G and one of its roots, in the variables of the
// target.
#pragma once

#include <cstdint>
#include <string>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

struct OwnStart {
  System system;  ///< variables in the order of the target's
  Point point;
  std::uint64_t points = 0;  ///< in the file
};

/// Throws std::invalid_argument when G is not in the same variables, or has no point of that
/// number.
OwnStart read_own_start(const std::string& system_file, const std::string& points_file,
                        std::uint64_t number, const System& target);

}  // namespace moivre
