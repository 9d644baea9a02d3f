// SPDX-License-Identifier: MIT
// Random liftings as a function of (seed, purpose, attempt).
#include "random_lifting.h"

#include "moivre/numeric/random.h"

namespace moivre {

Lifting random_lifting(const std::vector<std::size_t>& sizes, std::uint64_t seed,
                       LiftingPurpose purpose, std::uint64_t attempt) {
  // Terms are counted in the lower 48 bits of the index.
  const std::uint64_t purposes = 4;
  std::uint64_t index = (attempt * purposes + static_cast<std::uint64_t>(purpose)) << 48;
  Lifting lifting;
  for (const std::size_t size : sizes) {
    std::vector<std::int64_t>& block = lifting.emplace_back(size);
    for (std::int64_t& omega : block) {
      const std::uint64_t bits = random_bits(seed, RandomStream::lifting, index++);
      omega = static_cast<std::int64_t>(bits >> (64 - kLiftingBits));
    }
  }
  return lifting;
}

}  // namespace moivre
