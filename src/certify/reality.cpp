// SPDX-License-Identifier: MIT
// Imaginary parts of midpoints that are sums of doubles, rounded to the safe side.
#include "reality.h"

#include <algorithm>
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

struct Distance {
  double least, most;
};

/// Of the middle of `place` from the conjugate of that of `image`.
Distance distance(const Enclosure& place, const Enclosure& image) {
  const double leading = size_bound(place.middle - std::conj(image.middle));
  double rest = 0;
  for (std::size_t k = 0; k < std::max(place.finer.size(), image.finer.size()); ++k) {
    const Complex a = k < place.finer.size() ? place.finer[k] : Complex(0);
    const Complex b = k < image.finer.size() ? image.finer[k] : Complex(0);
    rest += size_bound(a - std::conj(b));
  }
  if (rest > 0) rest = raised(rest);
  // The bound of a modulus is at most 8 per cent too large.
  constexpr double kBound = 1.1;
  return {leading / kBound - rest, raised(leading + rest)};
}

}  // namespace

Reality reality_of(const Certificate& c, bool real_system) {
  bool conjugate_inside = real_system;
  for (std::size_t j = 0; j < c.midpoint.size(); ++j) {
    const ImaginarySize size = imaginary_size(c, j);
    if (size.least > c.error(j)) return Reality::not_real;
    // |conj(x*) - m| <= |conj(x*) - conj(m)| + |conj(m) - m|.
    conjugate_inside = conjugate_inside && raised(2 * size.most + c.error(j)) < c.radius(j);
  }
  return conjugate_inside ? Reality::real : Reality::unknown;
}

bool holds_zero(const Enclosure& z) {
  const Distance from_zero = distance(z, Enclosure());
  return !(from_zero.least > z.error);
}

Reality reality_of(std::span<const ProvedCoordinate> root, std::span<const std::size_t> mirror) {
  bool image_inside = true;
  for (std::size_t v = 0; v < root.size(); ++v) {
    const Enclosure& place = root[v].place;
    const Enclosure& image = root[mirror[v]].place;
    const Distance apart = distance(place, image);
    if (apart.least > raised(place.error + image.error)) return Reality::not_real;
    image_inside = image_inside && raised(apart.most + image.error) < root[v].radius;
  }
  return image_inside ? Reality::real : Reality::unknown;
}

}  // namespace moivre
