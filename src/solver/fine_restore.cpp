// SPDX-License-Identifier: MIT
// A root of R to the digits of its certificate, and the eliminated unknowns from these.
#include "fine_restore.h"

#include "moivre/certify/certificate.h"

namespace moivre {

std::optional<Point> FineRestorer::restored(const Point& homogeneous) {
  const Prepared& prepared = setting_.prepared;
  const Reduction& reduction = prepared.reduction;
  if (reduction.substitutions.empty()) return std::nullopt;
  if (!prover_) {
    prover_.emplace(certify_program(reduction.system, setting_.options), kFarthestRoot, most_bits_);
  }
  const auto root = prover_->prove(to_reduced(prepared, homogeneous));
  if (!root) return std::nullopt;
  std::vector<ComplexDoubleDouble> y(root->midpoint.begin(), root->midpoint.end());
  for (const Point& part : root->finer) {
    for (std::size_t j = 0; j < y.size(); ++j) y[j] += ComplexDoubleDouble(part[j]);
  }
  Point x;
  for (const auto& xi : restore(reduction, y, to_complex_double_double))
    x.push_back(to_complex(xi));
  return x;
}

}  // namespace moivre
