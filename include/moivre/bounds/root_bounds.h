// SPDX-License-Identifier: MIT
// How many isolated roots can a square system have at most? All bounds that are known without
// following a path.
//
//   Bezout             d_1 d_2 ... d_n of what exact elimination leaves (polynomial/eliminate.h,
//                      which keeps the roots)
//   multihomogeneous   the least number of the partitions tried (start/multihomogeneous.h)
//                      [MorganSommese87]
//   stable mixed volume   of the monomials (start/mixed_volume.h) [HuberSturmfels97]; it counts
//                         only if two
//                      independent liftings give the same sum, since a search could miss cells;
//                      once more in isotropic unknowns (polynomial/isotropic.h), where it is less
//                      so and nothing else is met
//   quotient ring      its dimension (algebra/quotient_ring.h), which is the number of roots
//                      itself [Buchberger65]
//   mixed volume of the strata   of the system as given, where an equation lacks a constant term
//                                (start/strata.h) [Bernstein75]
//
// Each bounds the isolated roots in C^n, counted with multiplicity; but the last bounds their
// points, whatever their multiplicity. If as many certified roots are pairwise distinct, they are
// all.
// The search for mixed cells and the algebra have a bounded number of steps. Edges: elimination
// alone may give the number of isolated roots; then there is one bound, `elimination`. Not
// supported: systems that are not square; bounds beyond 64 bits have no value.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

enum class BoundKind {
  elimination,
  bezout,
  multihomogeneous,
  mixed_volume,  ///< where no support lacks 0: the stable one is no other
  stable_mixed_volume,
  quotient_ring,
  strata
};
/// "elimination", "Bezout", "multihomogeneous", "mixed volume", "stable mixed volume",
/// "dimension of the quotient ring", "mixed volume of the strata".
std::string to_string(BoundKind kind);
/// As results of solves and families call it: "total degree", "multihomogeneous number", and the
/// others as above.
std::string name_in_results(BoundKind kind);
/// Of that name; nullopt where none is called so.
std::optional<BoundKind> bound_named(const std::string& name);

/// On what the value of a bound rests.
enum class Certainty {
  theorem,       ///< and exact integers
  two_liftings,  ///< mixed cells of two independent liftings, whose volumes agree
  drawn_prime    ///< exact algebra modulo a prime that is drawn by the run's seed
};
Certainty certainty_of(BoundKind kind);
/// "theorem", "two liftings", "drawn prime".
std::string to_string(Certainty certainty);

struct RootBound {
  BoundKind kind = BoundKind::bezout;
  std::optional<std::uint64_t> value;
  std::string missing;  ///< the reason, where there is no value
};

struct KnownRoots {
  std::uint64_t roots = 0;   ///< with their multiplicities
  std::uint64_t points = 0;  ///< at which they lie

  /// What a bound of this kind bounds.
  std::uint64_t count(BoundKind kind) const { return kind == BoundKind::strata ? points : roots; }
};

/// Bounds in the order of their cost, up to the first one that `known` roots meet; no bound can be
/// lower. Throws std::invalid_argument when F is not square. Once `stop` is set the bounds that are
/// not known yet are missing.
std::vector<RootBound> root_bounds(const System& f, const KnownRoots& known,
                                   const std::atomic<bool>* stop = nullptr);

/// That one alone, of F as it is, without elimination; `elimination` has no value then.
RootBound root_bound(const System& f, BoundKind kind, const KnownRoots& known,
                     const std::atomic<bool>* stop = nullptr);

/// Two counts of paths that starts have; nullopt beyond 64 bits, or beyond a bounded search.
struct StructureCounts {
  std::optional<std::uint64_t> multihomogeneous;  ///< the least found
  bool is_least = false;                          ///< all partitions were tried
  std::optional<std::uint64_t> mixed_volume;      ///< with a constant added to each equation
};
/// Of a square system without zero polynomials (std::invalid_argument); `multihomogeneous` and the
/// mixed volume are computed only where wanted.
StructureCounts structure_counts(const System& f, bool with_partitions, bool with_cells,
                                 const std::atomic<bool>* stop = nullptr);

}  // namespace moivre
