// SPDX-License-Identifier: MIT
// Where do the roots that I know go when the numbers change? A parameter homotopy from one's own
// start points.
#include <iostream>

#include "moivre/moivre.h"

int main() {
  const auto [x, y, a, b] = moivre::unknowns<4>();
  // At a = 5, b = 2 the roots are known: +-(1, 2) and +-(2, 1).
  const moivre::ParameterProblem problem{
      moivre::make_system({"x", "y", "a", "b"}, {x * x + y * y - a, x * y - b}),
      {"a", "b"},
      {5, 2},
      {{1.0, 2.0}, {-1.0, -2.0}, {2.0, 1.0}, {-2.0, -1.0}}};
  const auto tracker = moivre::make_cvode_tracker();
  const moivre::SolveResult result = moivre::solve(problem, {10, 3}, *tracker);
  std::cout << result.solutions.size() << " roots at a = 10, b = 3\n";

  const auto ends = moivre::track(problem, {10, 3}, *tracker);
  std::cout << "(1, 2) goes to (" << (*ends[0])[0].real() << ", " << (*ends[0])[1].real() << ")\n";
}
