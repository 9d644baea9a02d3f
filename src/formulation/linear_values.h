// SPDX-License-Identifier: MIT
// Which polynomials have one value in every closure, by the linear equations alone?
//
// Gauss-Jordan elimination of lengths by the equations of degree 1, exact; then t u = 1 for every
// pair of directions.
// Edges: a coefficient of rounding relative to those of the polynomial counts as zero, since axes
// are typed in decimals.
// Not supported: values that follow from equations of higher degree, or from sums of directions.
#pragma once

#include <optional>

#include "moivre/formulation/formulation.h"

namespace moivre {

class LinearValues {
 public:
  explicit LinearValues(const Formulation& formulation);

  /// The value of p at every root; nothing where the linear equations leave it open.
  std::optional<Complex> value(const Polynomial& p) const;

 private:
  void add(const Polynomial& equation);
  Polynomial substituted(const Polynomial& p) const;
  Monomial without_pairs(Monomial m) const;

  const Formulation& formulation_;
  std::vector<std::optional<Polynomial>>
      solved_;  ///< what each length is, in variables that are left
};

}  // namespace moivre
