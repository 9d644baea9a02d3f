// SPDX-License-Identifier: MIT
// At which time between solved ones may a pair of complex closures be real? The vertex of a parabola through its distances.
//
// A root x of the closure polynomials and its image y, y_v = conj(x_mirror(v)), are one where x is real. Of a pair that is not,
//   s(t) = sum_v |x_v - y_v|^2 > 0
// and where pairs become real, s goes on below zero, analytic in t: -s is the squared distance of the two real closures. So s
// has a simple root at a dead point, and a short stretch of real closures is a parabola that dips below zero.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "moivre/formulation/formulation.h"
#include "moivre/solver/solve.h"

namespace moivre {

/// A complex closure with its image.
struct ComplexPair {
  Point x;
  Point image;
  double square = 0;  ///< s
};

/// One of each pair among the closures of one time; singular ones are left out.
std::vector<ComplexPair> complex_pairs(const Formulation& formulation,
                                       const std::vector<Solution>& closures);

/// The pair that x went over to: the one whose root or image is nearest; nullptr where there is none.
const ComplexPair* nearest_pair(const std::vector<ComplexPair>& pairs, const Point& x);

/// s at a time.
struct DistanceFromReal {
  double time = 0;
  double square = 0;
};

/// Where s may be near or below zero: the vertex of the parabola through three points (by time), where it lies between the outer
/// two and is well below all three; else nothing.
std::optional<double> time_near_real(const std::array<DistanceFromReal, 3>& points);

}  // namespace moivre
