// SPDX-License-Identifier: MIT
// Buchberger's algorithm: pairs are reduced as long as some are needed.
#include "groebner_basis.h"

#include <algorithm>
#include <utility>

namespace moivre {
namespace {

/// The monomials that no leading one divides.
class Staircase {
 public:
  Staircase(std::size_t n, std::vector<LeadingMonomial> corners)
      : n_(n), corners_(std::move(corners)) {}

  /// Finite; the list ends with the budget. In ascending order.
  std::vector<LeadingMonomial> monomials(TermBudget& budget) const {
    std::vector<LeadingMonomial> list;
    append_multiples({}, 0, budget, list);
    std::sort(list.begin(), list.end(), is_smaller);
    return list;
  }

 private:
  /// By the unknowns from i on.
  void append_multiples(LeadingMonomial m, std::size_t i, TermBudget& budget,
                        std::vector<LeadingMonomial>& list) const {
    for (; !budget.is_used_up() && is_under(m); ++m.at[0], ++m.at[1 + i]) {
      budget.spend(1);
      if (i + 1 == n_) {
        list.push_back(m);
      } else {
        append_multiples(m, i + 1, budget, list);
      }
    }
  }

  bool is_under(const LeadingMonomial& m) const {
    return std::none_of(corners_.begin(), corners_.end(),
                        [&](const LeadingMonomial& corner) { return divides(corner, m); });
  }

  std::size_t n_;
  std::vector<LeadingMonomial> corners_;
};

}  // namespace

bool GroebnerBasis::add(std::vector<ModularPolynomial> f) {
  std::sort(f.begin(), f.end(), [](const auto& a, const auto& b) {
    return !b.empty() && (a.empty() || is_smaller(a.front().first, b.front().first));
  });
  for (ModularPolynomial& p : f) {
    if (!take(std::move(p))) return false;
  }
  return is_completed();
}

void GroebnerBasis::add_unknown() {
  ++n_;
  known_ = 0;
}

bool GroebnerBasis::is_finite() const {
  for (std::size_t i = 0; i < n_; ++i) {
    const bool is_bounded = std::any_of(minimal_.begin(), minimal_.end(), [&](std::size_t k) {
      return leading(k).at[1 + i] == leading(k).at[0];
    });
    if (!is_bounded) return false;
  }
  return true;
}

std::optional<std::vector<LeadingMonomial>> GroebnerBasis::monomials() {
  std::vector<LeadingMonomial> corners;
  for (const std::size_t i : minimal_) corners.push_back(leading(i));
  std::vector<LeadingMonomial> list = Staircase(n_, std::move(corners)).monomials(budget_);
  if (budget_.is_used_up()) return std::nullopt;
  return list;
}

std::optional<ModularPolynomial> GroebnerBasis::normal_form(ModularPolynomial p) {
  return reduced(field_, std::move(p), reducers(), budget_);
}

std::vector<const ModularPolynomial*> GroebnerBasis::reducers() const {
  std::vector<const ModularPolynomial*> list;
  for (const std::size_t i : minimal_) list.push_back(&elements_[i]);
  return list;
}

bool GroebnerBasis::is_completed() {
  while (!is_enough_ && !pairs_.empty()) {
    if (stop_ != nullptr && *stop_) return false;
    const Pair pair = next_pair();
    auto s = s_polynomial(field_, elements_[pair.first], elements_[pair.second]);
    if (!s || !take(std::move(*s))) return false;
  }
  return true;
}

GroebnerBasis::Pair GroebnerBasis::next_pair() {
  const auto next =
      std::min_element(pairs_.begin(), pairs_.end(),
                       [](const Pair& a, const Pair& b) { return is_smaller(a.lcm, b.lcm); });
  const Pair pair = *next;
  pairs_.erase(next);
  return pair;
}

/// False where it is given up.
bool GroebnerBasis::take(ModularPolynomial p) {
  auto rest = normal_form(std::move(p));
  if (!rest) return false;
  if (rest->empty()) return true;
  elements_.push_back(monic(field_, std::move(*rest)));
  if (!pair_up(elements_.size() - 1)) return false;
  if (!is_finite()) {
    is_enough_ = false;
    return !budget_.is_used_up();
  }
  const auto under = monomials();
  is_enough_ = under && under->size() <= known_;
  return under.has_value();
}

/// Which pairs are needed beside those there are [GebauerMoeller88].
bool GroebnerBasis::pair_up(std::size_t h) {
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

/// None of another multiple divides it, and of one multiple the last is taken, but none beside a
/// coprime pair.
bool GroebnerBasis::is_needed(const std::vector<Pair>& fresh, std::size_t k) const {
  for (std::size_t j = 0; j < fresh.size(); ++j) {
    const bool is_same = fresh[j].lcm == fresh[k].lcm;
    if (is_same && are_coprime(leading(fresh[j].first), leading(fresh[j].second))) return false;
    if (j != k && (is_same ? j > k : divides(fresh[j].lcm, fresh[k].lcm))) return false;
  }
  return true;
}

std::optional<std::vector<ModularPolynomial>> modular_images(const PrimeField& field,
                                                             const System& f) {
  std::vector<ModularPolynomial> result;
  for (const Polynomial& p : f.polynomials) {
    auto image = modular(field, p);
    if (!image) return std::nullopt;
    result.push_back(std::move(*image));
  }
  return result;
}

}  // namespace moivre
