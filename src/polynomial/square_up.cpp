// SPDX-License-Identifier: MIT
// Spare equations mixed into the leading ones; missing ones replaced by random slices.
#include "moivre/polynomial/square_up.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/scale.h"
#include "random_share.h"

namespace moivre {
namespace {

/// log2 of the largest coefficient, rounded down; p is not zero.
int log2_size(const Polynomial& p) {
  double largest = log2_size(p.terms.front().coefficient);
  for (const Term& term : p.terms) largest = std::max(largest, log2_size(term.coefficient));
  return static_cast<int>(std::floor(largest));
}

/// Numbers of the polynomials that are not zero, those that are to lead first.
std::vector<std::size_t> ranked(const System& f) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < f.polynomials.size(); ++i) {
    if (!f.polynomials[i].terms.empty()) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Polynomial& p = f.polynomials[a];
    const Polynomial& q = f.polynomials[b];
    return degree(p) != degree(q) ? degree(p) > degree(q) : p.terms.size() > q.terms.size();
  });
  return order;
}

}  // namespace

System square_up(const System& f, std::uint64_t seed) {
  const std::size_t n = f.variables.size();
  const std::size_t m = f.polynomials.size();
  if (m < n) throw InvalidInput("fewer equations than unknowns cannot be squared up");
  const std::vector<std::size_t> order = ranked(f);
  const auto leads_end = order.begin() + static_cast<std::ptrdiff_t>(std::min(n, order.size()));
  std::vector<std::size_t> leading(order.begin(), leads_end);
  std::sort(leading.begin(), leading.end());
  std::vector<std::size_t> spare(leads_end, order.end());
  System g{f.variables, {}, f.groups, f.is_exact};
  for (const std::size_t i : leading) {
    Polynomial sum = f.polynomials[i];
    for (const std::size_t j : spare) {
      const Rational share = random_share(seed, RandomStream::square_up, i * m + j, kShareBits);
      const int shift = log2_size(f.polynomials[i]) - log2_size(f.polynomials[j]);
      sum = sum + Coefficient{times_power_of_two(share, shift), 0} * f.polynomials[j];
    }
    g.polynomials.push_back(std::move(sum));
  }
  return g;
}

System with_slices(const System& f, std::uint64_t seed) {
  const std::size_t n = f.variables.size();
  if (f.polynomials.size() > n) {
    throw InvalidInput("more equations than unknowns leave no room for a slice");
  }
  System g = f;
  for (std::size_t i = f.polynomials.size(); i < n; ++i) {
    const auto share = [&](std::size_t j) {
      const std::uint64_t index = i * (n + 1) + j;
      return Coefficient{random_share(seed, RandomStream::section, index, kShareBits), 0};
    };
    TermMap terms;
    for (std::uint32_t j = 0; j < n; ++j) terms[{{j, 1}}] = share(j);
    terms[{}] = share(n);
    g.polynomials.push_back(to_polynomial(std::move(terms)));
  }
  return g;
}

}  // namespace moivre
