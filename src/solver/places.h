// SPDX-License-Identifier: MIT
// Roots that algebra knows without a path: where are they on the system as given, and which of them
// has no path? Private to the module.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "moivre/certify/certificate.h"
#include "run.h"

namespace moivre {

/// Of the system as given, all unknowns.
struct Place {
  Point x;
  std::vector<Point> finer;  ///< what is to be added to it, largest first
};

/// Without rounding.
Coefficient exact_sum(Complex first, std::span<const Complex> others);

/// By coordinate of the system that is tracked; each is the sum of its parts, largest first.
Place place_of(const Reduction& reduction, const std::vector<std::vector<Complex>>& coordinates);

struct ProvedPlace {
  Place place;
  std::shared_ptr<const Certificate> certificate;  ///< of a simple root
  std::uint64_t multiplicity = 1;
};

/// Those that no path is proved to end at.
std::vector<ProvedPlace> free_places(const Run& run, std::vector<ProvedPlace> places);

/// The path ends there.
void enter_place(Run& run, Refiner& refiner, std::uint64_t path, const ProvedPlace& place);

}  // namespace moivre
