// SPDX-License-Identifier: MIT
// A Groebner basis, the pair of the least common multiple first, and the monomials under its staircase.
#include "moivre/polynomial/quotient_ring.h"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "modular_polynomial.h"

namespace moivre {
namespace {

using Leading = DegreeAndExponents;

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
      const bool is_bounded = std::any_of(corners_.begin(), corners_.end(), [i](const Leading& m) {
        return m.at[1 + i] == m.at[0];
      });
      if (!is_bounded) return false;
    }
    return true;
  }

  /// Finite; the count ends with the budget.
  std::uint64_t size(TermBudget& budget) const { return size_from({}, 0, budget); }

 private:
  /// Of the multiples of m by the unknowns from i on.
  std::uint64_t size_from(Leading m, std::size_t i, TermBudget& budget) const {
    std::uint64_t size = 0;
    while (!budget.is_used_up() && is_under(m)) {
      budget.spend(1);
      size += i + 1 == n_ ? 1 : size_from(m, i + 1, budget);
      ++m.at[0];
      ++m.at[1 + i];
    }
    return size;
  }

  bool is_under(const Leading& m) const {
    return std::none_of(corners_.begin(), corners_.end(),
                        [&](const Leading& corner) { return divides(corner, m); });
  }

  std::size_t n_;
  std::vector<Leading> corners_;
};

class GroebnerBasis {
 public:
  GroebnerBasis(std::size_t n, const QuotientRingOptions& options)
      : n_(n), known_(options.known), budget_(options.most_terms), stop_(options.stop) {}

  QuotientRing of(std::vector<ModularPolynomial> f) {
    std::sort(f.begin(), f.end(), [](const auto& a, const auto& b) {
      return !b.empty() && (a.empty() || precedes(a.front().first, b.front().first));
    });
    for (ModularPolynomial& p : f) {
      if (!take(std::move(p))) return {};
    }
    while (!is_enough_ && !pairs_.empty()) {
      if (stop_ != nullptr && *stop_) return {};
      const Pair pair = next_pair();
      auto s = s_polynomial(elements_[pair.first], elements_[pair.second]);
      if (!s || !take(std::move(*s))) return {};
    }
    return verdict();
  }

 private:
  using Verdict = QuotientRing::Verdict;

  Leading leading(std::size_t i) const { return elements_[i].front().first; }

  Staircase staircase() const {
    std::vector<Leading> corners;
    for (const std::size_t i : minimal_) corners.push_back(leading(i));
    return {n_, std::move(corners)};
  }

  QuotientRing verdict() {
    const Staircase stairs = staircase();
    if (!stairs.is_finite()) return {Verdict::infinite, 0};
    const std::uint64_t size = stairs.size(budget_);
    return budget_.is_used_up() ? QuotientRing{} : QuotientRing{Verdict::finite, size};
  }

  Pair next_pair() {
    const auto next = std::min_element(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) {
      return precedes(a.lcm, b.lcm);
    });
    const Pair pair = *next;
    pairs_.erase(next);
    return pair;
  }

  /// False where it is given up.
  bool take(ModularPolynomial p) {
    std::vector<const ModularPolynomial*> reducers;
    for (const std::size_t i : minimal_) reducers.push_back(&elements_[i]);
    auto rest = reduced(std::move(p), reducers, budget_);
    if (!rest) return false;
    if (rest->empty()) return true;
    elements_.push_back(std::move(*rest));
    if (!pair_up(elements_.size() - 1)) return false;
    const Staircase stairs = staircase();
    is_enough_ = stairs.is_finite() && stairs.size(budget_) <= known_;
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

  std::size_t n_;
  std::uint64_t known_;
  TermBudget budget_;
  const std::atomic<bool>* stop_;
  std::deque<ModularPolynomial> elements_;  // all that were found
  std::vector<std::size_t> minimal_;        // those whose leading monomial no other divides
  std::vector<Pair> pairs_;
  bool is_enough_ = false;
};

}  // namespace

QuotientRing quotient_ring(const System& f, const QuotientRingOptions& options) {
  std::vector<ModularPolynomial> images;
  for (const Polynomial& p : f.polynomials) {
    auto image = modular(p);
    if (!image) return {};
    images.push_back(std::move(*image));
  }
  return GroebnerBasis(f.variables.size(), options).of(std::move(images));
}

}  // namespace moivre
