// SPDX-License-Identifier: MIT
// What are the largest and the smallest singular value of A, without all the others?
//
// A = Q R; Lanczos on R^T R has the largest one, on its inverse the smallest, each with all vectors kept orthogonal, until the value
// stands still. A QR and a few triangular solves, where an SVD turns every pair of columns several times.
// Edges: min(m, n) values count; an exactly singular R, or no standstill, hands over to the SVD.
// Source: [GolubVanLoan13], ch. 10.
#pragma once

#include <Eigen/Core>

namespace moivre {

struct ExtremeSingularValues {
  double largest = 0;
  double smallest = 0;
};

/// A not empty, finite.
ExtremeSingularValues extreme_singular_values(const Eigen::MatrixXd& A);

}  // namespace moivre
