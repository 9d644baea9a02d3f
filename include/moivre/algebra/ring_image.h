// SPDX-License-Identifier: MIT
// Where on a line do the roots of a system stand, and where is each coordinate there? Exact
// algebra's answer, modulo one prime.
//
//   f: any number of equations in n unknowns; D the dimension of its quotient ring A = Q[x] / (f),
//   finite
//   u = c_1 x_1 + ... + c_n x_n, c small integers;   l a linear form on A, small integers on its
//   monomials
//   m(z) the minimal polynomial of u in A, d its degree:   sum_k l(u^k) z^(-k-1) = N_0(z) / m(z)
//   N_j the same with l(u^k x_j), j = 1 .. n
//
// Each root xi of f has a value z of u, which is a root of m; where u takes different values at
// different roots, x_j = N_j(z) / N_0(z). A root of m is simple where the root of f is. c and l are
// the same for every prime; so m and the N_j are images of polynomials over the rationals, which
// are found from enough primes (certify/ring_points.h).
// Edges: what vanishes modulo the prime only gives an image of something else; primes with another
// staircase are told apart by `staircase`.
// Not supported: as quotient_ring.h; coefficients that are not real.
// Sources: [Rouillier99], [Wiedemann86], [BostanSalvySchost03].
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "moivre/numeric/fingerprint.h"
#include "moivre/polynomial/system.h"

namespace moivre {

struct RingImage {
  std::uint64_t prime = 0;
  std::uint64_t terms = 0;             ///< that were looked at, products by the matrix among them
  Fingerprint staircase;               ///< of its monomials
  std::vector<std::uint64_t> minimal;  ///< m from the constant on; monic
  std::vector<std::vector<std::uint64_t>> numerators;  ///< N_0, N_1 .. N_n, d coefficients each
};

struct RingImageOptions {
  std::uint64_t most_terms = 0;
  std::uint64_t most_dimension = 0;
  const std::atomic<bool>* stop = nullptr;
  std::uint64_t seed = 1;   ///< draws c and l
  std::uint64_t prime = 0;  ///< another number, another prime
};

/// nullopt where it is given up, the dimension is infinite or too large, or a coefficient is not
/// real.
std::optional<RingImage> ring_image(const System& f, const RingImageOptions& options);

}  // namespace moivre
