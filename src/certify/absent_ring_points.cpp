// SPDX-License-Identifier: MIT
// Roots by exact algebra where the program was built without Arb: none is found.
#include "moivre/certify/ring_points.h"

namespace moivre {

bool are_multiplicities(const std::vector<RingPoint>&, std::uint64_t) { return false; }

std::optional<std::vector<RingPoint>> ring_points(const System&, const RingPointsOptions&) {
  return std::nullopt;
}

}  // namespace moivre
