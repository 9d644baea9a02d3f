// SPDX-License-Identifier: MIT
// Gauss-Newton on all closure polynomials.
#include "closing.h"

#include <Eigen/Core>

#include "moivre/factorization/qr.h"
#include "moivre/polynomial/tape.h"
#include "moivre/polynomial/value.h"

namespace moivre {

double residual_when_polished(const Formulation& formulation, Point root) {
  // A root's error is squared each time; beside a near miss they stand still.
  constexpr int kSteps = 4;
  const System& f = formulation.system;
  const Tape tape = make_tape(f);
  const std::vector<Complex> c = complex_coefficients(tape, f);
  Point registers(tape.register_count());
  Point value(tape.equations);
  Point entries(tape.jacobian.size());
  for (int k = 0; k < kSteps; ++k) {
    evaluate<Complex, Complex>(tape, c, root, registers, value, entries);
    // Each row by the size of its terms.
    Eigen::VectorXd scale(tape.equations);
    for (std::uint32_t i = 0; i < tape.equations; ++i) {
      const double size = term_size(f.polynomials[i], root);
      scale[i] = size > 0 ? 1 / size : 1;
    }
    Eigen::MatrixXcd J = Eigen::MatrixXcd::Zero(tape.equations, tape.variables);
    for (std::size_t e = 0; e < entries.size(); ++e) {
      J(tape.jacobian[e].row, tape.jacobian[e].column) = entries[e];
    }
    const Eigen::Map<const Eigen::VectorXcd> F(value.data(), tape.equations);
    const Eigen::VectorXcd step =
        PivotedQr<Complex>(scale.asDiagonal() * J).solve(scale.asDiagonal() * F);
    if (!step.allFinite()) break;
    Eigen::Map<Eigen::VectorXcd>(root.data(), step.size()) -= step;
  }
  return residual_of_root(formulation, root);
}

}  // namespace moivre
