// SPDX-License-Identifier: MIT
// FLINT's squarefree factors, Arb's isolation of their roots, and sums of doubles for the
// midpoints.
#include "moivre/certify/isolate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arb_polynomial.h"

namespace moivre {
namespace {

// A disc that holds one root alone is this share of the way to the nearest other one.
constexpr double kShareOfGap = 0.25;

/// p times the least common denominator.
bool set_integers(const Polynomial& p, FlintPolynomial& result) {
  Integer common = 1;
  for (const Term& term : p.terms) {
    const Integer& below = denominator(term.coefficient.re);
    common = common / common_divisor(common, below) * below;
  }
  std::uint64_t bits = 0;
  for (const Term& term : p.terms) {
    const Integer c = numerator(term.coefficient.re) * (common / denominator(term.coefficient.re));
    bits += bit_length(c);
    if (bits > kMostIsolatedBits || degree(term.monomial) > kMostWrittenDegree) return false;
    result.set(degree(term.monomial), c);
  }
  return true;
}

double distance(acb_srcptr a, acb_srcptr b, slong bits) {
  ArbBall apart;
  acb_sub(apart.get(), a, b, bits);
  acb_get_mid(apart.get(), apart.get());
  ArbSize size;
  acb_get_mag(size.get(), apart.get());
  return size.upper();
}

}  // namespace

std::optional<IsolatedRoots> isolated_roots(const Polynomial& p, int bits) {
  const bool is_real = std::all_of(p.terms.begin(), p.terms.end(),
                                   [](const Term& term) { return term.coefficient.im.is_zero(); });
  if (!is_real || p.terms.empty()) return std::nullopt;
  thread_local const FlintCaches caches;
  FlintPolynomial whole;
  if (!set_integers(p, whole)) return std::nullopt;
  SquarefreeFactors factors(whole);
  IsolatedRoots result;
  std::vector<ArbBall> places;
  for (slong k = 0; k < factors.count(); ++k) {
    const slong count = factors.factor(k)->length - 1;
    if (count > static_cast<slong>(kMostIsolatedDegree)) {
      if (factors.exponent(k) > 1) return std::nullopt;
      result.other_simple = static_cast<std::uint64_t>(count);
      continue;
    }
    if (count == 0) continue;
    acb_ptr const values = _acb_vec_init(count);
    arb_fmpz_poly_complex_roots(values, factors.factor(k), 0, bits);
    for (slong j = 0; j < count; ++j) {
      const SumOfDoubles sum = sum_of_doubles(values + j, bits);
      result.roots.push_back({sum.parts, sum.error, 0, factors.exponent(k)});
      acb_set(places.emplace_back().get(), values + j);
    }
    _acb_vec_clear(values, count);
  }
  for (std::size_t j = 0; j < places.size(); ++j) {
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (k == j) continue;
      nearest = std::min(nearest, distance(places[j].get(), places[k].get(), 2 * bits));
    }
    IsolatedRoot& root = result.roots[j];
    root.radius = kShareOfGap * nearest;
    if (!(root.error < root.radius * kShareOfGap)) return std::nullopt;
  }
  return result;
}

}  // namespace moivre
