// SPDX-License-Identifier: MIT
// Exact presolve: combinations of lower degree, and linear equations substituted away.
#include "moivre/polynomial/eliminate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>

#include "integer_polynomial.h"
#include "modular_rank.h"
#include "moivre/polynomial/scale.h"

namespace moivre {
namespace {

/// A substitution is not even tried when its estimated fill leaves this multiple of the terms at
/// hand: an n x n factorization saved can never pay for it.
constexpr double kHopelessFill = 32;
/// Small systems may grow to this many terms in a trial all the same.
constexpr double kCheapTrial = 1000;

/// So many terms of an equation hold the unknown to this power.
struct Occurrence {
  std::uint32_t variable = 0;
  std::uint32_t exponent = 0;
  double count = 0;
};

/// An unknown that a linear equation may be solved for.
struct Divisor {
  std::uint32_t variable = 0;
  double size_log2 = 0;  ///< beside the largest one of the equation
};

/// An equation, and what is asked of it again and again.
struct RowFacts {
  IntegerPolynomial p;
  std::uint64_t degree = 0;
  double work = 0;                      // of its terms
  std::vector<Occurrence> occurrences;  // by unknown, then by exponent
  std::vector<Divisor> divisors;        // of a linear equation
};

/// An equation on its way; `origin` is its number in the file. States share what they have in
/// common.
struct Row {
  std::shared_ptr<const RowFacts> equation;
  std::size_t origin = 0;

  const IntegerPolynomial& p() const { return equation->p; }
  std::uint64_t degree() const { return equation->degree; }
};

struct State {
  std::vector<Row> rows;
  std::vector<bool> is_eliminated;  // one for each unknown
  std::vector<Substitution> substitutions;
  std::vector<Omission> combinations;
  std::vector<std::size_t> dependent;        // origins of the equations that became 0 = 0
  std::optional<std::size_t> contradiction;  // origin of the one that became c = 0
  std::set<std::uint64_t> independent;       // degrees whose highest parts are known to be so
};

/// What does not change from move to move.
struct Limits {
  std::size_t bits = 0;
  std::vector<int> variable_log2;  // sizes of the unknowns, for the choice of pivots
  const std::atomic<bool>* stop = nullptr;

