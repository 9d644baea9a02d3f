// SPDX-License-Identifier: MIT
// Where should my own Newton solve begin? At every root of a polynomial model; then Newton's method
// on the function itself.
#include <cmath>
#include <iostream>

#include "moivre/moivre.h"

int main() {
  // sin(x) = x^2 / 4 + y, x y = 1/2: sin(x) is x - x^3/6 in the model.
  const auto [x, y] = moivre::unknowns<2>();
  const moivre::System model =
      moivre::make_system({"x", "y"}, {x - pow(x, 3) / 6 - x * x / 4 - y, x * y - 0.5});
  const moivre::OwnFunction f{[](const Eigen::VectorXd& q) -> Eigen::VectorXd {
                                return Eigen::Vector2d(std::sin(q[0]) - q[0] * q[0] / 4 - q[1],
                                                       q[0] * q[1] - 0.5);
                              },
                              {},
                              2};
  const auto tracker = moivre::make_cvode_tracker();
  const moivre::SolveResult result = moivre::solve(model, *tracker);
  for (const moivre::InitialGuess& guess : moivre::initial_guesses(result).guesses) {
    const moivre::NewtonResult run = moivre::newton(f, guess.q);
    std::cout << "from (" << guess.q[0] << ", " << guess.q[1] << "): " << to_string(run.status)
              << " at (" << run.q[0] << ", " << run.q[1] << ")\n";
  }
}
