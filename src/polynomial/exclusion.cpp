// SPDX-License-Identifier: MIT
// Taylor sums of sparse polynomials at a point of doubles, in exact rationals, and the comparison.
#include "moivre/polynomial/exclusion.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "moivre/factorization/lu.h"

namespace moivre {
namespace {

// Sums and products of upper bounds lose less than this share: at most 10^4 operations a bound,
// 2^-53 each.
constexpr double kUp = 1 + 0x1p-38;
constexpr double kDown = 1 - 0x1p-38;
// What falls below the smallest double stays below this.
constexpr double kTiny = 1e-300;
// Exact coefficients an equation at most; the order is chosen by it, but is 1 at least.
constexpr double kMostCoefficients = 3000;
// Combinations are not made of more equations than this: their exact coefficients take n^2
// products.
constexpr std::size_t kMostCombined = 200;
// Terms of higher degree than this are bounded without a table of their orders.
constexpr std::uint64_t kMostOrders = 2000;

double upper_size(const Coefficient& c) {
  return std::hypot(to_double(c.re), to_double(c.im)) * kUp + kTiny;
}
double lower_size(const Coefficient& c) {
  return std::hypot(to_double(c.re), to_double(c.im)) * kDown - kTiny;
}

/// n + k over k.
double choices(std::size_t n, std::uint64_t k) {
  double count = 1;
  for (std::uint64_t i = 1; i <= k; ++i) {
    count *= static_cast<double>(n + i) / static_cast<double>(i);
  }
  return count;
}

std::uint64_t exact_order(std::size_t n, std::uint64_t multiplicity) {
  const std::uint64_t wanted = std::clamp<std::uint64_t>(multiplicity, 2, 16);
  std::uint64_t order = 1;
  while (order < wanted && choices(n, order + 1) <= kMostCoefficients) ++order;
  return order;
}

using Shifted = std::map<Monomial, Coefficient>;

/// One polynomial about x: exact up to an order, a bound on the rest.
struct Expansion {
  Shifted exact;
  double rest = 0;  ///< sum of |C_b| a^|b| of higher orders, at most
};

Coefficient exact(const Complex& x) { return {Rational(x.real()), Rational(x.imag())}; }

class TaylorSums {
 public:
  TaylorSums(const std::vector<Coefficient>& x, double radius, std::uint64_t order)
      : radius_(radius), order_(order), x_(x) {
    for (const Coefficient& xj : x_) size_.push_back(upper_size(xj));
  }

  Expansion expand(const Polynomial& p) {
    Expansion expansion;
    for (const Term& term : p.terms) {
      Monomial b;
      spread(term, 0, term.coefficient, 0, b, expansion.exact);
      expansion.rest += upper_size(term.coefficient) * higher_orders(term.monomial);
    }
    expansion.rest *= kUp;
    return expansion;
  }

 private:
  /// x_j^e, remembered.
  const Coefficient& power(std::uint32_t j, std::uint32_t e) {
    std::vector<Coefficient>& powers = powers_[j];
    if (powers.empty()) powers.push_back({Rational(1), Rational(0)});
    while (powers.size() <= e) powers.push_back(powers.back() * x_[j]);
    return powers[e];
  }

  /// Adds the coefficients of prod_j (x_j + h_j)^e_j, factors from k on, to those of h^b.
  void spread(const Term& term, std::size_t k, const Coefficient& c, std::uint64_t order,
              Monomial& b, Shifted& sums) {
    if (k == term.monomial.size()) {
      Coefficient& sum = sums[b];
      sum = sum + c;
      return;
    }
    const auto [j, e] = term.monomial[k];
    Rational choice(1);  // e over i
    for (std::uint32_t i = 0; i <= e && order + i <= order_; ++i) {
      if (i > 0) {
        choice *= Rational(e - i + 1);
        choice /= Rational(i);
        b.push_back({j, i});
      }
      const Coefficient part = c * power(j, e - i) * Coefficient{choice, Rational(0)};
      if (!is_zero(part)) spread(term, k + 1, part, order + i, b, sums);
      if (i > 0) b.pop_back();
    }
  }

