// SPDX-License-Identifier: MIT
// How is a number rounded so that it can only become larger? Computed to nearest, then raised by
// more than was lost.
//
// A formula of sums, products and quotients of nonnegative numbers loses at most 2u of its value an
// operation, u = 2^-53, and where it falls below the smallest normal number 2^-1075 an operation
// besides. `raised` adds 2^-44 of the value and 2^-1060:
// enough for 2^8 operations of the first kind and 2^14 of the second. Longer sums are raised as
// they grow. No rounding mode is changed; "to nearest" is required. NaN stays NaN, so that no
// comparison holds.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "moivre/numeric/complex.h"

namespace moivre {

static_assert(std::numeric_limits<double>::is_iec559, "error bounds are those of IEEE 754");

inline constexpr double kUnitRoundoff = 0x1p-53;
inline constexpr double kRaise = 1 + 0x1p-44;
inline constexpr double kUnderflow = 0x1p-1060;

inline double raised(double x) { return x * kRaise + kUnderflow; }

/// |a| <= larger part + (sqrt(2) - 1) smaller part, at most 8 per cent too large; no square that
/// could underflow. Of zero it is zero: numbers below the smallest normal one make every product
/// with them slow, and matrices are full of zeros.
inline double size_bound(double re, double im) {
  constexpr double kChord = 0.4142135623730951;  // sqrt(2) - 1, rounded up
  const double x = std::abs(re);
  const double y = std::abs(im);
  const double sum = x + y;  // NaN where one of them is
  const double larger = std::max(x, y);
  return sum == 0 ? 0 : raised(larger + kChord * (sum - larger));
}
inline double size_bound(const Complex& a) { return size_bound(a.real(), a.imag()); }

}  // namespace moivre
