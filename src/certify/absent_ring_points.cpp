// SPDX-License-Identifier: MIT
// Simple roots by exact algebra where the program was built without Arb: none is found.
#include "moivre/certify/ring_points.h"

namespace moivre {

std::optional<RingPoints> ring_points(const System&, const RingPointsOptions&) {
  return std::nullopt;
}

}  // namespace moivre
