// SPDX-License-Identifier: MIT
// Equations sorted by degree, the last ones mixed into the first.
#include "squared_up.h"

#include <algorithm>
#include <cmath>

#include "moivre/formulation/exact.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

/// Exponent of two of the largest coefficient.
int size_of(const Polynomial& p) {
  double largest = 0;
  for (const Term& term : p.terms)
    largest = std::max(largest, std::abs(to_complex(term.coefficient)));
  return largest > 0 ? std::ilogb(largest) : 0;
}

/// +-k/64 with k of 32..96: none negligible, none large.
double random_share(std::uint64_t seed, std::uint64_t index) {
  constexpr std::uint64_t kValues = 65;
  const std::uint64_t bits = random_bits(seed, RandomStream::slice, index);
  const double size = static_cast<double>(32 + (bits >> 1) % kValues) / 64;
  return (bits & 1) != 0 ? size : -size;
}

}  // namespace

System squared_up(const System& f, std::uint64_t seed) {
  std::vector<Polynomial> sorted = f.polynomials;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Polynomial& a, const Polynomial& b) { return degree(a) > degree(b); });
  const std::size_t n = std::min(f.variables.size(), sorted.size());
  System g{f.variables, {}};
  for (std::size_t i = 0; i < n; ++i) {
    Polynomial sum = sorted[i];
    for (std::size_t j = n; j < sorted.size(); ++j) {
      const int scale = size_of(sorted[i]) - size_of(sorted[j]);
      const double share = std::ldexp(random_share(seed, i * sorted.size() + j), scale);
      sum = sum + exactly(share) * sorted[j];
    }
    g.polynomials.push_back(std::move(sum));
  }
  return g;
}

}  // namespace moivre
