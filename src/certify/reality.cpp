// SPDX-License-Identifier: MIT
// Imaginary parts of midpoints that are sums of doubles, rounded to the safe side.
#include "reality.h"

#include <cmath>

#include "upward.h"

namespace moivre {
namespace {

/// The midpoint's imaginary part lies between these two.
struct ImaginarySize {
  double least, most;
};

ImaginarySize imaginary_size(const Certificate& c, std::size_t j) {
  const double leading = std::abs(c.midpoint[j].imag());
  double rest = 0;
  for (const Point& part : c.finer) rest += std::abs(part[j].imag());
  rest = c.finer.empty() ? 0 : raised(rest);
  return {leading - raised(rest + leading * kUnitRoundoff), raised(leading + rest)};
}

}  // namespace

Reality reality_of(const Certificate& c, bool real_system) {
  bool conjugate_inside = real_system;
  for (std::size_t j = 0; j < c.midpoint.size(); ++j) {
    const ImaginarySize size = imaginary_size(c, j);
    if (size.least > c.error[j]) return Reality::not_real;
    // |conj(x*) - m| <= |conj(x*) - conj(m)| + |conj(m) - m|.
    conjugate_inside = conjugate_inside && raised(2 * size.most + c.error[j]) < c.radius[j];
  }
  return conjugate_inside ? Reality::real : Reality::unknown;
}

}  // namespace moivre
