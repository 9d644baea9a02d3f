// SPDX-License-Identifier: MIT
// Are all isolated roots found, by proof? They are where as many different roots are proved as a
// proved bound allows, multiple ones that are known exactly with their multiplicities.
//
//   elimination            what exact elimination of linear equations decides alone
//   total degree           d_1 ... d_n of what is tracked; elimination keeps the roots one to one
//                          (polynomial/eliminate.h)
//   multihomogeneous       the number of the partition found [MorganSommese87]; any partition's is
//                          a bound
//   quotient ring          the dimension that exact algebra finds (algebra/quotient_ring.h): the
//                          number of roots itself
//   mixed volume           of what is tracked, 0 added to the supports [LiWang96]
//   stable mixed volume    of it, where a support lacks 0 [HuberSturmfels97]
//   mixed volume of the strata   of the system as given, where a support lacks 0 (start/strata.h);
//                                it bounds the points, whatever
//                          their multiplicities, and no curve on which coordinates vanish keeps it
//                          from being met
//
// A mixed volume counts where two liftings that have nothing in common agree: cells found alone are
// a lower bound. A search costs no more than the paths are expected to, and none is begun whose
// number is known not to be met.
// Where paths wait to be followed on, no more than these cost.
// More proved roots than a bound would be a fault of ours: std::logic_error. Private to the module.
#pragma once

#include "run.h"

namespace moivre {

/// Terms of exact algebra that are worth it where these paths would be followed in more digits: in
/// double-double each takes as long as kAffordableTerms; one that double-double has not decided
/// takes all digits.
std::uint64_t terms_instead_of(const Run& run, const PathSet& paths);

/// Following on what waits takes longer than all that exact algebra may look at.
bool is_longest_algebra_worth_it(const Run& run);

/// As many paths end at roots, several at a cluster, as a bound that is known allows: where proofs
/// part the clusters it is met.
bool are_ends_as_many_as_bound(const Run& run);

/// Where a proved bound is met nothing is left in doubt: one path ends at each proved root, at each
/// exact one (exact_roots.h) as many as its multiplicity, some on sets of positive dimension; every
/// other ends at no isolated root, and is not needed.
/// False where none is met, or where fewer paths are left than the exact roots need: that is told
/// as a contradiction.
bool settle_by_bound(Run& run);

/// Exact algebra has counted more roots than are proved, beside sets of positive dimension more
/// simple ones: some path in doubt leads to one. False where it has no count.
bool is_root_missing(Run& run);

/// Fewer paths end at points than exact algebra counts roots with their multiplicities. False where
/// it has no count.
bool lacks_ends(const Run& run);

/// Looks for the quotient ring where it was not worth it before: whether roots are multiple is to
/// be told.
void look_for_ring(Run& run);

/// As many roots with their multiplicities, and as many different ones, as exact algebra counts:
/// then each has its multiplicity.
/// False where algebra has no counts, and where paths end on sets of positive dimension.
bool are_as_counted(Run& run);

/// So many different roots are proved, where exact algebra counts the simple ones.
std::optional<std::uint64_t> roots_to_compare(const Run& run);

/// Why the roots told cannot be all and right: an exact root has fewer paths than its multiplicity,
/// or the dimension of the quotient ring, where it was sought and found, is another. proved:
/// roots_to_compare() of the table with these roots.
std::optional<std::string> contradiction_by_algebra(const Run& run,
                                                    std::optional<std::uint64_t> proved,
                                                    const SolveResult& result);

/// Why a start that was given may not lead to every root; nothing where the roots are counted
/// otherwise.
std::optional<std::string> doubt_of_start(const Run& run);

/// proved, shown or open, and the bound; nothing where no certificates were asked for. Requires a
/// closed account.
void tell_completeness(const Run& run, SolveResult& result);

}  // namespace moivre
