// SPDX-License-Identifier: MIT
// Which roots has a real polynomial in one unknown, all of them, and how often? By proof:
// squarefree factors, then discs that part them.
//
//   p = c q_1 q_2^2 q_3^3 ...   q_k squarefree, coprime, by exact algebra; a root of q_k is one of
//                               p of multiplicity k
//
// Each disc holds exactly one root, however near the next one is: a library of ball arithmetic
// takes as many bits as that needs.
// Edges: p of degree 0 has no roots; simple ones of a factor of large degree are counted, not
// isolated. Not supported: coefficients that are not real; degrees and coefficients beyond the
// limits below;
// a program built without Arb.
// Sources: [Johansson17], FLINT.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// Of p, which is written out with a coefficient for each power.
inline constexpr std::uint64_t kMostWrittenDegree = 1'000'000;
/// Of a squarefree factor, a second or two; and bits of all coefficients together.
inline constexpr std::uint64_t kMostIsolatedDegree = 128;
inline constexpr std::uint64_t kMostIsolatedBits = 1'000'000;

struct IsolatedRoot {
  std::vector<Complex> parts;  ///< the disc's midpoint is their sum, largest first
  double error = 0;            ///< the root is no farther from it
  double radius = 0;           ///< within this distance there is no other root
  std::uint64_t multiplicity = 1;
};

struct IsolatedRoots {
  std::vector<IsolatedRoot> roots;
  std::uint64_t other_simple = 0;  ///< roots of q_1 where its degree is too large
};

/// bits: so many of each root are certain at least. nullopt: not supported, or the roots are not
/// separated in so many bits.
std::optional<IsolatedRoots> isolated_roots(const Polynomial& p, int bits);

}  // namespace moivre
