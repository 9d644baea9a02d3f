// SPDX-License-Identifier: MIT
// A root of R to the digits of its certificate, the eliminated unknowns from these, and the root of
// F there.
#include "fine_restore.h"

#include <algorithm>

#include "moivre/certify/certificate.h"

namespace moivre {
namespace {

// Coordinates of one root differ by rounding, each by a share of itself.
constexpr double kSame = 1e-6;

bool is_same(const Point& y, const Point& other) {
  return std::equal(y.begin(), y.end(), other.begin(), [](const Complex& a, const Complex& b) {
    return std::abs(a - b) <= kSame * std::abs(a);
  });
}

Point restored(const Reduction& reduction, const Certificate& root) {
  std::vector<ComplexDoubleDouble> y(root.midpoint.begin(), root.midpoint.end());
  for (const Point& part : root.finer) {
    for (std::size_t j = 0; j < y.size(); ++j) y[j] += ComplexDoubleDouble(part[j]);
  }
  Point x;
  for (const auto& xi : restore(reduction, y, to_complex_double_double))
    x.push_back(to_complex(xi));
  return x;
}

}  // namespace

std::shared_ptr<const Certificate> FineRestorer::proved(Prover& prover, const Point& homogeneous) {
  const Reduction& reduction = setting_.prepared.reduction;
  if (reduction.substitutions.empty()) return nullptr;
  if (!reduced_prover_) {
    reduced_prover_.emplace(make_certify_program(reduction.system), kFarthestRoot, most_bits_);
  }
  const Point end = to_reduced(setting_.prepared, homogeneous);
  const auto of_reduced = reduced_prover_->prove(end);
  if (!of_reduced || !is_same(end, of_reduced->midpoint)) return nullptr;
  auto root = prover.prove(restored(reduction, *of_reduced));
  const bool is_it = root && is_same(end, kept_of(reduction, root->midpoint));
  return is_it ? std::move(root) : nullptr;
}

}  // namespace moivre
