// SPDX-License-Identifier: MIT
// Is a singular root isolated, or does it lie on a curve of roots?
//
// Through x lies a plane l (y - x) = 0; moved by a step h, does it meet roots beside x? On a curve
// (or more) it does, and the root comes to x as h -> 0; beside an isolated root of multiplicity m,
// |F| stays near h^m.
//
//   start    at x + N c, N the null space of J(x), c random on the moved plane: where curves cross,
//            N is wider than each of them, and which is met depends on where one starts
//   cut      where J and the plane leave something free the set is a surface: further planes,
//            through x, are added as long as they meet it, until it is a curve
//   settle   Gauss-Newton on F(y) = 0, l (y - x) = h; J in double, y and F in double-double from
//            the exact coefficients
//   descend  h is halved, again and again, and the root followed
//   arrive   y(h), a power series in h, is extrapolated to h = 0: it has to be x, as far as x is
//            known. A set that passes beside x is not met there, however near it comes. What has no
//            limit that is known better than the last h is no power series: there |F| only passes
//            for 0.
//
// Coefficients that were rounded, as those of an angle's cosine, leave no exact set: there |F|
// within their error is a set all the same, where it does not fall as h^m does. So is one that is
// small only as a set passed by rounding, or of several sheets, is.
// That is `blurred`: more digits may show roots there. Two of several planes have to agree. A plane
// that meets a set at a small angle knows its limit badly; where another one meets a set that
// passes beside x, and no farther than that error, it tells nothing.
// x: n, F: n rows, each relative to its terms; J with columns scaled by the natural sizes of the
// coordinates.
// Not supported: isolated roots at which F vanishes along a curve to an order above 12.
// Source: [SommeseWampler05, ch. 13], local dimension by slicing.
#pragma once

#include <atomic>
#include <cstdint>

#include "refine.h"

namespace moivre {

enum class SetHere : std::uint8_t {
  none,
  blurred,  ///< |F| does not vanish on it but for rounding, of coefficients or of J
  sharp
};

/// program: F as given. x: a singular root of F, n coordinates, known to `tolerance`, relative to
/// max(1, |x|_inf). Once `stop` is set the answer comes at once and means nothing.
SetHere set_through(const RefinerProgram& program, const Point& x, double tolerance,
                    std::uint64_t seed, const std::atomic<bool>* stop = nullptr);

}  // namespace moivre
