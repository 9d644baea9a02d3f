// SPDX-License-Identifier: MIT
// How many roots does a system have, and how many different ones? The dimension of its quotient
// ring, and the degree of a squarefree polynomial, by exact algebra: no tracking, no rounding.
//
//   f: any number of equations in n unknowns, coefficients exact; p a prime of 61 bits
//   dimension = monomials that no leading monomial of a Groebner basis of f modulo p divides,
//   degree reverse lexicographic order simple = the same of f and z det(df_i / dx_j) - 1 in n + 1
//   unknowns [Rabinowitsch29]: its roots are the simple roots of f
//
// Where all roots are isolated the dimension is the number of roots in C^n, each counted with its
// multiplicity; those at infinity do not count. Leading monomials found so far bound it already. A
// random linear form of the unknowns takes different values at different roots: they are the roots
// of the minimal polynomial of the multiplication by it [Wiedemann86]. It is drawn with p.
// Chance: what vanishes modulo p only would give another number. p is drawn from the numbers of f,
// so that no file is made for it, and divides none of them: the probability is about 1e-18 for each
// number met. Roots on curves make the dimension infinite. They are all singular, and the simple
// ones are counted instead.
// Not supported: no unknown, or more than 15; degrees beyond 255; no more terms are looked at than
// allowed.
// Sources: [Buchberger65], which pairs are needed [GebauerMoeller88].
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "moivre/polynomial/system.h"

namespace moivre {

struct QuotientRing {
  enum class Verdict { finite, infinite, not_found };

  Verdict verdict = Verdict::not_found;
  std::uint64_t dimension = 0;          ///< where finite
  std::optional<std::uint64_t> points;  ///< different roots, where finite and asked for
  /// Simple roots, where infinite (else where asked for), found, and f has as many equations as
  /// unknowns; or the common roots of f that are simple ones of QuotientRingOptions::square.
  std::optional<std::uint64_t> simple;
};

/// A fifth of a second, at some ten nanoseconds each.
inline constexpr std::uint64_t kAffordableTerms = 20'000'000;

struct QuotientRingOptions {
  std::uint64_t known = 0;  ///< so many roots are there: at this bound the search ends
  std::uint64_t most_terms = kAffordableTerms;  ///< to be looked at
  const std::atomic<bool>* stop = nullptr;
  /// Takes as many more multiplications as the cube of the dimension; given up beyond most_terms.
  bool counts_points = false;
  std::uint64_t seed = 1;      ///< another one draws another prime and another linear form
  bool counts_simple = false;  ///< also where the dimension is finite
  const System* square =
      nullptr;  ///< n combinations of f's equations, whose simple roots are counted
};

QuotientRing quotient_ring(const System& f, const QuotientRingOptions& options);

}  // namespace moivre
