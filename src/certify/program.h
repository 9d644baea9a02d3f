// SPDX-License-Identifier: MIT
// What do all threads share that certify roots of one system? Its tape, and its coefficients as
// discs around doubles.
#pragma once

#include <vector>

#include "ball.h"
#include "moivre/certify/certifier.h"
#include "moivre/polynomial/tape.h"

namespace moivre {

class CertifyProgram {
 public:
  /// Requires as many polynomials as variables that are not given.
  CertifyProgram(const System& f, std::size_t given);

  std::size_t dimension() const { return tape.variables - given; }

  System system;
  std::size_t given = 0;  ///< the last variables, numbers in discs
  bool real = false;      ///< every coefficient is, and nothing is given
  Tape tape;              ///< its Jacobian is that of the unknowns
  /// In the tape's order; NaN where no double is near.
  std::vector<CoefficientBall<Complex>> coefficients;
  std::vector<CoefficientBall<ComplexDoubleDouble>> fine_coefficients;
};

}  // namespace moivre
