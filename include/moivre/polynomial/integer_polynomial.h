// SPDX-License-Identifier: MIT
// How is exact elimination kept fast? Polynomials with Gaussian integer coefficients and one exact
// factor outside.
//
// Sums and products of integers need no greatest common divisor; the content is taken out once a
// move. Of the multiples of a polynomial by Gaussian integers one stands for all: the one whose
// leading coefficient is real and whose real and imaginary parts have no common divisor. Without it
// the integers would triple with every move. Where a file's numbers were rounded, errors go with
// the coefficients, to first order. Private to the module.
#pragma once

#include <cstddef>
#include <map>

#include "moivre/numeric/integer.h"
#include "moivre/polynomial/number_errors.h"
#include "moivre/polynomial/system.h"

namespace moivre {

struct GaussianInteger {
  Integer re;
  Integer im;
};

bool is_zero(const GaussianInteger& a);
GaussianInteger operator*(const GaussianInteger& a, const GaussianInteger& b);
GaussianInteger operator-(const GaussianInteger& a);
GaussianInteger conjugate(const GaussianInteger& a);

using IntegerTerms = std::map<Monomial, GaussianInteger, MonomialOrder>;

/// Absolute errors of coefficients, of those too that cancelled.
using TermErrors = std::map<Monomial, NumberErrors, MonomialOrder>;

/// factor * sum of the terms; no term is zero.
struct IntegerPolynomial {
  IntegerTerms terms;
  Coefficient factor{1, 0};
  TermErrors errors = {};  ///< empty: exact
};

/// A coefficient, the factor included.
Complex value_of(const IntegerPolynomial& p, const GaussianInteger& c);

/// x_variable = form / divisor; `divisor` positive.
struct AffineForm {
  std::uint32_t variable = 0;
  IntegerTerms terms;
  Integer divisor;
  TermErrors errors;  ///< of form / divisor
};
/// What a linear polynomial whose coefficient of `variable` is real gives for it.
AffineForm form_of(const IntegerPolynomial& linear, std::uint32_t variable);

IntegerPolynomial to_integer(const Polynomial& p);
Polynomial to_polynomial(const IntegerPolynomial& p);

std::uint64_t degree(const IntegerPolynomial& p);

/// Chooses the multiple that stands for all; what is taken out of the terms goes into the factor.
void make_primitive(IntegerPolynomial& p);

/// The same zeros with a positive real integer coefficient at `m` (which must have a nonzero one).
IntegerPolynomial with_real_coefficient(const IntegerPolynomial& p, const Monomial& m);

/// p minus the multiple of `pivot` that removes the monomial `m`. The coefficient of `m` in
/// `pivot`: a positive integer.
IntegerPolynomial without_monomial(const IntegerPolynomial& p, const IntegerPolynomial& pivot,
                                   const Monomial& m);

/// p with the form in the place of its variable.
IntegerPolynomial substituted(const IntegerPolynomial& p, const AffineForm& form);

/// Exponent of the variable in the monomial.
std::uint32_t exponent_of(const Monomial& m, std::uint32_t variable);

/// Bits of the longest integer, the factor's included.
std::size_t bit_length(const IntegerPolynomial& p);

}  // namespace moivre
