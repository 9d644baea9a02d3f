// SPDX-License-Identifier: MIT
// Where should a user's own Newton solve begin? At every closure of a mechanism, or every real root
// of a system.
//
// q in the order of `names`: angles in radians, lengths in the file's unit, as Phi and the
// polynomials take them.
// Also: a system of polynomials as a typed mechanism, so that Newton-Raphson on Phi takes
// polynomial files.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "moivre/closures/closures.h"

namespace moivre {

struct InitialGuess {
  std::string id;  ///< the closure's, or the path of the root
  Eigen::VectorXd q;
};

struct InitialGuesses {
  std::vector<std::string> names;
  std::vector<InitialGuess> guesses;
};

InitialGuesses initial_guesses(const ClosureResult& result, const Mechanism& mechanism);
/// The real roots.
InitialGuesses initial_guesses(const SolveResult& result);

/// Unknown lengths with the system's names, one equation per polynomial (equation 1, 2, ...).
/// Throws std::invalid_argument when a coefficient is not real.
Mechanism typed_mechanism(const System& f);

}  // namespace moivre
