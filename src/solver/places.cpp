// SPDX-License-Identifier: MIT
// Exact sums of doubles brought back to the unknowns that were eliminated; certificates tell places
// from roots that are known.
#include "places.h"

#include <algorithm>
#include <limits>

#include "clusters.h"
#include "ends.h"

namespace moivre {
namespace {

Coefficient exact(Complex z) { return {Rational(z.real()), Rational(z.imag())}; }

/// A number as a sum of doubles, largest first.
std::vector<Complex> parts_of(Coefficient z, std::size_t count) {
  std::vector<Complex> parts;
  while (parts.size() < count) {
    parts.push_back(to_complex(z));
    z = z - exact(parts.back());
  }
  return parts;
}

}  // namespace

Coefficient exact_sum(Complex first, std::span<const Complex> others) {
  Coefficient sum = exact(first);
  for (const Complex& part : others) sum = sum + exact(part);
  return sum;
}

Place place_of(const Reduction& reduction, const std::vector<std::vector<Complex>>& coordinates) {
  std::vector<Coefficient> y;
  std::size_t count = 1;
  for (const auto& parts : coordinates) {
    y.push_back(exact_sum(parts.front(), std::span(parts).subspan(1)));
    count = std::max(count, parts.size());
  }
  const auto x = restore(reduction, y, [](const Coefficient& c) { return c; });
  Place place{Point(x.size()), std::vector<Point>(count - 1, Point(x.size()))};
  for (std::size_t j = 0; j < x.size(); ++j) {
    const std::vector<Complex> parts = parts_of(x[j], count);
    place.x[j] = parts.front();
    for (std::size_t k = 1; k < parts.size(); ++k) place.finer[k - 1][j] = parts[k];
  }
  return place;
}

std::vector<ProvedPlace> free_places(const Run& run, std::vector<ProvedPlace> places) {
  std::erase_if(places, [&](const ProvedPlace& place) {
    return place.certificate && is_held(run, *place.certificate);
  });
  return places;
}

void enter_place(Run& run, Refiner& refiner, std::uint64_t path, const ProvedPlace& place) {
  Root root;
  if (place.certificate) {
    root = proved_root(refiner, place.certificate);
  } else {
    root.point = refiner.keep(place.place.x, std::numeric_limits<double>::epsilon(), 1);
    root.point.accuracy = std::numeric_limits<double>::epsilon();
    root.is_exact = true;
  }
  if (run.table.is_seen_at(path, place.place.x)) {
    run.table.enter_root(path, std::move(root));
  } else {
    run.table.enter_by_count(path, std::move(root));
  }
}

}  // namespace moivre
