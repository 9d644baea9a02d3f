// SPDX-License-Identifier: MIT
// Euclid's algorithm, and Berlekamp's and Massey's.
#include "modular_line.h"

#include <algorithm>
#include <utility>

namespace moivre {
namespace {

Line remainder(Line a, const Line& b) {
  const Residue scale = inverse(b.back());
  while (a.size() >= b.size()) {
    const Residue factor = minus(times(a.back(), scale));
    const std::size_t shift = a.size() - b.size();
    for (std::size_t k = 0; k < b.size(); ++k) {
      a[shift + k] = plus(a[shift + k], times(factor, b[k]));
    }
    trim(a);
  }
  return a;
}

/// s_k + c_1 s_{k-1} + ...
Residue discrepancy(const Line& c, const std::vector<Residue>& s, std::size_t k) {
  Residue sum = 0;
  for (std::size_t i = 0; i < c.size() && i <= k; ++i) sum = plus(sum, times(c[i], s[k - i]));
  return sum;
}

}  // namespace

void trim(Line& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

Line derivative(const Line& p) {
  Line result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(times(k, p[k]));
  trim(result);
  return result;
}

std::size_t degree_of_gcd(Line a, Line b) {
  while (!b.empty()) a = std::exchange(b, remainder(std::move(a), b));
  return a.size() - 1;
}

std::size_t distinct_roots(const Line& p) { return p.size() - 1 - degree_of_gcd(p, derivative(p)); }

// c, from c_0 = 1 on, is the recurrence so far; `before`, what it was until its length last changed, failed by `failed_by`.
Line minimal_polynomial(const std::vector<Residue>& s) {
  Line c{1};
  Line before{1};
  Residue failed_by = 1;
  std::size_t length = 0;
  std::size_t since = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    ++since;
    const Residue fails_by = discrepancy(c, s, k);
    if (fails_by == 0) continue;
    const Line now = c;
    const Residue factor = minus(times(fails_by, inverse(failed_by)));
    c.resize(std::max(c.size(), before.size() + since));
    for (std::size_t i = 0; i < before.size(); ++i) {
      c[since + i] = plus(c[since + i], times(factor, before[i]));
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
