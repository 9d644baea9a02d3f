// SPDX-License-Identifier: MIT
// Which points do two curves share? A system written as on paper.
#include <iostream>

#include "moivre/moivre.h"

int main() {
  const auto [x, y] = moivre::unknowns<2>();
  const moivre::System f = moivre::make_system({"x", "y"}, {pow(x, 2) + pow(y, 2) - 4, x * y - 1});
  const auto tracker = moivre::make_cvode_tracker();
  const moivre::SolveResult result = moivre::solve(f, *tracker);

  std::cout << result.solutions.size() << " roots, completeness " << to_string(*result.completeness)
            << '\n';
  for (const moivre::Solution& root : result.solutions) {
    std::cout << "x = " << root.x[0].real() << ", y = " << root.x[1].real() << '\n';
  }
  return result.complete ? 0 : 2;
}
