// SPDX-License-Identifier: MIT
// Where are the roots of a system, all of them, without a path? From its quotient ring over the
// rationals.
//
//   m, N_0 .. N_n   of algebra/ring_image.h, from as many primes as their coefficients need, and
//                   one more that they have to agree with
//   z               the roots of m, isolated on its squarefree factors; e_z how often m has z
//   x_j = N_j(z) / N_0(z)
//
// The multiplicity of a root is e_z at least. So where the sum of all e_z is the dimension of the
// ring, they are the multiplicities.
// Where a coefficient is not real, i is one more unknown with i^2 + 1 = 0; those roots are taken
// in which it is i.
// For systems with few roots whose paths are hard: many that go to infinity together, roots of size
// 1e5 beside others of size 1e-4. The number of primes grows with the digits of m, some hundred for
// a dozen roots of a system whose coefficients have four.
// Nothing is proved here: what vanishes modulo a prime by chance, or two roots on which u takes one
// value, would tell too few. The caller proves each root on the system itself, and knows from the
// dimension how many there are.
// Not supported: as algebra/ring_image.h; more than 128 roots; a program built without Arb.
// Sources: [Rouillier99], [Johansson17], FLINT.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// Roots, with their multiplicities.
inline constexpr std::uint64_t kMostRingPoints = 128;

struct RingPoint {
  /// By coordinate; each is the sum of its parts, largest first.
  std::vector<std::vector<Complex>> x;
  std::uint64_t exponent = 1;  ///< e_z
};

struct RingPointsOptions {
  std::uint64_t most_terms = 0;  ///< of all primes together
  const std::atomic<bool>* stop = nullptr;
  std::uint64_t seed = 1;
  int bits = 256;  ///< so many of each coordinate are certain, relative to the largest one
};

/// Whether each e_z is the root's multiplicity; dimension: of the ring.
bool are_multiplicities(const std::vector<RingPoint>& points, std::uint64_t dimension);

/// nullopt where it is given up.
std::optional<std::vector<RingPoint>> ring_points(const System& f,
                                                  const RingPointsOptions& options);

}  // namespace moivre
