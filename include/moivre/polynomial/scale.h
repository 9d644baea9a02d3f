// SPDX-License-Identifier: MIT
// In which units are the unknowns and the equations of moderate size? Powers of two: nothing is
// rounded.
//
//   x_j = 2^v_j y_j,   G_i(y) = 2^r_i F_i(x(y)),   coefficient of a term: 2^(r_i + e.v) c, e its
//                                                  exponents.
//
// With E_ik = log2|c_ik| + r_i + e_ik.v the scaling minimizes, after [Morgan87, ch. 5] and
// [MeintjesMorgan87],
//   sum_ik E_ik^2 + sum_i sum_{k<l} (E_ik - E_il)^2:
// coefficients near 1, and near each other within an equation. The second sum does not depend on r,
// so that r_i = -mean_k(log2|c_ik| + e_ik.v), and v solves a least-squares problem of its own; of
// several minima the one of least norm in v is taken (the papers: in v and r). v is rounded to
// integers, then r.
//
// Properties:
//  (1) scale() is exact: G_i(y) = 2^r_i F_i(2^v y) as polynomials with rational coefficients.
//  (2) A mild system (every |log2|c|| within kMildSize) is left alone: choose_scaling is the
//  identity.
//  (3) Unknowns are scaled only where that at least halves the root mean square of the deviations
//  within the equations;
//      otherwise v = 0, and only equations with a coefficient that is not mild get an r_i.
// Zero polynomials get r_i = 0; unknowns that appear nowhere get v_j = 0.
// Not supported: shifts of a coefficient beyond 2^20 bits; such unknowns and equations are left
// unscaled.
#pragma once

#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

/// log2 of a size from which a coefficient counts as large (1024) or, negated, as small.
inline constexpr double kMildSize = 10;

struct Scaling {
  std::vector<int> variable_log2;  ///< v, one for each unknown
  std::vector<int> equation_log2;  ///< r, one for each equation

  friend bool operator==(const Scaling&, const Scaling&) = default;
};

/// log2|c| from the exact rationals: right for sizes no double can hold. Requires c != 0.
double log2_size(const Coefficient& c);

/// 2^exponent a. |exponent| < 2^32.
Rational times_power_of_two(const Rational& a, std::int64_t exponent);

Scaling choose_scaling(const System& f);

/// Requires one entry for each unknown and equation (std::invalid_argument).
System scale(const System& f, const Scaling& scaling);

bool is_identity(const Scaling& scaling);
/// "unknowns by 2^-3 to 2^2, equations by 2^5": what is scaled, in words; empty for the identity.
std::string to_text(const Scaling& scaling);

/// x = 2^v y: a point of the scaled system in the units of the original one.
std::vector<std::complex<double>> restore(const Scaling& scaling,
                                          const std::vector<std::complex<double>>& y);

}  // namespace moivre
