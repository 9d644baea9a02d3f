// SPDX-License-Identifier: MIT
// Bombieri-Weyl norms by logarithms of factorials: they cannot overflow.
#include "smale_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "moivre/polynomial/scale.h"

namespace moivre {
namespace {

double log2_factorial(double n) { return std::lgamma(n + 1) / std::numbers::ln2; }

/// log2 of |c|^2 e! (d - |e|)! / d!.
double log2_weight(const Term& term, double d) {
  double weight = 2 * log2_size(term.coefficient) - log2_factorial(d) +
                  log2_factorial(d - static_cast<double>(degree(term.monomial)));
  for (const Power& power : term.monomial) weight += log2_factorial(power.exponent);
  return weight;
}

}  // namespace

RowNorms row_norms(const System& f) {
  RowNorms norms;
  for (const Polynomial& p : f.polynomials) {
    const auto d = static_cast<double>(degree(p));
    double largest = -std::numeric_limits<double>::infinity();
    for (const Term& term : p.terms) largest = std::max(largest, log2_weight(term, d));
    double sum = 0;
    for (const Term& term : p.terms) sum += std::exp2(log2_weight(term, d) - largest);
    norms.log2_norm.push_back((largest + std::log2(sum)) / 2);
    norms.degree.push_back(d);
    norms.terms = std::max(norms.terms, static_cast<double>(p.terms.size()));
  }
  return norms;
}

}  // namespace moivre
