// SPDX-License-Identifier: MIT
// A Groebner basis, the pair of the least common multiple first; the monomials under its staircase; a multiplication among them.
#include "moivre/polynomial/quotient_ring.h"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "modular_jacobian.h"
#include "modular_line.h"
#include "modular_polynomial.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

using Leading = DegreeAndExponents;

// In the time of a term, beside each other in memory.
constexpr std::uint64_t kMultiplicationsOfATerm = 2;

// Random numbers: coefficients of the linear form, then of two vectors. Of a form that is known beforehand a system can be made in which
// two roots have one value.
constexpr std::uint64_t kFirstOfVectors = 1000;
Residue random_residue(const PrimeField& field, std::uint64_t i) {
  return random_bits(field.seed(), RandomStream::algebra, i) % field.prime();
}

struct Pair {
  std::size_t first = 0;
  std::size_t second = 0;
  Leading lcm;
};

/// The monomials that no leading one divides.
class Staircase {
 public:
  Staircase(std::size_t n, std::vector<Leading> corners) : n_(n), corners_(std::move(corners)) {}

  /// A power of each unknown leads.
  bool is_finite() const {
    for (std::size_t i = 0; i < n_; ++i) {
      const bool is_bounded = std::any_of(corners_.begin(), corners_.end(),
                                          [i](const Leading& m) { return m.at[1 + i] == m.at[0]; });
      if (!is_bounded) return false;
    }
    return true;
  }

  /// Finite; the list ends with the budget. In ascending order.
  std::vector<Leading> monomials(TermBudget& budget) const {
    std::vector<Leading> list;
    append_multiples({}, 0, budget, list);
    std::sort(list.begin(), list.end(), is_smaller);
    return list;
  }

 private:
  /// By the unknowns from i on.
  void append_multiples(Leading m, std::size_t i, TermBudget& budget,
                        std::vector<Leading>& list) const {
    for (; !budget.is_used_up() && is_under(m); ++m.at[0], ++m.at[1 + i]) {
      budget.spend(1);
      if (i + 1 == n_) {
        list.push_back(m);
      } else {
        append_multiples(m, i + 1, budget, list);
      }
    }
  }

  bool is_under(const Leading& m) const {
    return std::none_of(corners_.begin(), corners_.end(),
                        [&](const Leading& corner) { return divides(corner, m); });
  }

  std::size_t n_;
  std::vector<Leading> corners_;
};

/// Square, by rows that are mostly full.
class Multiplication {
 public:
  Multiplication(const PrimeField& field, std::size_t dimension)
      : field_(field), dimension_(dimension), rows_(dimension * dimension) {}

  Residue& at(std::size_t i, std::size_t j) { return rows_[i * dimension_ + j]; }

  /// The degree of its minimal polynomial, each root once.
  std::uint64_t distinct_eigenvalues() const {
    std::vector<Residue> left, right;
    for (std::size_t i = 0; i < dimension_; ++i) {
      left.push_back(random_residue(field_, kFirstOfVectors + 2 * i));
      right.push_back(random_residue(field_, kFirstOfVectors + 2 * i + 1));
    }
    std::vector<Residue> sequence;
    for (std::size_t k = 0; k < 2 * dimension_; ++k) {
      sequence.push_back(product(left.data(), right));
      right = times_vector(right);
    }
    return distinct_roots(field_, minimal_polynomial(field_, sequence));
  }

 private:
  Residue product(const Residue* row, const std::vector<Residue>& x) const {
    Residue sum = 0;
    for (std::size_t j = 0; j < dimension_; ++j) sum = field_.plus(sum, field_.times(row[j], x[j]));
    return sum;
  }
  std::vector<Residue> times_vector(const std::vector<Residue>& x) const {
    std::vector<Residue> y;
    for (std::size_t i = 0; i < dimension_; ++i) y.push_back(product(&rows_[i * dimension_], x));
    return y;
  }

  const PrimeField& field_;
  std::size_t dimension_;
  std::vector<Residue> rows_;
};

