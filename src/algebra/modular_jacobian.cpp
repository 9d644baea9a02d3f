// SPDX-License-Identifier: MIT
// Laplace's expansion, row after row, each minor reduced as it comes.
#include "modular_jacobian.h"

#include <algorithm>
#include <map>

namespace moivre {
namespace {

using Columns = std::uint32_t;  // a bit for each

/// By x_i.
ModularPolynomial partial_derivative(const PrimeField& field, const ModularPolynomial& p,
                                     std::size_t i) {
  ModularPolynomial result;
  for (const auto& [m, c] : p) {
    if (m.at[1 + i] == 0) continue;
    DegreeAndExponents lower = m;
    --lower.at[0];
    --lower.at[1 + i];
    result.emplace_back(lower, field.times(c, m.at[1 + i]));
  }
  std::sort(result.begin(), result.end(),
            [](const auto& a, const auto& b) { return is_smaller(b.first, a.first); });
  return result;
}

class Minors {
 public:
  Minors(const PrimeField& field, const std::vector<const ModularPolynomial*>& basis,
         TermBudget& budget)
      : field_(field), basis_(basis), budget_(budget) {}

  /// False where it is given up. The sign of the whole is nobody's concern.
  bool add_row(const std::vector<ModularPolynomial>& row) {
    std::map<Columns, ModularPolynomial> larger;
    for (const auto& [columns, minor] : minors_) {
      bool is_negative = false;  // changes with each column that stands before
      for (std::size_t j = 0; j < row.size(); ++j) {
        const Columns column = Columns{1} << j;
        if ((columns & column) != 0) {
          is_negative = !is_negative;
        } else if (!add_product(row[j], is_negative, minor, larger[columns | column])) {
          return false;
        }
      }
    }
    for (auto& [columns, minor] : larger) {
      auto rest = reduced(field_, std::move(minor), basis_, budget_);
      if (!rest) return false;
      minor = std::move(*rest);
    }
    minors_ = std::move(larger);
    return true;
  }

  const ModularPolynomial& last() const { return minors_.begin()->second; }

 private:
  bool add_product(const ModularPolynomial& p, bool is_negative, const ModularPolynomial& q,
                   ModularPolynomial& result) {
    for (const auto& [m, c] : p) {
      auto next = sum(field_, result, is_negative ? field_.minus(c) : c, m, q, budget_);
      if (!next) return false;
      result = std::move(*next);
    }
    return true;
  }

  const PrimeField& field_;
  const std::vector<const ModularPolynomial*>& basis_;
  TermBudget& budget_;
  std::map<Columns, ModularPolynomial> minors_{{0, {{DegreeAndExponents{}, 1}}}};
};

}  // namespace

std::optional<ModularPolynomial> jacobian_determinant(
    const PrimeField& field, const std::vector<ModularPolynomial>& f,
    const std::vector<const ModularPolynomial*>& basis, TermBudget& budget) {
  Minors minors(field, basis, budget);
  for (const ModularPolynomial& p : f) {
    std::vector<ModularPolynomial> row;
    for (std::size_t j = 0; j < f.size(); ++j) row.push_back(partial_derivative(field, p, j));
    if (!minors.add_row(row)) return std::nullopt;
  }
  return minors.last();
}

}  // namespace moivre
