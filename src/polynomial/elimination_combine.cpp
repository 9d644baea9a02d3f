// SPDX-License-Identifier: MIT
// Highest parts that depend on each other, modulo a prime first.
#include "elimination_combine.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "elimination_words.h"
#include "modular_rank.h"

namespace moivre::elimination {
namespace {

/// Takes out equations without unknowns.
void settle_constants(State& s) {
  for (const Row& row : s.rows) {
    if (row.p().terms.empty()) {
      s.dependent.push_back(row.origin);
    } else if (row.degree() == 0 && !s.contradiction) {
      s.contradiction = row.origin;
    }
  }
  std::erase_if(s.rows, [](const Row& row) { return row.degree() == 0; });
}

/// The rows of one degree, the sparsest first: they become the pivots.
std::vector<std::size_t> rows_of_degree(const State& s, std::uint64_t d) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    if (s.rows[i].degree() == d) places.push_back(i);
  }
  std::stable_sort(places.begin(), places.end(), [&s](std::size_t a, std::size_t b) {
    return s.rows[a].p().terms.size() < s.rows[b].p().terms.size();
  });
  return places;
}

/// Gaussian elimination on the monomials of degree d. A row whose highest part vanishes is replaced
/// by its combination; the others stay as they are (their reduced copies are only the tools).
void combine_degree(State& s, std::uint64_t d, const Limits& limits) {
  const std::vector<std::size_t> places = rows_of_degree(s, d);
  std::vector<const IntegerPolynomial*> originals;
  for (std::size_t i : places) originals.push_back(&s.rows[i].p());
  if (modular_rank(originals, d, limits.stop) == places.size()) {
    s.independent.insert(d);
    return;
  }

  std::vector<IntegerPolynomial> pivots;  // each with a leading monomial the later ones lack
  for (std::size_t i : places) {
    if (limits.is_over()) return;
    IntegerPolynomial p = s.rows[i].p();
    for (const IntegerPolynomial& pivot : pivots) {
      p = without_monomial(p, pivot, pivot.terms.begin()->first);
    }
    if (bit_length(p) > limits.bits) continue;
    if (degree(p) == d && !p.terms.empty()) {
      const Monomial leading = p.terms.begin()->first;
      pivots.push_back(with_real_coefficient(p, leading));
    } else {
      s.rows[i].equation = facts_of_row(std::move(p), limits);
      s.independent.erase(s.rows[i].degree());
    }
  }
}

}  // namespace

void combine(State& s, const Limits& limits) {
  settle_constants(s);
  const std::vector<std::uint64_t> before = degrees_of(s.rows);
  std::set<std::uint64_t, std::greater<>> pending(before.begin(), before.end());
  while (!pending.empty()) {
    const std::uint64_t d = *pending.begin();
    pending.erase(pending.begin());
    if (s.independent.contains(d)) continue;
    combine_degree(s, d, limits);
    for (const Row& row : s.rows) {
      if (row.degree() < d && row.degree() > 0) pending.insert(row.degree());
    }
  }
  const std::vector<std::uint64_t> after = degrees_of(s.rows);
  settle_constants(s);
  if (before != after) {
    s.combinations.push_back(told_combination(before, after, degrees_of(s.rows)));
  }
}

}  // namespace moivre::elimination