class GroebnerBasis {
 public:
  GroebnerBasis(const PrimeField& field, std::size_t n, const QuotientRingOptions& options)
      : field_(field), n_(n), options_(options), budget_(options.most_terms) {}

  /// rows: n of the polynomials of the ideal, of which a simple root is to be one; none where there are not as many.
  QuotientRing of(std::vector<ModularPolynomial> f, const std::vector<ModularPolynomial>& rows) {
    std::sort(f.begin(), f.end(), [](const auto& a, const auto& b) {
      return !b.empty() && (a.empty() || is_smaller(a.front().first, b.front().first));
    });
    for (const ModularPolynomial& p : f) {
      if (!take(p)) return {};
    }
    if (!is_completed()) return {};
    QuotientRing ring = verdict();
    const bool counts_simple = ring.verdict != Verdict::not_found && !rows.empty() &&
                               (ring.verdict == Verdict::infinite || options_.counts_simple);
    if (counts_simple) ring.simple = simple_roots(rows);
    return ring;
  }

 private:
  bool is_completed() {
    while (!is_enough_ && !pairs_.empty()) {
      if (options_.stop != nullptr && *options_.stop) return false;
      const Pair pair = next_pair();
      auto s = s_polynomial(field_, elements_[pair.first], elements_[pair.second]);
      if (!s || !take(std::move(*s))) return false;
    }
    return true;
  }

  /// Of f, whose basis this is; it is then another one.
  std::optional<std::uint64_t> simple_roots(const std::vector<ModularPolynomial>& f) {
    if (n_ == DegreeAndExponents::kMostUnknowns) return std::nullopt;
    const auto determinant = jacobian_determinant(field_, f, reducers(), budget_);
    if (!determinant) return std::nullopt;
    DegreeAndExponents z;
    z.at[0] = z.at[1 + n_] = 1;
    auto inverse =
        sum(field_, {{DegreeAndExponents{}, field_.minus(1)}}, 1, z, *determinant, budget_);
    ++n_;
    options_.known = 0;
    if (!inverse || !take(std::move(*inverse)) || !is_completed()) return std::nullopt;
    const QuotientRing ring = verdict();
    if (ring.verdict != Verdict::finite) return std::nullopt;
    return ring.dimension;
  }

  using Verdict = QuotientRing::Verdict;

  Leading leading(std::size_t i) const { return elements_[i].front().first; }

  Staircase staircase() const {
    std::vector<Leading> corners;
    for (const std::size_t i : minimal_) corners.push_back(leading(i));
    return {n_, std::move(corners)};
  }

  QuotientRing verdict() {
    const Staircase stairs = staircase();
    if (!stairs.is_finite()) return {Verdict::infinite, 0, std::nullopt, std::nullopt};
    const std::vector<Leading> basis = stairs.monomials(budget_);
    if (budget_.is_used_up()) return {};
    QuotientRing ring{Verdict::finite, basis.size(), std::nullopt, std::nullopt};
    if (options_.counts_points) ring.points = points(basis);
    return ring;
  }

  std::vector<const ModularPolynomial*> reducers() const {
    std::vector<const ModularPolynomial*> list;
    for (const std::size_t i : minimal_) list.push_back(&elements_[i]);
    return list;
  }

  /// m times the linear form.
  ModularPolynomial multiple(const Leading& m) const {
    ModularPolynomial p;
    for (std::size_t i = 0; i < n_; ++i) {
      Leading larger = m;
      ++larger.at[0];
      ++larger.at[1 + i];
      p.emplace_back(larger, random_residue(field_, i));
    }
    std::sort(p.begin(), p.end(),
              [](const auto& a, const auto& b) { return is_smaller(b.first, a.first); });
    return p;
  }

  std::optional<std::uint64_t> points(const std::vector<Leading>& basis) {
    const std::uint64_t size = basis.size();
    if (size * size * size / kMultiplicationsOfATerm > options_.most_terms) return std::nullopt;
    Multiplication multiplication(field_, basis.size());
    for (std::size_t j = 0; j < basis.size(); ++j) {
      if (basis[j].degree() == DegreeAndExponents::kMostDegree) return std::nullopt;
      const auto image = reduced(field_, multiple(basis[j]), reducers(), budget_);
      if (!image) return std::nullopt;
      for (const auto& [m, c] : *image) {
        const auto place = std::lower_bound(basis.begin(), basis.end(), m, is_smaller);
        multiplication.at(static_cast<std::size_t>(place - basis.begin()), j) = c;
      }
    }
    return multiplication.distinct_eigenvalues();
  }