  /// sum over k > order of t_k a^k, where prod_j (|x_j| + s)^e_j = sum_k t_k s^k.
  double higher_orders(const Monomial& monomial) const {
    const std::uint64_t d = degree(monomial);
    if (d <= order_) return 0;
    if (d > kMostOrders) return HUGE_VAL;
    std::vector<double> t{1};
    for (const auto& [j, e] : monomial) {
      for (std::uint32_t i = 0; i < e; ++i) {
        t.push_back(0);
        for (std::size_t k = t.size(); k-- > 0;) {
          t[k] = t[k] * size_[j] + (k > 0 ? t[k - 1] : 0) * radius_;
        }
      }
    }
    double sum = 0;
    for (std::size_t k = order_ + 1; k < t.size(); ++k) sum += t[k];
    return sum * kUp + kTiny;
  }

  double radius_;
  std::uint64_t order_;
  std::vector<Coefficient> x_;
  std::vector<double> size_;
  std::map<std::uint32_t, std::vector<Coefficient>> powers_;
};

/// sum |C_b| a^|b| of orders from `first` on, at most.
double reach(const Expansion& p, double radius, std::uint64_t first) {
  double sum = p.rest;
  for (const auto& [b, c] : p.exact) {
    if (degree(b) < first) continue;
    sum += upper_size(c) * std::pow(radius, static_cast<double>(degree(b)));
  }
  return sum * kUp;
}

Coefficient value(const Expansion& p) {
  const auto found = p.exact.find({});
  return found == p.exact.end() ? Coefficient{} : found->second;
}

Coefficient first_order(const Expansion& p, std::uint32_t j) {
  const auto found = p.exact.find({{j, 1}});
  return found == p.exact.end() ? Coefficient{} : found->second;
}

/// The row of J^{-1} with the longest Newton step; empty where J is singular.
Point longest_row(const std::vector<Expansion>& f) {
  const std::size_t n = f.size();
  Lu lu(n);
  const std::span<Complex> matrix = lu.matrix();
  Point step(n);
  for (std::size_t i = 0; i < n; ++i) {
    step[i] = to_complex(value(f[i]));
    for (std::uint32_t j = 0; j < n; ++j) matrix[i * n + j] = to_complex(first_order(f[i], j));
  }
  if (!lu.factor()) return {};
  lu.solve(step);
  const auto longest = std::max_element(step.begin(), step.end(),
                                        [](auto& a, auto& b) { return std::abs(a) < std::abs(b); });
  Point row(n);
  row[static_cast<std::size_t>(longest - step.begin())] = 1;
  lu.solve_adjoint(row);
  for (Complex& yi : row) yi = std::conj(yi);
  if (!std::all_of(row.begin(), row.end(), [](const Complex& yi) { return is_finite(yi); })) {
    return {};
  }
  return row;
}

bool combination_excludes(const std::vector<Expansion>& f, double radius) {
  const std::size_t n = f.size();
  const Point y = longest_row(f);
  if (y.empty()) return false;
  Coefficient sum;
  std::vector<Coefficient> slope(n);
  double most = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Coefficient yi = exact(y[i]);
    sum = sum + yi * value(f[i]);
    most += upper_size(yi) * reach(f[i], radius, 2);
    for (std::uint32_t j = 0; j < n; ++j) slope[j] = slope[j] + yi * first_order(f[i], j);
  }
  for (const Coefficient& c : slope) most += upper_size(c) * radius;
  return lower_size(sum) > most * kUp;
}

}  // namespace

bool has_no_root_within(const System& f, const Point& x, double radius,
                        std::uint64_t multiplicity) {
  std::vector<Coefficient> place;
  for (const Complex& xj : x) place.push_back(exact(xj));
  return has_no_root_near(f, place, radius, multiplicity);
}

bool has_no_root_near(const System& f, const std::vector<Coefficient>& x, double radius,
                      std::uint64_t multiplicity) {
  const std::size_t n = f.variables.size();
  TaylorSums expander(x, radius, exact_order(n, multiplicity));
  std::vector<Expansion> expansions;
  for (const Polynomial& p : f.polynomials) {
    expansions.push_back(expander.expand(p));
    if (lower_size(value(expansions.back())) > reach(expansions.back(), radius, 1)) return true;
  }
  const bool is_square = f.polynomials.size() == n;
  return is_square && n > 0 && n <= kMostCombined && combination_excludes(expansions, radius);
}

}  // namespace moivre
