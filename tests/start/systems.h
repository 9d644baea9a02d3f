// SPDX-License-Identifier: MIT
// Systems with groups, for the tests of starts.
#pragma once

#include "moivre/polynomial/read.h"

namespace moivre {

/// Cassou-Nogues' system in b, c, d, e: total degree 1344, by the groups {b}, {c, d, e} 368.
inline System cassou() {
  return read_system({"cassou", R"(4
15*b^4*c*d^2 + 6*b^4*c^3 + 21*b^4*c^2*d - 144*b^2*c - 8*b^2*c^2*e - 28*b^2*c*d*e - 648*b^2*d
 + 36*b^2*d^2*e + 9*b^4*d^3 - 120;
30*c^3*b^4*d - 32*d*e^2*c - 720*d*b^2*c - 24*c^3*b^2*e - 432*c^2*b^2 + 576*e*c - 576*d*e
 + 16*c*b^2*d^2*e + 16*d^2*e^2 + 16*e^2*c^2 + 9*c^4*b^4 + 5184 + 39*d^2*b^4*c^2 + 18*d^3*b^4*c
 - 432*d^2*b^2 + 24*d^3*b^2*e - 16*c^2*b^2*d*e - 240*c;
216*d*b^2*c - 162*d^2*b^2 - 81*c^2*b^2 + 5184 + 1008*e*c - 1008*d*e + 15*c^2*b^2*d*e
 - 15*c^3*b^2*e - 80*d*e^2*c + 40*d^2*e^2 + 40*e^2*c^2;
261 + 4*d*b^2*c - 3*d^2*b^2 - 4*c^2*b^2 + 22*e*c - 22*d*e;
)"});
}

/// A x = lambda x for the matrix a_ij = 1/(i + j + 1) + i [i = j], scaled by x_0 = 1: unknowns x_1
/// ... x_{n-1}, lambda.
inline System eigenvalues(std::uint32_t n) {
  System f;
  for (std::uint32_t j = 1; j < n; ++j) f.variables.push_back("x" + std::to_string(j));
  f.variables.push_back("lambda");
  const auto x = [](std::uint32_t j) { return j == 0 ? constant({1, 0}) : unknown(j - 1); };
  for (std::uint32_t i = 0; i < n; ++i) {
    Polynomial row = Coefficient{-1, 0} * (unknown(n - 1) * x(i));
    for (std::uint32_t j = 0; j < n; ++j) {
      const Rational entry = Rational(1, i + j + 1) + Rational(i == j ? i : 0U);
      row = row + Coefficient{entry, 0} * x(j);
    }
    f.polynomials.push_back(row);
  }
  return f;
}

}  // namespace moivre
