// SPDX-License-Identifier: MIT
// What is known of the number of a family's roots without following a path? Bounds on those of one
// generic member.
//
// A generic member has as many isolated roots as any other, or more: what bounds it bounds every
// member [SommeseWampler05, ch. 7].
#pragma once

#include <optional>

#include "moivre/bounds/root_bounds.h"
#include "moivre/family/family.h"

namespace moivre {

struct KnownCounts {
  std::optional<MetBound> met;              ///< a bound that is the number of the family's roots
  std::optional<std::uint64_t> by_algebra;  ///< all roots, with multiplicities, where asked for
};

/// p: a generic member. Once `stop` is set nothing more is found.
KnownCounts known_counts(const Family& family, const Point& p,
                         const std::atomic<bool>* stop = nullptr);

/// The roots of the member p by exact algebra alone, those without zero coordinates where the
/// family has no others; nullopt where it does not find them.
std::optional<std::uint64_t> roots_by_algebra(const Family& family, const Point& p);

}  // namespace moivre
