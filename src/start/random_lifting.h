// SPDX-License-Identifier: MIT
// Which lifting belongs to a seed? Independent uniform integers of 30 bits, for each purpose and
// attempt others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "moivre/start/mixed_cells.h"

namespace moivre {

/// Long enough that ties are rare, short enough that slacks of common systems stay within 64 bits.
inline constexpr int kLiftingBits = 30;

/// Liftings tried before the search gives up. A million cells of a hundred terms have a tie once in
/// ten liftings.
inline constexpr std::uint64_t kMostLiftings = 16;

enum class LiftingPurpose : std::uint64_t { terms, ties, corners, corner_ties };

/// Numbers in [0, 2^30), sizes[i] of them for block i.
Lifting random_lifting(const std::vector<std::size_t>& sizes, std::uint64_t seed,
                       LiftingPurpose purpose, std::uint64_t attempt = 0);

}  // namespace moivre
