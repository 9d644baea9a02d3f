// SPDX-License-Identifier: MIT
// Where is a function zero between two places at which its signs differ? By algorithm 748 of ACM
// TOMS, which Boost has.
//
// Edges: a function that jumps from one sign to the other has its zero there. Where fa or fb is NaN
// the other end is the answer; NaN in between leads the search astray, but not out of [a, b]. After
// 150 evaluations: the middle of what is left.
#pragma once

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace moivre {

/// The place of a sign change between a and b, to rounding of the larger; a < b, f(a) = fa, f(b) =
/// fb. Where the signs agree after all, or b is not above a: the end at which f is nearer to 0. A
/// zero that f meets ends the search.
template <class Function>
double zero_between(const Function& f, double a, double b, double fa, double fb) {
  const bool has_zero = (fa <= 0 && fb >= 0) || (fa >= 0 && fb <= 0);  // fa fb may underflow
  if (!has_zero || !(a < b)) {
    return std::abs(fa) < std::abs(fb) || std::isnan(fb) ? a : b;
  }
  const double width = 0x1p-50 * std::max(std::abs(a), std::abs(b));
  // A smooth function takes ten; a step, by halves, under three times its binary digits.
  std::uintmax_t most = 150;
  const auto is_narrow = [width](double lower, double upper) { return upper - lower <= width; };
  const auto [lower, upper] = boost::math::tools::toms748_solve(f, a, b, fa, fb, is_narrow, most);
  return (lower + upper) / 2;
}

}  // namespace moivre
