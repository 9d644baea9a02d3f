// SPDX-License-Identifier: MIT
// Has a system fewer monomials in other unknowns? Where x_i and x_j enter by x_i^2 + x_j^2, as the
// two parts of a voltage or of a direction do:
//
//   u = x_i + i x_j,  v = x_i - i x_j     x_i^2 + x_j^2 = u v,   x_i = (u + v) / 2,   x_j = (u - v)
//                                         / 2i
//
// A square has become a product, and polytopes shrink: the power flow of nine nodes has 36864 paths
// in x and 768 in u and v, which are its roots. The change is linear and invertible: roots go over
// to roots, multiplicities stay; a real root is one where v is the conjugate of u.
// Pairs: i and j alone have squares of one coefficient in some equation; an unknown that would be
// in two pairs is in none.
// Errors of numbers go over to first order, kept apart by number (number_errors.h).
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "moivre/polynomial/digits.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// Places i < j: u takes x_i's place and v takes x_j's.
using IsotropicPair = std::pair<std::size_t, std::size_t>;

std::vector<IsotropicPair> isotropic_pairs(const System& f);

/// f in u and v, its groups and denominators left out, with the names "x_i + i x_j" and "x_i - i
/// x_j".
System in_isotropic(const System& f, const std::vector<IsotropicPair>& pairs);

/// Of in_isotropic(f, pairs), relative to its coefficients; errors: of f, empty where it is exact.
CoefficientErrors errors_in_isotropic(const System& f, const CoefficientErrors& errors,
                                      const std::vector<IsotropicPair>& pairs);

/// x from u and v, over any scalar with + and *: `round` makes the scalar of an exact coefficient.
template <typename Scalar, typename Round>
void leave_isotropic(const std::vector<IsotropicPair>& pairs, std::vector<Scalar>& x, Round round) {
  const Scalar half = round(Coefficient{Rational(1, 2)});
  const Scalar turned = round(Coefficient{Rational(), Rational(-1, 2)});  // 1 / 2i
  const Scalar minus = round(Coefficient{Rational(-1)});
  for (const auto& [i, j] : pairs) {
    const Scalar u = x[i], v = x[j];
    x[i] = half * (u + v);
    x[j] = turned * (u + minus * v);
  }
}

/// u and v from x.
void enter_isotropic(const std::vector<IsotropicPair>& pairs, std::vector<std::complex<double>>& x);

}  // namespace moivre