  Pair next_pair() {
    const auto next =
        std::min_element(pairs_.begin(), pairs_.end(),
                         [](const Pair& a, const Pair& b) { return is_smaller(a.lcm, b.lcm); });
    const Pair pair = *next;
    pairs_.erase(next);
    return pair;
  }

  /// False where it is given up.
  bool take(ModularPolynomial p) {
    auto rest = reduced(field_, std::move(p), reducers(), budget_);
    if (!rest) return false;
    if (rest->empty()) return true;
    elements_.push_back(monic(field_, std::move(*rest)));
    if (!pair_up(elements_.size() - 1)) return false;
    const Staircase stairs = staircase();
    is_enough_ = stairs.is_finite() && stairs.monomials(budget_).size() <= options_.known;
    return !budget_.is_used_up();
  }

  /// Which pairs are needed beside those there are [GebauerMoeller88].
  bool pair_up(std::size_t h) {
    std::vector<Pair> fresh;
    for (const std::size_t i : minimal_) {
      const auto m = lcm(leading(i), leading(h));
      if (!m) return false;
      fresh.push_back({i, h, *m});
    }
    const auto of = [&](std::size_t i) { return *lcm(leading(i), leading(h)); };
    std::erase_if(pairs_, [&](const Pair& pair) {
      return divides(leading(h), pair.lcm) && !(of(pair.first) == pair.lcm) &&
             !(of(pair.second) == pair.lcm);
    });
    for (std::size_t k = 0; k < fresh.size(); ++k) {
      if (is_needed(fresh, k)) pairs_.push_back(fresh[k]);
    }
    std::erase_if(minimal_, [&](std::size_t i) { return divides(leading(h), leading(i)); });
    minimal_.push_back(h);
    return true;
  }

  /// None of another multiple divides it, and of one multiple the last is taken, but none beside a coprime pair.
  bool is_needed(const std::vector<Pair>& fresh, std::size_t k) const {
    for (std::size_t j = 0; j < fresh.size(); ++j) {
      const bool is_same = fresh[j].lcm == fresh[k].lcm;
      if (is_same && are_coprime(leading(fresh[j].first), leading(fresh[j].second))) return false;
      if (j != k && (is_same ? j > k : divides(fresh[j].lcm, fresh[k].lcm))) return false;
    }
    return true;
  }

  PrimeField field_;
  std::size_t n_;
  QuotientRingOptions options_;
  TermBudget budget_;
  std::deque<ModularPolynomial> elements_;  // all that were found
  std::vector<std::size_t> minimal_;        // those whose leading monomial no other divides
  std::vector<Pair> pairs_;
  bool is_enough_ = false;
};

}  // namespace

namespace {

/// nullopt where a degree is too large.
std::optional<std::vector<ModularPolynomial>> images(const PrimeField& field, const System& f) {
  std::vector<ModularPolynomial> result;
  for (const Polynomial& p : f.polynomials) {
    auto image = modular(field, p);
    if (!image) return std::nullopt;
    result.push_back(std::move(*image));
  }
  return result;
}

}  // namespace

QuotientRing quotient_ring(const System& f, const QuotientRingOptions& options) {
  const std::size_t n = f.variables.size();
  if (n == 0 || n > DegreeAndExponents::kMostUnknowns) return {};
  const PrimeField field(f, options.seed);
  auto polynomials = images(field, f);
  if (!polynomials) return {};
  std::vector<ModularPolynomial> rows;
  if (options.square != nullptr) {
    auto combined = images(field, *options.square);
    if (combined) rows = std::move(*combined);
  } else if (polynomials->size() == n) {
    rows = *polynomials;
  }
  return GroebnerBasis(field, n, options).of(std::move(*polynomials), rows);
}

}  // namespace moivre
