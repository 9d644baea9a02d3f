// SPDX-License-Identifier: MIT
// How many isolated roots can a square system have, by everything that is proved beforehand?
//
//   Bezout             d_1 d_2 ... d_n of what exact elimination leaves (polynomial/eliminate.h, which keeps the roots)
//   multihomogeneous   the least number of the partitions tried (start/multihomogeneous.h) [MorganSommese87]
//   stable mixed volume   of the monomials (start/mixed_volume.h) [HuberSturmfels97]; it counts only where two liftings with
//                      nothing in common give the same sum, since the cells that were found are a lower bound by themselves
//
// Each bounds the isolated roots in C^n, counted with multiplicity. As many certified roots, pairwise distinct, are all of
// them. Mixed cells are looked for with a bounded number of steps. Edges: elimination alone may tell the number of isolated
// roots: one bound then, `elimination`. Not supported: systems that are not square; bounds beyond 64 bits have no value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

enum class BoundKind { elimination, bezout, multihomogeneous, stable_mixed_volume };
/// "elimination", "Bezout", "multihomogeneous", "stable mixed volume".
std::string to_string(BoundKind kind);

struct RootBound {
  BoundKind kind = BoundKind::bezout;
  std::optional<std::uint64_t> value;
  std::string missing;  ///< the reason, where there is no value
};

/// Bounds in the order of their cost, until one is as small as `enough`: a number of roots that are known, so that no bound
/// can be below it. Throws std::invalid_argument when F is not square.
std::vector<RootBound> root_bounds(const System& f, std::uint64_t enough);

/// Two counts that starts have; nullopt beyond 64 bits, or beyond a bounded search.
struct StructureCounts {
  std::optional<std::uint64_t> multihomogeneous;  ///< the least found
  bool is_least = false;                          ///< all partitions were tried
  std::optional<std::uint64_t> mixed_volume;      ///< with a constant added to each equation
};
/// Of a square system without zero polynomials (std::invalid_argument); `multihomogeneous` is sought only where wanted, and so
/// is the mixed volume.
StructureCounts structure_counts(const System& f, bool with_partitions, bool with_cells);

}  // namespace moivre
