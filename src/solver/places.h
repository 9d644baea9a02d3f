// SPDX-License-Identifier: MIT
// Roots that algebra knows without a path: where are they on the system as given, which of them has
// no path, and which paths are free to have them? Private to the module.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "moivre/certify/certificate.h"
#include "run.h"

namespace moivre {

/// Of the system as given, all unknowns.
struct Place {
  Point x;
  std::vector<Point> finer;  ///< what is to be added to it, largest first
};

/// By coordinate of the system that is tracked; each is the sum of its parts, largest first.
Place place_of(const Reduction& reduction, const std::vector<std::vector<Complex>>& coordinates);

struct ProvedPlace {
  Place place;
  std::shared_ptr<const Certificate> certificate;  ///< of a simple root
  std::uint64_t multiplicity = 1;
};

/// Those that no path is proved to end at.
std::vector<ProvedPlace> free_places(const Run& run, std::vector<ProvedPlace> places);

/// The paths whose ends are not proved, each with the last that was seen of it.
std::vector<std::pair<std::uint64_t, Point>> paths_in_doubt(const Run& run);

/// The path ends there.
void enter_place(Run& run, Refiner& refiner, std::uint64_t path, const ProvedPlace& place);

}  // namespace moivre
