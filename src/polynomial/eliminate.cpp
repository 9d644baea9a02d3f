// SPDX-License-Identifier: MIT
// Exact presolve: combinations of lower degree, and linear equations substituted away.
#include "moivre/polynomial/eliminate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "elimination_block.h"
#include "elimination_combine.h"
#include "elimination_pivot.h"
#include "elimination_state.h"
#include "elimination_words.h"
#include "moivre/polynomial/integer_polynomial.h"
#include "moivre/polynomial/scale.h"

namespace moivre::elimination {
namespace {

/// The groups of the unknowns that are left, by their new places.
std::vector<VariableGroup> groups_left(const State& s, const std::vector<VariableGroup>& groups,
                                       const std::vector<std::uint32_t>& place) {
  std::vector<VariableGroup> left;
  for (const VariableGroup& group : groups) {
    VariableGroup rest{{}, group.is_homogeneous};
    for (const std::uint32_t v : group.variables) {
      if (!s.is_eliminated[v]) rest.variables.push_back(place[v]);
    }
    if (!rest.variables.empty()) left.push_back(std::move(rest));
  }
  return left;
}

System to_system(const State& s, const System& given) {
  System f;
  std::vector<std::uint32_t> place(given.variables.size(), 0);
  for (std::size_t j = 0; j < given.variables.size(); ++j) {
    if (s.is_eliminated[j]) continue;
    place[j] = static_cast<std::uint32_t>(f.variables.size());
    f.variables.push_back(given.variables[j]);
  }
  f.groups = groups_left(s, given.groups, place);
  f.is_exact = given.is_exact;
  for (const Row& row : s.rows) {
    Polynomial p = to_polynomial(row.p());
    for (Term& term : p.terms) {
      for (Power& power : term.monomial) power.variable = place[power.variable];
    }
    f.polynomials.push_back(std::move(p));
  }
  return f;
}

/// Multiply-adds of value and gradient of the terms, and the dimension: what a tracker's step
/// costs.
struct Work {
  double terms = 0;
  double unknowns = 0;
};

/// Weights fitted to the time of a step of the CVODE tracker
/// (docs/decisions/0003-when-elimination-pays.md).
double total(const Work& work) {
  constexpr double kTermWeight = 1;
  constexpr double kUnknownWeight = 150;
  const double n = work.unknowns;
  return kTermWeight * work.terms + n * n * n / 3 + 2 * n * n + kUnknownWeight * n;
}

/// log2 of (paths times the work of a step): what the state promises to cost.
double log2_promise(const State& s) {
  Work work;
  double paths_log2 = 0;
  for (const Row& row : s.rows) {
    if (row.degree() > 1) paths_log2 += std::log2(static_cast<double>(row.degree()));
    work.terms += row.equation->work;
  }
  work.unknowns = unknowns_left(s);
  return paths_log2 + std::log2(std::max(total(work), 1.0));
}

/// False, and nothing changed, where a coefficient would grow beyond the limit.
bool substitute(State& s, const Pivot& pivot, const Census& census, const Limits& limits) {
  const Monomial unknown{{pivot.variable, 1}};
  const AffineForm form =
      form_of(with_real_coefficient(s.rows[pivot.row].p(), unknown), pivot.variable);
  std::vector<std::pair<std::size_t, std::shared_ptr<const RowFacts>>> changed;
  for (const auto& [i, first] : census.of(pivot.variable)) {
    if (i == pivot.row) continue;
    if (limits.is_over()) return false;
    IntegerPolynomial p = substituted(s.rows[i].p(), form);
    if (bit_length(p) > limits.bits) return false;
    changed.emplace_back(i, facts_of_row(std::move(p), limits));
  }
  for (auto& [i, equation] : changed) {
    // Of independent linear equations those left are independent: a step of Gaussian elimination.
    const bool was_linear = s.rows[i].degree() == 1;
    if (!was_linear || equation->degree != 1) s.independent.erase(equation->degree);
    s.rows[i].equation = std::move(equation);
  }
  s.rows.erase(s.rows.begin() + static_cast<std::ptrdiff_t>(pivot.row));
  s.is_eliminated[pivot.variable] = true;
  s.substitutions.push_back(to_substitution(form));
  return true;
}

/// Absolute errors of the coefficients of p.
TermErrors to_term_errors(const Polynomial& p, const std::vector<NumberErrors>& relative) {
  TermErrors errors;
  for (std::size_t k = 0; k < relative.size(); ++k) {
    if (relative[k].empty()) continue;
    add(errors[p.terms[k].monomial], to_complex(p.terms[k].coefficient), relative[k]);
  }
  return errors;
}

std::vector<IntegerPolynomial> integers_of(const System& f) {
  std::vector<IntegerPolynomial> result;
  const CoefficientErrors errors = coefficient_errors(f);
  for (std::size_t i = 0; i < f.polynomials.size(); ++i) {
    result.push_back(to_integer(f.polynomials[i]));
    if (!errors.empty()) result.back().errors = to_term_errors(f.polynomials[i], errors[i]);
  }
  return result;
}

State start(const System& f, std::vector<IntegerPolynomial> equations, const Limits& limits) {
  State s;
  for (std::size_t i = 0; i < equations.size(); ++i) {
    s.rows.push_back({facts_of_row(std::move(equations[i]), limits), i});
  }
  s.is_eliminated.assign(f.variables.size(), false);
  return s;
}

/// Relative to the coefficients. What leaves double's range is not told.
CoefficientErrors errors_left(const State& s) {
  CoefficientErrors errors;
  bool is_exact = true;
  for (const Row& row : s.rows) {
    std::vector<NumberErrors>& own = errors.emplace_back();
    for (const auto& [m, c] : row.p().terms) {
      own.emplace_back();
      const auto found = row.p().errors.find(m);
      if (found == row.p().errors.end()) continue;
      add(own.back(), 1.0 / value_of(row.p(), c), found->second);
      if (!std::isfinite(bound(own.back()))) own.back().clear();
      is_exact = is_exact && own.back().empty();
    }
  }
  return is_exact ? CoefficientErrors{} : errors;
}

Limits choose_limits(const System& f, const std::vector<IntegerPolynomial>& equations,
                     const std::atomic<bool>* stop) {
  std::size_t longest = 1;
  for (const IntegerPolynomial& p : equations) longest = std::max(longest, bit_length(p));
  const std::size_t grown = std::clamp(kBitGrowth * longest, kShortInteger, kLongestInteger);
  return {std::max(longest, grown), choose_scaling(f).variable_log2, stop};
}

/// How to come back to a state after more moves: lists only grow, and rows are shared.
struct Mark {
  std::vector<Row> rows;
  std::size_t substitutions = 0, combinations = 0, dependent = 0;
  std::optional<std::size_t> contradiction;
};

Mark mark_of(const State& s) {
  return {s.rows, s.substitutions.size(), s.combinations.size(), s.dependent.size(),
          s.contradiction};
}

State back_to(const Mark& mark, State s) {
  for (std::size_t k = mark.substitutions; k < s.substitutions.size(); ++k) {
    s.is_eliminated[s.substitutions[k].variable] = false;
  }
  s.rows = mark.rows;
  s.substitutions.resize(mark.substitutions);
  s.combinations.resize(mark.combinations);
  s.dependent.resize(mark.dependent);
  s.contradiction = mark.contradiction;
  return s;
}

bool answers_more(const State& a, const Mark& b) {
  return a.contradiction.has_value() != b.contradiction.has_value() ||
         a.dependent.size() > b.dependent;
}

/// The state of least promised work on the way to the last possible substitution, or to a stop. A
/// state that shows a contradiction or a dependence is always kept.
State least_work(State s, const Limits& limits) {
  combine(s, limits);
  Mark best = mark_of(s);
  double least = log2_promise(s);
  std::set<std::size_t> refused;
  bool is_block_tried = false;
  while (!s.contradiction && !limits.is_over()) {
    if (!is_block_tried && has_long_block(s)) {
      is_block_tried = true;
      substitute_block(s, limits);
    } else {
      const Census census(s);
      const std::optional<Pivot> pivot = choose_pivot(s, census, refused, limits);
      if (!pivot) break;
      if (!substitute(s, *pivot, census, limits)) {
        refused.insert(s.rows[pivot->row].origin);
        continue;
      }
    }
    combine(s, limits);
    const double promise = log2_promise(s);
    if (promise <= least || answers_more(s, best)) {
      best = mark_of(s);
      least = promise;
    }
  }
  return back_to(best, std::move(s));
}

Reduction::Verdict judge(const State& s, const System& reduced, const System& f) {
  using enum Reduction::Verdict;
  if (s.contradiction) return inconsistent;
  const std::vector<bool> used = appears(reduced);
  const std::size_t equations = reduced.polynomials.size();
  const std::size_t unknowns = reduced.variables.size();
  if (f.polynomials.size() < f.variables.size()) return underdetermined;
  if (equations < unknowns || std::find(used.begin(), used.end(), false) != used.end()) {
    return dependent;
  }
  if (equations > unknowns) return overdetermined;
  return unknowns == 0 ? solved : square;
}

Reduction reduction_of(const System& f, const std::atomic<bool>* stop) {
  std::vector<IntegerPolynomial> equations = integers_of(f);
  const Limits limits = choose_limits(f, equations, stop);
  const State last = least_work(start(f, std::move(equations), limits), limits);

  Reduction result;
  result.system = to_system(last, f);
  result.errors = errors_left(last);
  result.verdict = judge(last, result.system, f);
  for (std::size_t j = 0; j < last.is_eliminated.size(); ++j) {
    if (!last.is_eliminated[j]) result.kept.push_back(j);
  }
  for (const Row& row : last.rows) result.equation_origin.push_back(row.origin);
  result.substitutions = last.substitutions;
  result.dependent_equations = last.dependent.size();
  result.left_out = account(last, result.system, f);
  return result;
}

}  // namespace
}  // namespace moivre::elimination

