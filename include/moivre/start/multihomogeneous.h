// SPDX-License-Identifier: MIT
// How many roots can a system with grouped unknowns have, and which groups give the fewest? The
// multihomogeneous Bezout number.
//
//   The n unknowns are parted into k groups of sizes n_1 + ... + n_k = n; d_ij = degree of F_i in
//   the unknowns of group j.
//   Number = coefficient of z_1^{n_1} ... z_k^{n_k} in prod_i (d_i1 z_1 + ... + d_ik z_k): isolated
//   roots of F in C^n, with multiplicity, are at most so many [MorganSommese87]. One group: the
//   total degree.
//
// The coefficient is found over the table of exponent vectors: c(r) = sum_j d_ij c(r - e_j), i = n
// - |r|, the number of ways in which equations i, i+1, ... take r_j factors of group j. Numbers
//   beyond 64 bits are seen.
//
// Which groups: with few unknowns all partitions are tried, after [Wampler92]. With more, the
// search starts from several partitions (unknowns that never multiply each other, that are in the
// same equations, ...). It improves each by moving or exchanging unknowns and joining groups,
// similar to [LiLinBai03]. The answer is deterministic, but not always the least. The work is
// bounded, in proportion to the paths of the total degree, since a longer search would save
// nothing.
//
// Edges: the number 0 says that F has no isolated root in C^n. F must be square, with no zero
// polynomial (std::invalid_argument). Not supported: groups that overlap, supporting hyperplanes
// (mixed volumes).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

/// Every unknown in one group; unknowns in a group ascending, groups in the order of their first
/// unknowns.
using Partition = std::vector<std::vector<std::uint32_t>>;

/// d_ij, row i = equation i, column j = group j.
using GroupDegrees = std::vector<std::vector<std::uint64_t>>;

/// All partitions are tried of at most so many unknowns (Bell's number of 8: 4140), if the work
/// allows it.
inline constexpr std::size_t kExhaustiveUnknowns = 8;
/// Most entries of the table, prod_j (n_j + 1); a partition that needs more has no number here.
inline constexpr std::uint64_t kMaximumTable = std::uint64_t{1} << 20;
/// Products and sums that one search may cost (some 4 ns each): a path of the total degree takes
/// longer than kSearchWorkPerPath of them; no less than a millisecond, no more than a fifth of a
/// second.
inline constexpr std::uint64_t kSearchWorkPerPath = 2'000;
inline constexpr std::uint64_t kLeastSearchWork = 250'000;
inline constexpr std::uint64_t kMostSearchWork = 50'000'000;

Partition one_group(std::size_t unknowns);

/// The groups that F declares, homogeneous or not; nullopt where it declares none.
/// Throws std::invalid_argument where they do not hold every unknown just once.
std::optional<Partition> declared_partition(const System& f);

/// Throws std::invalid_argument where `groups` does not hold every unknown of F just once.
GroupDegrees group_degrees(const System& f, const Partition& groups);

/// c(r) for all r <= (n_1, ..., n_k), r_1 counted fastest; the last one is the number of paths.
/// Entries saturate at 2^64 - 1. nullopt where the table would be larger than kMaximumTable.
std::optional<std::vector<std::uint64_t>> completion_table(const GroupDegrees& degrees,
                                                           const Partition& groups);

/// nullopt where the number leaves 64 bits or the table its limit.
std::optional<std::uint64_t> multihomogeneous_number(const GroupDegrees& degrees,
                                                     const Partition& groups);
std::optional<std::uint64_t> multihomogeneous_number(const System& f, const Partition& groups);

struct PartitionSearch {
  Partition groups;  ///< of the least number found; of several the one with the fewest groups
  std::optional<std::uint64_t>
      paths;                ///< its number; nullopt: every partition tried is beyond 64 bits
  bool is_least = false;    ///< all partitions were tried
  bool is_cut = false;      ///< `most_work` ended the search before its own limits
  std::uint64_t tried = 0;  ///< partitions whose number was found
};

/// declared_partition(f), where there is one, is among those tried. most_work: no more than this
/// either, but a millisecond.
PartitionSearch find_partition(const System& f, std::uint64_t most_work = kMostSearchWork);

}  // namespace moivre
