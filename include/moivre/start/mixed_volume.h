// SPDX-License-Identifier: MIT
// How many isolated roots can a sparse system have? At most its mixed volume, or its stable mixed
// volume.
//
//   mixed volume of A_1, ..., A_n: roots without zero coordinates (Bernstein); of A_i with 0 added:
//   roots in C^n [LiWang96]. Stable mixed volume: roots in C^n too, and at most as large. Lift the
//   zeros that were added by 1 and all other terms by 0; cells of this subdivision whose inner
//   normal alpha^0 has no negative coordinate are stable;
//   their mixed volumes add up to it [HuberSturmfels97]. Roots are counted with multiplicity, for
//   generic coefficients.
//
// That lifting is refined by a random one: omega = height * (1 at added zeros) + random. The
// refinement is verified, not assumed: for every cell found alpha^0 is computed exactly, with all
// slacks for the lifting 0/1 at least 0. Where one is not, the height is doubled and the search
// begins again.
//
// `verified`: if a cell were missed, the sum would be only a lower bound. So two independent
// liftings must give the same sum.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "moivre/start/mixed_cells.h"

namespace moivre {

struct MixedVolume {
  std::optional<std::uint64_t> value;           ///< where complete
  CellSearchEnd end = CellSearchEnd::complete;  ///< why not, else
  std::uint64_t steps = 0;
};

MixedVolume mixed_volume(const std::vector<Support>& supports, std::uint64_t seed,
                         const CellSearchOptions& options = {});

/// The same from two liftings. Throws std::logic_error where they differ.
MixedVolume verified_mixed_volume(const std::vector<Support>& supports, std::uint64_t seed,
                                  const CellSearchOptions& options = {});

/// The stable cells of the supports with 0 added: a subdivision as any other, its cells only the
/// stable ones, its mixed volume the stable one. The zeros added are the last terms of their
/// supports (`with_origin`).
CellSearch stable_mixed_cells(const std::vector<Support>& supports, std::uint64_t seed,
                              const CellSearchOptions& options = {});

MixedVolume stable_mixed_volume(const std::vector<Support>& supports, std::uint64_t seed,
                                const CellSearchOptions& options = {});

}  // namespace moivre
