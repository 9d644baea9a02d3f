// SPDX-License-Identifier: MIT
// Fill, estimated for each linear equation and each unknown of it.
#include "elimination_pivot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace moivre::elimination {
namespace {

/// A substitution is not even tried when its estimated fill leaves this multiple of the terms at
/// hand: an n x n factorization saved can never pay for it.
constexpr double kHopelessFill = 32;
/// Small systems may grow to this many terms in a trial all the same.
constexpr double kCheapTrial = 1000;

/// Number of monomials of degree at most d in n unknowns: what a dense polynomial has.
double dense_terms(double n, double d) {
  return std::exp(std::lgamma(n + d + 1) - std::lgamma(n + 1) - std::lgamma(d + 1));
}

/// Of a form of `length` terms: its power e has C(length + e - 1, e). Each is counted once.
class PowerTerms {
 public:
  explicit PowerTerms(double length) : length_(length) {}

  double of(std::uint32_t exponent) {
    if (length_ == 0) return 0;
    const auto [known, is_new] = terms_.try_emplace(exponent);
    if (is_new) known->second = dense_terms(length_ - 1, exponent);
    return known->second;
  }

 private:
  double length_;
  std::map<std::uint32_t, double> terms_;
};

/// Of each row: so many terms more a dense polynomial of its degree has.
std::vector<double> rooms(const State& s, double unknowns) {
  std::map<std::uint64_t, double> most;  // terms, by degree
  std::vector<double> result;
  for (const Row& row : s.rows) {
    const auto [known, is_new] = most.try_emplace(row.equation->degree);
    if (is_new) known->second = dense_terms(unknowns, static_cast<double>(known->first));
    result.push_back(known->second - static_cast<double>(row.equation->p.terms.size()));
  }
  return result;
}

/// New terms when the unknown becomes a form everywhere but in row `without`, `powers` those of
/// that form; in no row more than there is room for.
double estimated_fill(const State& s, const Census& census, std::uint32_t variable,
                      std::size_t without, PowerTerms& powers, const std::vector<double>& room) {
  double fill = 0;
  for (const auto& [i, first] : census.of(variable)) {
    if (i == without) continue;
    const RowFacts& equation = *s.rows[i].equation;
    double grown = 0;
    for (std::size_t k = first; k < equation.occurrences.size(); ++k) {
      const Occurrence& o = equation.occurrences[k];
      if (o.variable != variable) break;
      grown += o.count * (powers.of(o.exponent) - 1);
    }
    fill += std::min(grown, room[i]);
  }
  return fill - static_cast<double>(s.rows[without].p().terms.size());
}

}  // namespace

std::optional<Pivot> choose_pivot(const State& s, const Census& census,
                                  const std::set<std::size_t>& refused, const Limits& limits) {
  std::optional<Pivot> best;
  double terms = 0;
  for (const Row& row : s.rows) terms += static_cast<double>(row.p().terms.size());
  const std::vector<double> room = rooms(s, unknowns_left(s) - 1);
  double shrinks = 0;  // what all rows lose where nothing grows
  for (const double terms_more : room) shrinks += std::min(0.0, terms_more);
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    if (s.rows[i].degree() != 1 || refused.count(s.rows[i].origin) != 0) continue;
    if (limits.is_over()) return std::nullopt;
    const auto terms_here = static_cast<double>(s.rows[i].p().terms.size());
    const double least = terms_here > 1 ? shrinks - std::min(0.0, room[i]) - terms_here
                                        : -std::numeric_limits<double>::infinity();
    PowerTerms powers(terms_here - 1);
    for (const Divisor& d : s.rows[i].equation->divisors) {
      // Its fill is no less than that: in dense linear equations hardly any has to be estimated.
      if (best && std::tie(best->fill, d.size_log2) <= std::tie(least, best->size_log2)) continue;
      const double fill = estimated_fill(s, census, d.variable, i, powers, room);
      if (fill > kHopelessFill * terms + kCheapTrial) continue;
      if (!best || fill < best->fill || (fill == best->fill && d.size_log2 > best->size_log2)) {
        best = Pivot{i, d.variable, fill, d.size_log2};
      }
    }
  }
  return best;
}

}  // namespace moivre::elimination
