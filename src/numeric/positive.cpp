// SPDX-License-Identifier: MIT
// A rule for each number that is not finite and above 0; NaN is not above 0.
#include "moivre/numeric/positive.h"

#include <cmath>

namespace moivre {

std::vector<std::string> not_positive(
    std::initializer_list<std::pair<const char*, double>> numbers) {
  std::vector<std::string> broken;
  for (const auto& [name, number] : numbers) {
    if (number > 0 && std::isfinite(number)) continue;
    broken.push_back(std::string(name) + " must be finite and above 0");
  }
  return broken;
}

}  // namespace moivre
