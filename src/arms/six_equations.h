// SPDX-License-Identifier: MIT
// What solves six linear equations of six unknowns, as Newton's method on an arm asks for
// thousands of times? Elimination whose sizes the compiler knows.
//
// Pivots tell how independent the equations are; where one is 0 there is no solution. Private to
// the module.
#pragma once

#include <array>

#include "tip.h"

namespace moivre {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

struct SixSolved {
  Velocity6<double> x;            ///< where `least` is not 0
  double least = 0, largest = 0;  ///< pivots
};

/// A x = b, rows by the largest pivot.
SixSolved solve_six(const Matrix6d& A, const Velocity6<double>& b);

/// L D L^T of a symmetric matrix without negative eigenvalues, as it stands: for these no order of
/// rows is better.
struct SixFactors {
  Matrix6d L;                     ///< below its diagonal
  std::array<double, 6> share{};  ///< 1 / pivot
  double least = 0, largest = 0;  ///< pivots; no solution unless `least` is above 0
};
SixFactors factors_of(const Matrix6d& A);
Velocity6<double> solution_of(const SixFactors& factors, const Velocity6<double>& b);

/// Both at once.
SixSolved solve_symmetric_six(const Matrix6d& A, const Velocity6<double>& b);

/// A^T A
Matrix6d gram_of(const Matrix6d& A);

}  // namespace moivre
