// SPDX-License-Identifier: MIT
// Which supports do the tests of the polyhedral start use? Families whose mixed volumes are
// published, as supports.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "moivre/start/support.h"

namespace moivre {

inline Exponents unit(std::size_t n, std::initializer_list<std::size_t> variables) {
  Exponents e(n, 0);
  for (const std::size_t j : variables) ++e[j];
  return e;
}

/// Sums of products of d neighbours on a circle; the product of all, and 1.
inline std::vector<Support> cyclic(std::size_t n) {
  std::vector<Support> supports(n);
  for (std::size_t d = 1; d < n; ++d) {
    for (std::size_t i = 0; i < n; ++i) {
      Exponents e(n, 0);
      for (std::size_t k = 0; k < d; ++k) ++e[(i + k) % n];
      supports[d - 1].terms.push_back(e);
    }
  }
  supports.back().terms = {Exponents(n, 1), Exponents(n, 0)};
  return supports;
}

/// x_i sum_{j != i} x_j^2 - c x_i + 1.
inline std::vector<Support> noon(std::size_t n) {
  std::vector<Support> supports(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (j != i) supports[i].terms.push_back(unit(n, {i, j, j}));
    }
    supports[i].terms.push_back(unit(n, {i}));
    supports[i].terms.push_back(unit(n, {}));
  }
  return supports;
}

/// x_n (x_i + sum_j x_j x_{i+j}) - i; x_1 + ... + x_{n-1} + 1.
inline std::vector<Support> eco(std::size_t n) {
  std::vector<Support> supports(n);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    supports[i].terms.push_back(unit(n, {n - 1, i}));
    for (std::size_t j = 0; i + j + 2 < n; ++j) {
      supports[i].terms.push_back(unit(n, {n - 1, j, i + j + 1}));
    }
    supports[i].terms.push_back(unit(n, {}));
    supports[n - 1].terms.push_back(unit(n, {i}));
  }
  supports[n - 1].terms.push_back(unit(n, {}));
  return supports;
}

/// n + 1 unknowns u_0, ..., u_n: sum_l u_l u_{m-l} - u_m with u_{-l} = u_l; u_0 + 2 (u_1 + ... +
/// u_n) - 1.
inline std::vector<Support> katsura(std::size_t n) {
  std::vector<Support> supports(n + 1);
  const int last = static_cast<int>(n);
  for (int m = 0; m < last; ++m) {
    std::vector<Exponents>& terms = supports[static_cast<std::size_t>(m)].terms;
    for (int l = -last; l <= last; ++l) {
      const int other = m - l < 0 ? l - m : m - l;
      const int a = l < 0 ? -l : l;
      if (a > other || other > last) continue;
      const Exponents e =
          unit(n + 1, {static_cast<std::size_t>(a), static_cast<std::size_t>(other)});
      if (std::find(terms.begin(), terms.end(), e) == terms.end()) terms.push_back(e);
    }
    terms.push_back(unit(n + 1, {static_cast<std::size_t>(m)}));
  }
  for (std::size_t j = 0; j <= n; ++j) supports[n].terms.push_back(unit(n + 1, {j}));
  supports[n].terms.push_back(unit(n + 1, {}));
  return supports;
}

/// 2 x_1^i - 2 x_2^i + ... + (-1)^{n+1} x_n^i - 1, i = 2..n+1.
inline std::vector<Support> reimer(std::size_t n) {
  std::vector<Support> supports(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      Exponents e(n, 0);
      e[j] = static_cast<std::uint32_t>(i + 2);
      supports[i].terms.push_back(e);
    }
    supports[i].terms.push_back(Exponents(n, 0));
  }
  return supports;
}

/// Every exponent times m: the mixed volume times m^n, with the same edges for the same lifting.
inline std::vector<Support> stretched(std::vector<Support> supports, std::uint32_t m) {
  for (Support& support : supports) {
    for (Exponents& term : support.terms) {
      for (std::uint32_t& e : term) e *= m;
    }
  }
  return supports;
}

}  // namespace moivre
