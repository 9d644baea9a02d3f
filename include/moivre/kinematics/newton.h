// SPDX-License-Identifier: MIT
// Does Newton-Raphson assemble the mechanism from this guess? q+ = q + dq, Phi_q dq = -Phi,
// iteration by iteration.
//
// The step is solved as kinematics/linear.h chooses (or as asked): LU where Phi_q is square and
// regular, least squares where rows are redundant, weighted minimum norm where coordinates are
// free.
// Long rotation vectors are replaced by the shortest ones of the same pose, since a step from a
// long one means little.
// Edges: a cycle, divergence, a singular Phi_q and a least-squares minimum that is no solution each
// end the run with their own status. An unassemblable mechanism typically ends in no_solution or
// iteration_limit.
// Not supported: damping; the run is the textbook's.
#pragma once

#include <string>
#include <vector>

#include "moivre/kinematics/linear.h"
#include "moivre/mechanism/phi.h"

namespace moivre {

enum class NewtonStatus {
  converged,    ///< every |Phi_i| is within the tolerance of the sum of its terms' magnitudes
  diverged,     ///< q left every bound or stopped being a number
  cycling,      ///< an earlier iterate came back
  singular,     ///< Phi_q lost rank, the step has no effect, and Phi is not zero
  no_solution,  ///< the least-squares minimum was reached, Phi is not zero there
  iteration_limit
};

std::string to_string(NewtonStatus status);

struct NewtonOptions {
  double residual_tolerance = 1e-13;  ///< on scaled_residual
  int maximum_iterations = 50;
  std::vector<Eigen::Index> held;  ///< coordinates that keep their guessed values
  LinearOptions linear;            ///< weights: one per coordinate that is not held
  bool with_condition = false;     ///< NewtonResult::condition, which costs as much as the run
};

/// One row of the iteration table: the iterate and the step that leaves it.
struct NewtonIteration {
  Eigen::VectorXd q;
  double residual = 0;         ///< largest |Phi_i|
  double scaled_residual = 0;  ///< largest |Phi_i| / (sum of |terms|)
  double step = 0;             ///< largest |dq_k|; 0 in the last row
  Eigen::Index rank = 0;       ///< of Phi_q here; last row: where Newton stopped
  LinearMethod method = LinearMethod::lu;
};

struct NewtonResult {
  NewtonStatus status = NewtonStatus::iteration_limit;
  std::string message = "Newton's method was not run";
  Eigen::VectorXd q;
  std::vector<NewtonIteration> iterations;  ///< the guess first, the last iterate last
  double residual = 0;
  double scaled_residual = 0;
  Eigen::Index rank = 0;     ///< of Phi_q at q
  bool is_singular = false;  ///< rank < min(m, n) at q, or at an iterate where the run ended
  double smallest_singular_value =
      0;  ///< of Phi_q at q (of its min(m, n)), as it stands, not equilibrated
  /// Largest over smallest singular value of the equilibrated Phi_q, where it was asked for.
  double condition = 0;
  int cycle_length = 0;  ///< of a cycle that was found, else 0

  int steps() const { return static_cast<int>(iterations.size()) - 1; }
};

/// Throws std::invalid_argument when the guess has not n finite entries, or the options make no
/// sense (every broken rule).
NewtonResult newton(const Phi& phi, const Eigen::VectorXd& guess, double t = 0,
                    const NewtonOptions& options = {});

}  // namespace moivre
