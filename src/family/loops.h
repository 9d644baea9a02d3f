// SPDX-License-Identifier: MIT
// Where do roots of one member go when it becomes another? Followed together; and all that loops of members lead to.
//
// Private to the module.
#pragma once

#include "moivre/family/monodromy.h"

namespace moivre {

/// Where each root at `from` arrives at `to`; nullopt where its path broke off, or ends at no regular root.
std::vector<std::optional<Point>> follow_roots(const System& system, const Point& from,
                                               const Point& to, const std::vector<Point>& roots,
                                               const Tracker& tracker,
                                               const std::atomic<bool>& stop);

/// Adds to `roots`, at `base`, all that loops lead to. sizes: of the random members. Returns how many loops were gone round.
int go_round_loops(const System& system, const Point& base, const std::vector<double>& sizes,
                   const Tracker& tracker, const MonodromyOptions& options,
                   std::uint64_t first_number, const std::atomic<bool>& stop,
                   std::vector<Point>& roots);

/// Whether the point is among the roots, relative to its size.
bool is_among(const std::vector<Point>& roots, const Point& x);

}  // namespace moivre
