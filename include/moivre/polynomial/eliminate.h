// SPDX-License-Identifier: MIT
// Which smaller system has the same roots? Linear equations are eliminated, also those that only
// combinations show.
//
// Two moves, exact in the rationals, in turn until neither applies:
//   combine     among the equations of one degree, those whose highest terms depend linearly on the
//               others' are replaced by combinations of lower degree; of degree 0 are 0 = 0
//               (dependent) and c = 0 (inconsistent)
//   substitute  a_j x_j + sum_k a_k x_k + b = 0 becomes x_j = -(sum_k a_k x_k + b) / a_j everywhere
//               (as many dense equations as unknowns, of long integers, give their point at once)
//
// F: the m equations given, in x of C^n. R: the equations left, in the kept unknowns y of C^k.
// restore: y -> x, affine.
//  (1) restore(y) is y in the kept places: kept[i] is the place of y_i in x, and restore is
//  injective.
//  (2) R_i(y) = F_o(restore(y)) + a combination of the other F_k(restore(y)), o =
//  equation_origin[i], and
//      span{F_i(restore(y))} = span{R_i(y)} as spaces of polynomials: row operations, invertible.
//  (3) Every root x of F is restore(y) of a root y of R, with the same multiplicity. The eliminated
//  equations lie in the ideal
//      of F, and each is solved for its own unknown. So C[x]/(F) and C[y]/(R) are isomorphic.
//  Where isotropic unknowns stand for some of y (isotropic.h) restore leaves them first, and R is
//  what it was in these.
//  (4) The product of the degrees never rises; combine makes it the least that combinations with
//  constant coefficients
//      can reach.
//
// Which unknown: of the pivots of at least kPivotThreshold times the equation's largest coefficient
// (sizes measured under choose_scaling), the one that makes the fewest new terms. How far:
// equations are substituted as long as possible, and the system of least work is kept
// (multiply-adds of a tracker's step times the product of the degrees,
// docs/decisions/0003-when-elimination-pays.md). So equations whose substitution did not pay stay,
// unless it proves a contradiction or a dependence. A move is not made if an integer would exceed
// the limits below.
// Not supported: products of equations with polynomials (Groebner bases), factors of an equation.
#pragma once

#include <atomic>
#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "moivre/polynomial/digits.h"
#include "moivre/polynomial/isotropic.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// Threshold pivoting as in sparse LU [DuffErismanReid86]: errors grow at most 1 + 1/0.1 a pivot.
inline constexpr double kPivotThreshold = 0.1;

/// A numerator or denominator may grow to kBitGrowth times the longest of the input: a Cramer
/// determinant of 64 equations stays within it, and so does its square, the denominator when
/// coefficients are complex. Short input may grow to kShortInteger bits (1200 digits), none beyond
/// kLongestInteger (2500 digits).
inline constexpr std::size_t kBitGrowth = 128;
inline constexpr std::size_t kShortInteger = 4096;
inline constexpr std::size_t kLongestInteger = 8192;

/// x_variable = constant + sum_k coefficient_k x_place_k, places in the original numbering.
struct Substitution {
  std::size_t variable = 0;
  std::vector<std::pair<std::size_t, Coefficient>> terms;
  Coefficient constant;
};

/// Something that need not be tracked, and the reason.
struct Omission {
  std::string what;
  std::string why;
};

struct Reduction {
  enum class Verdict {
    square,        ///< as many equations as unknowns left: to be solved
    solved,        ///< nothing left: the one root is restore({})
    inconsistent,  ///< a combination of the equations is a nonzero constant: no root
    dependent,     ///< equations proved to be 0 = 0, or unknowns appear nowhere: no isolated root
    underdetermined,  ///< fewer equations than unknowns were given: no isolated root
    overdetermined    ///< more equations than unknowns are left
  };

  Verdict verdict = Verdict::square;
  System system;                         ///< R, with F's groups as far as their unknowns are kept
  CoefficientErrors errors;              ///< of R, from F's, to first order
  std::vector<std::size_t> kept;         ///< places of the kept unknowns, ascending
  std::vector<IsotropicPair> isotropic;  ///< places in y where R is in u and v instead
  std::vector<Substitution>
      substitutions;  ///< in order: each names kept unknowns and those of later ones
  std::vector<std::size_t>
      equation_origin;  ///< for each equation of R the number of the one it stands for
  std::size_t dependent_equations = 0;  ///< found to be 0 = 0
  std::vector<Omission> left_out;       ///< what was done, in sentences
};

std::string to_string(Reduction::Verdict verdict);

/// stop: once set the elimination ends with what is done, which is a reduction too.
Reduction eliminate(const System& f, const std::atomic<bool>* stop = nullptr);

/// x from y, over any scalar with + and *: `round` makes the scalar of an exact coefficient.
template <typename Scalar, typename Round>
std::vector<Scalar> restore(const Reduction& reduction, const std::vector<Scalar>& y, Round round) {
  std::vector<Scalar> x(reduction.kept.size() + reduction.substitutions.size());
  std::vector<Scalar> kept = y;
  leave_isotropic(reduction.isotropic, kept, round);
  for (std::size_t i = 0; i < reduction.kept.size(); ++i) x[reduction.kept[i]] = kept.at(i);
  for (auto s = reduction.substitutions.rbegin(); s != reduction.substitutions.rend(); ++s) {
    Scalar value = round(s->constant);
    for (const auto& [place, coefficient] : s->terms) {
      value = value + round(coefficient) * x[place];
    }
    x[s->variable] = value;
  }
  return x;
}

std::vector<std::complex<double>> restore(const Reduction& reduction,
                                          const std::vector<std::complex<double>>& y);

/// y of a point x that is restore(y).
std::vector<std::complex<double>> kept_of(const Reduction& reduction,
                                          const std::vector<std::complex<double>>& x);

/// The same roots, R in isotropic unknowns (isotropic.h). Requires that it is not yet.
Reduction in_isotropic(Reduction reduction, const std::vector<IsotropicPair>& pairs);

}  // namespace moivre
