// SPDX-License-Identifier: MIT
// The block, its point, and the equations of higher degree at it.
#include "elimination_block.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "lifting.h"

namespace moivre::elimination {
namespace {

// Where fewer coefficients are not zero substitutions keep to these.
constexpr std::size_t kDenseShare = 8;
constexpr std::size_t kWord = std::numeric_limits<std::uint64_t>::digits;

bool is_real_and_exact(const IntegerPolynomial& p) {
  return p.errors.empty() && std::all_of(p.terms.begin(), p.terms.end(),
                                         [](const auto& term) { return term.second.im.is_zero(); });
}

struct Block {
  std::vector<LinearEquation> equations;
  std::vector<std::uint32_t> variables;  ///< of each place
};

LinearEquation equation_of(const IntegerPolynomial& p,
                           std::map<std::uint32_t, std::size_t>& places) {
  LinearEquation equation;
  for (const auto& [m, c] : p.terms) {
    if (m.empty()) {
      equation.right = -c.re;
    } else {
      const auto place = places.try_emplace(m.front().variable, places.size()).first;
      equation.terms.emplace_back(place->second, c.re);
    }
  }
  return equation;
}

Block block_of(const State& s) {
  Block block;
  std::map<std::uint32_t, std::size_t> places;
  for (const Row& row : s.rows) {
    if (row.degree() == 1) block.equations.push_back(equation_of(row.p(), places));
  }
  block.variables.resize(places.size());
  for (const auto& [variable, place] : places) block.variables[place] = variable;
  return block;
}

}  // namespace

bool has_long_block(const State& s) {
  std::size_t size = 0, terms = 0;
  for (const Row& row : s.rows) {
    if (row.degree() != 1) continue;
    ++size;
    terms += row.p().terms.size();
  }
  if (kDenseShare * terms < size * size) return false;
  std::vector<bool> is_held(s.is_eliminated.size());
  std::size_t longest = 0;
  for (const Row& row : s.rows) {
    if (row.degree() != 1) continue;
    if (!is_real_and_exact(row.p())) return false;
    for (const auto& [m, c] : row.p().terms) longest = std::max(longest, bit_length(c.re));
    for (const Occurrence& o : row.equation->occurrences) is_held[o.variable] = true;
  }
  const auto unknowns = static_cast<std::size_t>(std::count(is_held.begin(), is_held.end(), true));
  return longest > kWord && unknowns == size;
}

void substitute_block(State& s, const Limits& limits) {
  const Block block = block_of(s);
  const auto point = lifted_solution(block.equations, limits.stop);
  if (!point) return;

  std::vector<AffineForm> forms;
  for (std::size_t j = 0; j < block.variables.size(); ++j) {
    forms.push_back({block.variables[j], {}, point->denominator, {}});
    const Integer& numerator = point->numerators[j];
    if (!numerator.is_zero()) forms.back().terms[Monomial{}] = {numerator, 0};
  }
  std::vector<Row> left;
  for (const Row& row : s.rows) {
    if (row.degree() == 1) continue;
    IntegerPolynomial p = row.p();
    for (const AffineForm& form : forms) {
      if (limits.is_over()) return;
      p = substituted(p, form);
      if (bit_length(p) > limits.bits) return;
    }
    left.push_back({facts_of_row(std::move(p), limits), row.origin});
  }
  s.rows = std::move(left);
  s.independent.clear();
  for (const AffineForm& form : forms) {
    s.is_eliminated[form.variable] = true;
    s.substitutions.push_back(to_substitution(form));
  }
}

}  // namespace moivre::elimination
