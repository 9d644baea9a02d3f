// SPDX-License-Identifier: MIT
// What is a polynomial worth at a point, and relative to its terms?
#pragma once

#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

Complex value_at(const Monomial& monomial, const Point& x);
Complex value_at(const Polynomial& p, const Point& x);

Coefficient exact_value_at(const Monomial& monomial, const std::vector<Coefficient>& x);
Coefficient exact_value_at(const Polynomial& p, const std::vector<Coefficient>& x);

/// Sum of the magnitudes of the terms.
double term_size(const Polynomial& p, const Point& x);

/// The coefficients in double, by term. Rounding an exact number takes longer than a term's value:
/// of many points it is done once.
Point rounded_coefficients(const Polynomial& p);
Complex value_at(const Polynomial& p, const Point& coefficients, const Point& x);
double term_size(const Polynomial& p, const Point& coefficients, const Point& x);

}  // namespace moivre
