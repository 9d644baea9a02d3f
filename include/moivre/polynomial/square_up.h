// SPDX-License-Identifier: MIT
// Which n equations in n unknowns stand for m equations? Random combinations where m > n, random
// slices where m < n.
//
// m > n: G = [I A] F. The n leading equations are those of highest degree, and among equal degrees
// those with the most terms. A random combination A of all the others is added to each. For almost
// every A this is as good as n random combinations of all:
// every isolated root of F is an isolated root of G, and regular in G if F_x has rank n there. G's
// other roots fail an equation of F and must be dropped (`excess`). No degree of G is above that of
// its leading equation. So the Bezout number is the product of the n highest degrees, the least
// that combinations with constants can guarantee. The equations added everywhere are the shortest,
// so that supports grow least. [SommeseWampler05, ch. 13], randomization.
//
// m < n: n - m random affine linear equations are appended; roots are then witness points of the
// components of dimension n - m, one for each of their degree.
//
// Random numbers: real rationals +-k 2^-kShareBits between 1/2 and 3/2, from the seed; F real stays
// real. An equation is brought to its leading one's size by a power of two first.
#pragma once

#include <cstdint>

#include "moivre/polynomial/system.h"

namespace moivre {

inline constexpr int kShareBits = 20;

/// m >= n; zero polynomials are dropped first. Fewer than n equations are left where fewer are not
/// zero.
/// Throws std::invalid_argument where m < n.
System square_up(const System& f, std::uint64_t seed);

/// m <= n. Throws std::invalid_argument where m > n.
System with_slices(const System& f, std::uint64_t seed);

}  // namespace moivre
