// SPDX-License-Identifier: MIT
// How is a family learned? A random complex member is solved like any other system, or loops of the
// parameters lead from one known root to the others; the regular roots are kept.
//
// By solving:
//   p*_j = s_j r_j e^{i phi_j},  r_j in [1/2, 3/2], phi_j at random from the seed;  s_j: the
//                                typical size of p_j
//
// Throws std::invalid_argument, before any tracking, when names are unknown or occur twice, or when
// the number of equations is not that of the other names. A set `stop` ends the solve; what it has
// found is kept, and the learning is not complete.
//
// From one root, by monodromy:
//   loop       p* -> a -> b -> p*, straight lines between random complex members: a permutation of
//              the roots at p*
//   trace      on a line p* + s v of members the roots (x, s) form a curve; it meets G(x, s) = s
//              (l(x) - 1) - e in as many points for every e, and the sum over all of them of any
//              linear function of x is linear in e; over a part of them it is not
//
// The test needs the points with l(x) = 1. They are found by the same loops, with the coefficients
// of the bilinear form G as parameters.
// The test shows that no root is missing on those components of the incidence variety {(x, p)} on
// which known roots lie. It does not show that there is no other component with isolated roots. Its
// points are followed back to p*; a new root there was missing. Where a point is lost, and on no
// way found again, nothing is shown.
// Deterministic in the seed.
// Edges: parameters enter as polynomials; roots that are not regular at generic p are not met.
// Source: [LRS18] for the trace test of such curves, [DHJLLS19] for loops.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "moivre/family/family.h"

namespace moivre {

/// A name of the system, and the size that values of it typically have.
struct NamedParameter {
  std::string name;
  double size = 1;
};

/// The system with the parameters behind the unknowns, each in the order given; nothing is learned
/// yet.
Family unlearned_family(const System& system, const std::vector<NamedParameter>& parameters);

/// p* of a seed, of 20 bits beside the parameters' sizes.
Point generic_member(const Family& family, std::uint64_t seed);

/// The family with its roots. options: of the solve.
Family learn(Family unlearned, const Tracker& tracker, const SolveOptions& options = {},
             const std::atomic<bool>& stop = std::atomic<bool>{false});

struct LoopProgress {
  int loops = 0;
  std::size_t roots = 0;
};

struct MonodromyOptions {
  std::uint64_t seed = 1;
  int threads = 1;
  int quiet_loops = 10;  ///< without a new root, after which the search ends
  int most_loops = 1000;
  std::size_t most_roots = 1'000'000;  ///< no further loop where there are more
  int other_pairs =
      20;  ///< random roots, which belong to another component where loops do not lead to them
  bool test = true;  ///< the trace test, where the roots are no more than `most_tested`
  std::size_t most_tested = 2000;
  bool certify = true;                                ///< each root
  Observations* observations = nullptr;               ///< as SolveOptions::observations
  std::function<void(const LoopProgress&)> progress;  ///< called after each loop
};

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const MonodromyOptions& options);

/// Whether all roots of the components were found.
struct TraceTest {
  bool was_made = false;
  bool holds = false;
  std::size_t points = 0;   ///< of the curve on a bilinear form, the roots at p* among them
  std::size_t missing = 0;  ///< roots at p* that the curve has and the family has not
  std::size_t lost = 0;     ///< points that no path could be followed from: the test is not made
  double defect = 0;        ///< how far the sums are from linear, beside their size
};

/// A pair: F(x; p) = 0 to a few digits, x regular.
struct KnownPair {
  Point x, p;
};

/// A random complex root of a random complex member: Newton's method in x and p together, the
/// shortest corrections first, from unknowns of this size. nullopt where it leads to no regular
/// root from 64 random beginnings.
std::optional<KnownPair> random_pair(const Family& family, std::uint64_t seed, double size = 1);

/// A set `stop` keeps what was found. Throws InvalidInput where the pair is no regular root, or of
/// another size.
Family learn_by_monodromy(Family unlearned, const KnownPair& pair, const Tracker& tracker,
                          const MonodromyOptions& options = {},
                          const std::atomic<bool>& stop = std::atomic<bool>{false});

/// Of a learned family, or of one that lacks roots.
TraceTest trace_test(const Family& family, const Tracker& tracker,
                     const MonodromyOptions& options = {},
                     const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
