// SPDX-License-Identifier: MIT
// FLINT's squarefree factors, Arb's isolation of their roots, and sums of doubles for the midpoints.
#include "moivre/certify/isolate.h"

#include <algorithm>
#include <cmath>
#include <limits>

// FLINT 3 has taken Arb in, and its headers.
#if __has_include(<flint/arb_fmpz_poly.h>)
#include <flint/arb_fmpz_poly.h>
#else
#include <arb_fmpz_poly.h>
#endif
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include "arb_ball.h"
#include "arb_numbers.h"

namespace moivre {
namespace {

// A disc that holds one root alone is this share of the way to the nearest other one.
constexpr double kShareOfGap = 0.25;

class IntegerPolynomial {
 public:
  IntegerPolynomial() { fmpz_poly_init(value_); }
  IntegerPolynomial(const IntegerPolynomial&) = delete;
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
  ~IntegerPolynomial() { fmpz_poly_clear(value_); }

  void set(std::uint64_t degree, const Integer& c) {
    fmpz_t coefficient;
    fmpz_init(coefficient);
    moivre::set(coefficient, c);
    fmpz_poly_set_coeff_fmpz(value_, static_cast<slong>(degree), coefficient);
    fmpz_clear(coefficient);
  }
  fmpz_poly_struct* get() { return value_; }

 private:
  fmpz_poly_t value_;
};

class SquarefreeFactors {
 public:
  explicit SquarefreeFactors(IntegerPolynomial& p) {
    fmpz_poly_factor_init(value_);
    fmpz_poly_factor_squarefree(value_, p.get());
  }
  SquarefreeFactors(const SquarefreeFactors&) = delete;
  SquarefreeFactors& operator=(const SquarefreeFactors&) = delete;
  ~SquarefreeFactors() { fmpz_poly_factor_clear(value_); }

  slong count() const { return value_->num; }
  fmpz_poly_struct* factor(slong k) { return value_->p + k; }
  std::uint64_t exponent(slong k) const { return static_cast<std::uint64_t>(value_->exp[k]); }

 private:
  fmpz_poly_factor_t value_;
};

/// p times the least common denominator.
bool set_integers(const Polynomial& p, IntegerPolynomial& result) {
  Integer common = 1;
  for (const Term& term : p.terms) {
    const Integer& below = denominator(term.coefficient.re);
    common = common / common_divisor(common, below) * below;
  }
  std::uint64_t bits = 0;
  for (const Term& term : p.terms) {
    const Integer c = numerator(term.coefficient.re) * (common / denominator(term.coefficient.re));
    bits += bit_length(c);
    if (bits > kMostIsolatedBits) return false;
    result.set(degree(term.monomial), c);
  }
  return true;
}

/// The midpoint as a sum of doubles; what is left of it is added to the error.
IsolatedRoot told(acb_srcptr root, int bits) {
  constexpr int kBitsOfDouble = 53;
  constexpr double kUp = 1 + 0x1p-40;
  IsolatedRoot result;
  ArbBall rest;
  acb_get_mid(rest.get(), root);
  for (int known = 0; known <= bits; known += kBitsOfDouble) {
    const Complex part(take_double(acb_realref(rest.get())), take_double(acb_imagref(rest.get())));
    if (part == Complex(0) && known > 0) break;
    result.parts.push_back(part);
  }
  ArbBall ball;
  acb_sub(ball.get(), root, root, kBitsOfDouble);  // 0 and twice the radii
  acb_add(ball.get(), ball.get(), rest.get(), kBitsOfDouble);
  ArbSize size;
  acb_get_mag(size.get(), ball.get());
  result.error = kUp * size.upper();
  return result;
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
  IntegerPolynomial whole;
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
      result.roots.push_back(told(values + j, bits));
      result.roots.back().multiplicity = factors.exponent(k);
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
