// SPDX-License-Identifier: MIT
// To how many digits is a root known? To any given number: Newton's method in multiprecision, with
// a bound.
//
//   dx = -J(x)^{-1} F(x),  beta = |dx|,  gamma >= sup_k |J^{-1} D^k F / k!|^{1/(k-1)},  alpha =
//                                        beta gamma
//   alpha < (13 - 3 sqrt 17) / 4  ==>  exactly one root x*, |x - x*| <= 2 beta, Newton converges
//                                      quadratically
//
// F: n polynomials in n unknowns, its rational coefficients rounded at the working precision and
// never before, so that the digits are those of the file's system. gamma is bounded from the
// coefficients' norms, and beta takes in what rounding did to F(x). The working precision doubles
// with the digits that are right; it goes on until the bound covers the digits asked for. Bounds
// are evaluated in the working precision, not in intervals.
// A singular root has no such bound: `converged` is false, and no digit is given.
// Not supported: systems that are not square. Source: [ShubSmale93], [HauensteinSottile12].
#pragma once

#include <atomic>
#include <limits>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/numeric/double_double.h"
#include "moivre/polynomial/system.h"

namespace moivre {

inline constexpr int kMostDigits = 1000;

/// x + finer[0] + finer[1] + ...
struct ApproximateRoot {
  Point x;
  std::vector<Point> finer = {};
};

struct ReferenceRoot {
  bool converged = false;  ///< the bound covers the digits asked for; else what follows is empty
  std::vector<ComplexDecimal> x;  ///< n coordinates; each part has the digits asked for or is "0"
  std::vector<ComplexDoubleDouble> nearest;  ///< the same, rounded to double-double
  /// log10 of the bound on |x - x*|_inf / max(1, |x*|_inf), before x was rounded to what is given.
  double bound_log10 = std::numeric_limits<double>::infinity();
  /// |given - x*|_inf / max(1, |x*|_inf): the error of the approximation.
  double forward_error = std::numeric_limits<double>::quiet_NaN();
  /// log10 of each Newton correction, relative to max(1, |x|_inf).
  std::vector<double> corrections_log10;
  int working_digits = 0;  ///< of the highest precision that was needed; 0: not begun
};

/// The root that Newton's method reaches from each of `approximations`, to `digits` significant
/// digits.
/// threads: how many work on it; the result does not depend on them. Once `stop` is true no further
/// root is begun; those have working_digits = 0. Throws std::invalid_argument when digits is not
/// in [1, kMostDigits], F is not square or an approximation has another dimension.
std::vector<ReferenceRoot> reference_roots_near(
    const System& f, const std::vector<ApproximateRoot>& approximations, int digits,
    int threads = 1, const std::atomic<bool>& stop = std::atomic<bool>{false});

/// From points of double.
std::vector<ReferenceRoot> reference_roots(const System& f,
                                           const std::vector<Point>& approximations, int digits,
                                           int threads = 1);

}  // namespace moivre
