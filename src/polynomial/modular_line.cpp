// SPDX-License-Identifier: MIT
// Euclid's algorithm, and Berlekamp's and Massey's.
#include "moivre/polynomial/modular_line.h"

#include <algorithm>
#include <utility>

namespace moivre {
namespace {

Line remainder(const PrimeField& field, Line a, const Line& b) {
  const Residue scale = field.inverse(b.back());
  while (a.size() >= b.size()) {
    const Residue factor = field.minus(field.times(a.back(), scale));
    const std::size_t shift = a.size() - b.size();
    for (std::size_t k = 0; k < b.size(); ++k) {
      a[shift + k] = field.plus(a[shift + k], field.times(factor, b[k]));
    }
    trim(a);
  }
  return a;
}

/// s_k + c_1 s_{k-1} + ...
Residue discrepancy(const PrimeField& field, const Line& c, const std::vector<Residue>& s,
                    std::size_t k) {
  Residue sum = 0;
  for (std::size_t i = 0; i < c.size() && i <= k; ++i)
    sum = field.plus(sum, field.times(c[i], s[k - i]));
  return sum;
}

}  // namespace

void trim(Line& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

Line derivative(const PrimeField& field, const Line& p) {
  Line result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(field.times(k, p[k]));
  trim(result);
  return result;
}

std::size_t degree_of_gcd(const PrimeField& field, Line a, Line b) {
  while (!b.empty()) a = std::exchange(b, remainder(field, std::move(a), b));
  return a.size() - 1;
}

std::size_t distinct_roots(const PrimeField& field, const Line& p) {
  return p.size() - 1 - degree_of_gcd(field, p, derivative(field, p));
}

// c, from c_0 = 1 on, is the recurrence so far; `before`, what it was until its length last
// changed, failed by `failed_by`.
Line minimal_polynomial(const PrimeField& field, const std::vector<Residue>& s) {
  Line c{1};
  Line before{1};
  Residue failed_by = 1;
  std::size_t length = 0;
  std::size_t since = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    ++since;
    const Residue fails_by = discrepancy(field, c, s, k);
    if (fails_by == 0) continue;
    const Line now = c;
    const Residue factor = field.minus(field.times(fails_by, field.inverse(failed_by)));
    c.resize(std::max(c.size(), before.size() + since));
    for (std::size_t i = 0; i < before.size(); ++i) {
      c[since + i] = field.plus(c[since + i], field.times(factor, before[i]));
    }
    if (2 * length > k) continue;
    length = k + 1 - length;
    before = now;
    failed_by = fails_by;
    since = 0;
  }
  c.resize(length + 1);
  std::reverse(c.begin(), c.end());
  return c;
}

}  // namespace moivre
