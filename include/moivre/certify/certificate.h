// SPDX-License-Identifier: MIT
// What was proved of a root? Exactly one lies in this ball, at most so far from its midpoint, and
// it is real or not real.
//
//   B = {x : |x_j - m_j| <= radius_j for all j}, discs of the complex plane, one per coordinate
//   proved:  F has exactly one root x* in B, J(x*) is regular, and |x*_j - m_j| <= error_j <
//            radius_j
//
// m: the midpoint, an exact sum of doubles, midpoint + finer[0] + finer[1] + ...; `finer` is empty
// where double was enough.
// radius, error: n numbers in the units of the file, the first rounded down, the second up. What is
// proved holds for the exact coefficients, as they were read.
// A certificate says nothing of other roots outside B. A multiple root has none: there J is
// singular.
// Where F has numbers that are known only to lie in discs (Enclosure), it is proved for all of them
// at once: whatever they are there, F has exactly one root in B.
#pragma once

#include <cstddef>
#include <cstdint>
#include <forward_list>
#include <optional>
#include <span>
#include <vector>

#include "moivre/certify/ball_sizes.h"
#include "moivre/numeric/complex.h"

namespace moivre {

enum class Verdict : std::uint8_t {
  certified,  ///< exactly one root in B, and not farther from the given point than was asked for
  elsewhere,  ///< exactly one root in B, farther from the given point than was asked for
  undecided   ///< nothing was proved; every other field says nothing
};

enum class Reality : std::uint8_t {
  unknown,  ///< not proved; also: the point and its conjugate cannot be compared, F is not real
  real,     ///< every coordinate of the root is real
  not_real  ///< some coordinate of the root has an imaginary part that is not 0
};

/// A number that is known to lie in a disc: |z - (middle + finer[0] + ...)| <= error.
struct Enclosure {
  Complex middle;
  std::vector<Complex> finer;  ///< what the middle has beyond double, largest first
  double error = 0;
};

/// A run may have a million: no byte that few of them need.
struct Certificate {
  Verdict verdict = Verdict::undecided;
  Reality reality = Reality::unknown;
  int bits = 0;  ///< of the arithmetic that proved it: 53 is double
  Point midpoint;
  std::forward_list<Point> finer;  ///< what the midpoint has beyond double, largest first
  BallSizes sizes;

  double radius(std::size_t j) const { return sizes.radius(j); }
  double error(std::size_t j) const { return sizes.error(j); }
  /// One root is proved to lie in B, near the given point or not.
  bool holds_root() const { return verdict != Verdict::undecided; }
};

/// Where coordinate j of the root lies. Requires holds_root().
Enclosure enclosure(const Certificate& certificate, std::size_t j);
bool holds_zero(const Enclosure& z);

/// The same proof with x as its midpoint, a smaller ball; nullopt where x is too near its border,
/// and where the midpoint is known beyond double. Requires holds_root().
std::optional<Certificate> about(const Certificate& certificate, const Point& x);

/// A coordinate of a proved root, and the radius in which there is no other one.
struct ProvedCoordinate {
  Enclosure place;
  double radius = 0;
};

/// Of a root of equations that have with x the root conj(x_mirror(v)), v = 0, 1, ...: real where it
/// is that root, not_real where it is another. mirror: a permutation of the coordinates that undoes
/// itself.
Reality reality_of(std::span<const ProvedCoordinate> root, std::span<const std::size_t> mirror);

}  // namespace moivre
