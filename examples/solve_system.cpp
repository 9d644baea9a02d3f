// SPDX-License-Identifier: MIT
// The smallest whole program: where do a circle and a hyperbola meet?
#include <iostream>

#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

int main() {
  const moivre::System system = moivre::read_system({"two curves", "x^2 + y^2 - 4; x*y - 1;"});
  const auto tracker = moivre::make_cvode_tracker();
  const moivre::SolveResult result = moivre::solve(system, *tracker);

  std::cout << result.paths.tracked << " paths, " << result.solutions.size() << " roots\n";
  for (const moivre::Solution& root : result.solutions) {
    std::cout << "x = " << root.x[0] << ", y = " << root.x[1] << (root.real ? "  real\n" : "\n");
  }
  return result.complete ? 0 : 2;
}