namespace moivre {

std::string to_string(Reduction::Verdict verdict) {
  using enum Reduction::Verdict;
  switch (verdict) {
    case square:
      return "square";
    case solved:
      return "solved";
    case inconsistent:
      return "inconsistent";
    case dependent:
      return "dependent";
    case underdetermined:
      return "underdetermined";
    case overdetermined:
      return "overdetermined";
  }
  return "unknown";
}

Reduction eliminate(const System& f, const std::atomic<bool>* stop) {
  return elimination::reduction_of(f, stop);
}

std::vector<std::complex<double>> restore(const Reduction& reduction,
                                          const std::vector<std::complex<double>>& y) {
  return restore(reduction, y, [](const Coefficient& c) { return to_complex(c); });
}

std::vector<Complex> kept_of(const Reduction& reduction, const std::vector<Complex>& x) {
  std::vector<Complex> y;
  for (const std::size_t place : reduction.kept) y.push_back(x[place]);
  enter_isotropic(reduction.isotropic, y);
  return y;
}

Reduction in_isotropic(Reduction reduction, const std::vector<IsotropicPair>& pairs) {
  reduction.errors = errors_in_isotropic(reduction.system, reduction.errors, pairs);
  reduction.system = in_isotropic(reduction.system, pairs);
  reduction.isotropic = pairs;
  return reduction;
}

}  // namespace moivre
