// SPDX-License-Identifier: MIT
// How many closures has each mechanism of problems/mechanisms, by who published or counted them,
// and how few paths find them?
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace moivre {

struct PublishedCount {
  std::string file;
  std::optional<double> driver_deg;  ///< the first driver starts there instead
  std::uint64_t complex;
  std::uint64_t real;
  std::uint64_t most_paths;  ///< over all stages
};

inline const std::vector<PublishedCount>& published_counts() {
  static const std::vector<PublishedCount> counts{
      {"slider-crank", {}, 2, 2, 2},
      {"slider-crank-equations", {}, 2, 2, 2},
      {"four-bar", {}, 2, 2, 2},
      {"five-bar", {}, 2, 2, 2},
      {"watt-1", {}, 4, 4, 6},
      {"stephenson-3", {}, 4, 4, 6},
      {"3-rpr", {}, 6, 6, 16},
      {"assur-7-quaternary", {}, 18, 8, 64},
      {"assur-7-serial", {}, 16, 10, 64},
      {"jansen-leg", 0.0, 8, 8, 14},
      {"jansen-leg", 90.0, 8, 8, 14},
      {"jansen-leg", 180.0, 8, 6, 14},
      {"jansen-leg", 270.0, 8, 8, 14},
      {"double-parallel-crank", {}, 1, 1, 2},
      {"redundant-system", {}, 2, 2, 2},
      {"redundant-system", 60.0, 2, 2, 2},
      {"scotch-yoke", {}, 1, 1, 1},
      {"inverted-slider-crank", {}, 2, 2, 2},
      {"whitworth", {}, 4, 2, 6},
      {"gear-five-bar", {}, 2, 2, 2},
      {"belt-five-bar", {}, 2, 2, 2},
      {"cam-valve", {}, 2, 2, 3},
      {"crane", {}, 4, 4, 6},
      {"rack-steering", {}, 4, 4, 7},
      {"rack-crank", {}, 2, 2, 2},
      {"parallelogram", {}, 1, 1, 2},
      {"unassemblable-triangle", {}, 2, 0, 2},
  };
  return counts;
}

/// "jansen-leg at 90 deg"
inline std::string name_of(const PublishedCount& count) {
  if (!count.driver_deg) return count.file;
  return count.file + " at " + std::to_string(static_cast<int>(*count.driver_deg)) + " deg";
}

}  // namespace moivre
