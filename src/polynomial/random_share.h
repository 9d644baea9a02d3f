// SPDX-License-Identifier: MIT
// A random rational that is neither negligible nor large: +-a, a in [1/2, 3/2], of few bits.
// Private to the module.
#pragma once

#include <cmath>
#include <cstdint>

#include "moivre/numeric/random.h"
#include "moivre/numeric/rational.h"

namespace moivre {

/// A multiple of 2^-bits; bits < 60.
inline Rational random_share(std::uint64_t seed, RandomStream stream, std::uint64_t index,
                             int bits) {
  const std::uint64_t one = std::uint64_t{1} << bits;
  const std::uint64_t random = random_bits(seed, stream, index);
  const auto size = static_cast<std::int64_t>(one / 2 + (random >> 1) % (one + 1));
  return {(random & 1) != 0 ? size : -size, static_cast<std::int64_t>(one)};
}

}  // namespace moivre
