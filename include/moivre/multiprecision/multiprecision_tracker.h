// SPDX-License-Identifier: MIT
// How is a path followed to a root that double-double cannot part from its neighbours? As
// tracker/fine_tracker.h says, in a hundred digits or in three hundred.
//
// m roots within d of each other need about m log10(1/d) digits: to part them, their polynomial has
// to be known to d^m.
// Not supported: more digits, since 1 - t, a double, ends at 1e-308.
#pragma once

#include <array>
#include <memory>

#include "moivre/tracker/tracker.h"

namespace moivre {

/// Decimal digits in which paths can be followed.
inline constexpr std::array kTrackedDigits{100, 300};

/// digits: one of kTrackedDigits, else std::invalid_argument.
std::unique_ptr<Tracker> make_multiprecision_tracker(int digits);

}  // namespace moivre