  bool is_over() const { return stop != nullptr && stop->load(std::memory_order_relaxed); }
};

// ---- sizes and work ----

/// Number of equations of each degree.
using DegreeCount = std::map<std::uint64_t, std::size_t>;

DegreeCount count_degrees(const std::vector<std::uint64_t>& degrees) {
  DegreeCount count;
  for (std::uint64_t d : degrees) ++count[d];
  return count;
}

/// What `a` holds more than `b`.
DegreeCount difference(DegreeCount a, const DegreeCount& b) {
  for (const auto& [d, count] : b) {
    const auto at = a.find(d);
    if (at != a.end()) at->second -= std::min(at->second, count);
  }
  std::erase_if(a, [](const auto& entry) { return entry.second == 0; });
  return a;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  return text;
}

std::string degree_name(std::uint64_t d) {
  static const std::array<std::string, 5> names{"constant", "linear", "quadratic", "cubic",
                                                "quartic"};
  return d < names.size() ? names[d] : std::string("degree-").append(std::to_string(d));
}

/// "3 quadratic and 1 linear"
std::string to_text(const DegreeCount& count) {
  std::vector<std::string> parts;
  for (auto at = count.rbegin(); at != count.rend(); ++at) {
    parts.push_back(std::to_string(at->second).append(" ").append(degree_name(at->first)));
  }
  return joined(parts);
}

bool is_single(const DegreeCount& count) { return count.size() == 1 && count.begin()->second == 1; }

std::string total_degree_text(const std::vector<std::uint64_t>& degrees) {
  const auto total = total_degree(degrees);
  return total ? std::to_string(*total) : "over 64 bits";
}

std::vector<std::uint64_t> degrees_of(const std::vector<Row>& rows) {
  std::vector<std::uint64_t> result;
  for (const Row& row : rows) result.push_back(row.degree());
  return result;
}

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

double work_of(const Monomial& m) { return 1 + static_cast<double>(m.size()); }

/// log2 of (paths times the work of a step): what the state promises to cost.
double log2_promise(const State& s) {
  Work work;
  double paths_log2 = 0;
  for (const Row& row : s.rows) {
    if (row.degree() > 1) paths_log2 += std::log2(static_cast<double>(row.degree()));
    work.terms += row.equation->work;
  }
  work.unknowns =
      static_cast<double>(std::count(s.is_eliminated.begin(), s.is_eliminated.end(), false));
  return paths_log2 + std::log2(std::max(total(work), 1.0));
}

// ---- equations ----

double log2_size(const GaussianInteger& c, int shift) {
  return log2_size(Coefficient{ratio(c.re), ratio(c.im)}) + shift;
}

/// The unknowns of a linear equation that are large enough to divide by.
std::vector<Divisor> divisors_of(const IntegerPolynomial& p, const Limits& limits) {
  std::vector<Divisor> divisors;
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& [m, c] : p.terms) {
    if (m.empty()) continue;
    const std::uint32_t variable = m.front().variable;
    divisors.push_back({variable, log2_size(c, limits.variable_log2[variable])});
    largest = std::max(largest, divisors.back().size_log2);
  }
  std::erase_if(divisors, [largest](const Divisor& d) {
    return d.size_log2 < largest + std::log2(kPivotThreshold);
  });
  for (Divisor& d : divisors) d.size_log2 -= largest;
  return divisors;
}

std::vector<Occurrence> occurrences_in(const IntegerPolynomial& p) {
  std::vector<Occurrence> all;
  for (const auto& [m, c] : p.terms) {
    for (const Power& power : m) all.push_back({power.variable, power.exponent, 1});
  }
  const auto place = [](const Occurrence& o) { return std::pair(o.variable, o.exponent); };
  std::sort(all.begin(), all.end(),
            [&](const Occurrence& a, const Occurrence& b) { return place(a) < place(b); });
  std::vector<Occurrence> counted;
  for (const Occurrence& o : all) {
    if (!counted.empty() && place(counted.back()) == place(o)) {
      counted.back().count += 1;
    } else {
      counted.push_back(o);
    }
  }
  return counted;
}

std::shared_ptr<const RowFacts> facts_of_row(IntegerPolynomial p, const Limits& limits) {
  auto equation = std::make_shared<RowFacts>();
  equation->degree = degree(p);
  for (const auto& [m, c] : p.terms) equation->work += work_of(m);
  equation->occurrences = occurrences_in(p);
  if (equation->degree == 1) equation->divisors = divisors_of(p, limits);
  equation->p = std::move(p);
  return equation;
}

// ---- combine ----

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
  if (modular_rank(originals, d) == places.size()) {
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
    const DegreeCount lost = difference(count_degrees(before), count_degrees(after));
    const DegreeCount gained = difference(count_degrees(after), count_degrees(before));
    s.combinations.push_back(
        {to_text(lost) + (is_single(lost) ? " equation" : " equations") + " combined to " +
             to_text(gained) + (is_single(gained) ? " one" : " ones"),
         "their highest terms cancel: total degree " + total_degree_text(before) + " -> " +
             total_degree_text(degrees_of(s.rows))});
  }
}

// ---- substitute ----

/// x_variable from row `row`, at an estimated number of new terms.
struct Pivot {
  std::size_t row = 0;
  std::uint32_t variable = 0;
  double fill = 0;
  double size_log2 = 0;
};

/// Number of monomials of degree at most d in n unknowns: what a dense polynomial has.
double dense_terms(double n, double d) {
  return std::exp(std::lgamma(n + d + 1) - std::lgamma(n + 1) - std::lgamma(d + 1));
}

/// For each unknown the rows that hold it, ascending, and where in their occurrences it begins.
class Census {
 public:
  struct Place {
    std::size_t row = 0;
    std::size_t first = 0;
  };

  explicit Census(const State& s) : begin_(s.is_eliminated.size() + 1) {
    const auto visit = [&s](const auto& take) {
      for (std::size_t i = 0; i < s.rows.size(); ++i) {
        const auto& occurrences = s.rows[i].equation->occurrences;
        for (std::size_t k = 0; k < occurrences.size(); ++k) {
          const std::uint32_t v = occurrences[k].variable;
          if (k == 0 || occurrences[k - 1].variable != v) take(v, Place{i, k});
        }
      }
    };
    visit([this](std::uint32_t v, const Place&) { ++begin_[v + 1]; });
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    places_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    visit([&](std::uint32_t v, const Place& place) { places_[next[v]++] = place; });
  }

