// SPDX-License-Identifier: MIT
// What do all threads share that certify roots of one system? Its tape, and its coefficients as discs around doubles.
#pragma once

#include <vector>

#include "ball.h"
#include "moivre/certify/certifier.h"
#include "moivre/polynomial/tape.h"

namespace moivre {

class CertifyProgram {
 public:
  /// Requires a square F.
  explicit CertifyProgram(const System& f);

  std::size_t dimension() const { return tape.variables; }

  System system;
  bool real = false;  ///< every coefficient is
  Tape tape;
  /// In the tape's order; NaN where no double is near.
  std::vector<CoefficientBall<Complex>> coefficients;
  std::vector<CoefficientBall<ComplexDoubleDouble>> fine_coefficients;
};

}  // namespace moivre
