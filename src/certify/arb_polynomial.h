// SPDX-License-Identifier: MIT
// Polynomials of FLINT with integer coefficients, their squarefree factors, and how their roots
// come back as sums of doubles.
#pragma once

// FLINT 3 has taken Arb in, and its headers.
#if __has_include(<flint/arb_fmpz_poly.h>)
#include <flint/arb_fmpz_poly.h>
#else
#include <arb_fmpz_poly.h>
#endif
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <vector>

#include "arb_ball.h"
#include "arb_numbers.h"
#include "moivre/numeric/complex.h"

namespace moivre {

class FlintPolynomial {
 public:
  FlintPolynomial() { fmpz_poly_init(value_); }
  FlintPolynomial(const FlintPolynomial&) = delete;
  FlintPolynomial& operator=(const FlintPolynomial&) = delete;
  ~FlintPolynomial() { fmpz_poly_clear(value_); }

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
  explicit SquarefreeFactors(FlintPolynomial& p) {
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

/// A number that is known within `error` of the sum of its parts, largest first.
struct SumOfDoubles {
  std::vector<Complex> parts;
  double error = 0;
};

/// So many bits of the midpoint; what is left of it is added to the error.
SumOfDoubles sum_of_doubles(acb_srcptr ball, int bits);

}  // namespace moivre