  std::span<const Place> of(std::uint32_t variable) const {
    return std::span(places_).subspan(begin_[variable], begin_[variable + 1] - begin_[variable]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<Place> places_;
};

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
  std::vector<double> result;
  for (const Row& row : s.rows) {
    result.push_back(dense_terms(unknowns, static_cast<double>(row.equation->degree)) -
                     static_cast<double>(row.equation->p.terms.size()));
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

/// The pivot of least fill; among equals the largest, then the first. `refused` holds origins. None
/// where the search is over.
std::optional<Pivot> choose_pivot(const State& s, const Census& census,
                                  const std::set<std::size_t>& refused, const Limits& limits) {
  const auto unknowns =
      static_cast<double>(std::count(s.is_eliminated.begin(), s.is_eliminated.end(), false));
  std::optional<Pivot> best;
  double terms = 0;
  for (const Row& row : s.rows) terms += static_cast<double>(row.p().terms.size());
  const std::vector<double> room = rooms(s, unknowns - 1);
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    if (s.rows[i].degree() != 1 || refused.count(s.rows[i].origin) != 0) continue;
    if (limits.is_over()) return std::nullopt;
    PowerTerms powers(static_cast<double>(s.rows[i].p().terms.size()) - 1);
    for (const Divisor& d : s.rows[i].equation->divisors) {
      const double fill = estimated_fill(s, census, d.variable, i, powers, room);
      if (fill > kHopelessFill * terms + kCheapTrial) continue;
      if (!best || fill < best->fill || (fill == best->fill && d.size_log2 > best->size_log2)) {
        best = Pivot{i, d.variable, fill, d.size_log2};
      }
    }
  }
  return best;
}

Substitution to_substitution(const AffineForm& form) {
  Substitution result;
  result.variable = form.variable;
  for (const auto& [m, c] : form.terms) {
    const Coefficient value{ratio(c.re, form.divisor), ratio(c.im, form.divisor)};
    if (m.empty()) {
      result.constant = value;
    } else {
      result.terms.emplace_back(m.front().variable, value);
    }
  }
  return result;
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

// ---- the way through, and its account ----

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
  while (!s.contradiction && !limits.is_over()) {
    const Census census(s);
    const std::optional<Pivot> pivot = choose_pivot(s, census, refused, limits);
    if (!pivot) break;
    if (!substitute(s, *pivot, census, limits)) {
      refused.insert(s.rows[pivot->row].origin);
      continue;
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

std::vector<bool> appears(const System& f) {
  std::vector<bool> result(f.variables.size(), false);
  for (const Polynomial& p : f.polynomials) {
    for (const Term& term : p.terms) {
      for (const Power& power : term.monomial) result[power.variable] = true;
    }
  }
  return result;
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

std::vector<Omission> account(const State& s, const System& reduced, const System& f) {
  std::vector<Omission> sentences = s.combinations;
  std::vector<std::string> names;
  for (const Substitution& substitution : s.substitutions) {
    names.push_back(f.variables[substitution.variable]);
  }
  if (names.size() == 1) {
    sentences.push_back({names[0] + " eliminated", "a linear equation gives it"});
  } else if (!names.empty()) {
    sentences.push_back({joined(names) + " eliminated",
                         std::to_string(names.size()) + " linear equations give them"});
  }
  for (std::size_t origin : s.dependent) {
    sentences.push_back({"equation " + std::to_string(origin + 1),
                         "it follows from the others (0 = 0): it is redundant"});
  }
  if (s.contradiction) {
    sentences.push_back({"all paths", "equation " + std::to_string(*s.contradiction + 1) +
                                          " contradicts the others: no root"});
  }
  const std::vector<bool> used = appears(reduced);
  for (std::size_t j = 0; j < used.size(); ++j) {
    if (!used[j]) sentences.push_back({reduced.variables[j], "no remaining equation contains it"});
  }
  const std::vector<std::uint64_t> left = degrees(reduced);
  const auto linear = std::count(left.begin(), left.end(), std::uint64_t{1});
  if (linear > 0 && !s.contradiction) {
    sentences.push_back(
        {"the elimination of " + std::to_string(linear) +
             (linear == 1 ? " linear equation" : " linear equations"),
         "substitution would make the other equations longer than an unknown fewer is worth"});
  }
  return sentences;
}

}  // namespace

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
