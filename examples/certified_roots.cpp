// SPDX-License-Identifier: MIT
// Which real positive roots are proved? Certified ones alone, and whether there can be no others.
#include <iostream>

#include "moivre/moivre.h"

int main() {
  // Steady states with a Hill term, as people write them.
  const moivre::System f = moivre::read_system({"toggle", "4/(1 + y^2) = x; 4/(1 + x^2) = y;"});
  const auto tracker = moivre::make_cvode_tracker();
  moivre::SolveResult result = moivre::solve(f, *tracker);
  moivre::keep_wanted({.positive = true}, result);

  for (const moivre::Solution& root : result.solutions) {
    if (root.certified != true) continue;
    std::cout << "x = " << root.x[0].real() << ", y = " << root.x[1].real() << " within "
              << (root.accuracy < 1e-12 ? "1e-12" : "more") << '\n';
  }
  std::cout << "all roots: " << to_string(*result.completeness) << ", " << result.filtered
            << " not positive\n";
}
