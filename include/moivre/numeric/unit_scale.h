// SPDX-License-Identifier: MIT
// By which power of two is a size brought to about 1? Nothing is rounded by it.
#pragma once

#include <algorithm>
#include <cmath>

namespace moivre {

/// Power of two that brings `size` into [1/2, 1); 1 where that is impossible.
inline double power_of_two_scale(double size) {
  if (!(size > 0) || !std::isfinite(size)) return 1;
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
}

}  // namespace moivre
