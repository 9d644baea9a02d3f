// SPDX-License-Identifier: MIT
// What is a Newton step with x, F and J in double-double? For roots at which J in double says nothing.
//
//   dx = -J(x)^{-1} F(x),   J v = b for other right-hand sides b with the factors of the last step
//
// x, F: n; J: n x n. A correction is handed out rounded to double, and added to x with all its digits.
// Edges: a singular J gives no step. Owns its memory; one a thread.
#pragma once

#include <span>

#include "moivre/factorization/dense_lu.h"
#include "refine.h"

namespace moivre {

class FineNewton {
 public:
  using Number = ComplexDoubleDouble;

  /// `program` must outlive it.
  explicit FineNewton(const RefinerProgram& program);

  /// Makes dx the Newton step at x. False where J is singular.
  bool correct(const std::vector<Number>& x);
  /// Makes dx the solution of J dx = b, J as in the last correct().
  void solve(std::span<const double> b);
  void add_to(std::vector<Number>& x) const;
  /// Infinity-norm condition number of J with rows of size 1; leaves dx undefined.
  double condition();

  /// dx, rounded to double.
  const Point& rounded() const { return rounded_; }

 private:
  void solve();

  const RefinerProgram& program_;
  std::size_t n_;
  std::vector<Number> registers_, value_, jacobian_;
  DenseLu<Number> lu_;
  std::vector<double> row_size_;
  std::vector<Number> dx_;
  Point rounded_;
};

}  // namespace moivre
