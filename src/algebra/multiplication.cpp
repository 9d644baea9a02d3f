// SPDX-License-Identifier: MIT
// Normal forms of multiples, column by column.
#include "multiplication.h"

#include <algorithm>

namespace moivre {
namespace {

/// m times the linear form.
ModularPolynomial multiple(const LeadingMonomial& m, const std::vector<Residue>& form) {
  ModularPolynomial p;
  for (std::size_t i = 0; i < form.size(); ++i) {
    LeadingMonomial larger = m;
    ++larger.at[0];
    ++larger.at[1 + i];
    p.emplace_back(larger, form[i]);
  }
  std::sort(p.begin(), p.end(),
            [](const auto& a, const auto& b) { return is_smaller(b.first, a.first); });
  return p;
}

}  // namespace

Residue product(const PrimeField& field, const Residue* a, const std::vector<Residue>& b) {
  Residue sum = 0;
  for (std::size_t j = 0; j < b.size(); ++j) sum = field.plus(sum, field.times(a[j], b[j]));
  return sum;
}

std::vector<Residue> Multiplication::times_vector(const std::vector<Residue>& x) const {
  std::vector<Residue> y;
  for (std::size_t i = 0; i < dimension_; ++i) {
    y.push_back(product(field_, &rows_[i * dimension_], x));
  }
  return y;
}

std::vector<Residue> Multiplication::vector_times(const std::vector<Residue>& l) const {
  std::vector<Residue> result(dimension_, 0);
  for (std::size_t i = 0; i < dimension_; ++i) {
    for (std::size_t j = 0; j < dimension_; ++j) {
      result[j] = field_.plus(result[j], field_.times(l[i], at(i, j)));
    }
  }
  return result;
}

std::vector<Residue> by_basis(const std::vector<LeadingMonomial>& basis,
                              const ModularPolynomial& normal_form) {
  std::vector<Residue> x(basis.size(), 0);
  for (const auto& [m, c] : normal_form) {
    const auto place = std::lower_bound(basis.begin(), basis.end(), m, is_smaller);
    x[static_cast<std::size_t>(place - basis.begin())] = c;
  }
  return x;
}

std::optional<Multiplication> multiplication_by(GroebnerBasis& ideal,
                                                const std::vector<LeadingMonomial>& basis,
                                                const std::vector<Residue>& form) {
  Multiplication result(ideal.field(), basis.size());
  for (std::size_t j = 0; j < basis.size(); ++j) {
    if (basis[j].degree() == DegreeAndExponents::kMostDegree) return std::nullopt;
    const auto image = ideal.normal_form(multiple(basis[j], form));
    if (!image) return std::nullopt;
    const std::vector<Residue> column = by_basis(basis, *image);
    for (std::size_t i = 0; i < basis.size(); ++i) result.at(i, j) = column[i];
  }
  return result;
}

}  // namespace moivre
