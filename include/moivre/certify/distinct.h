// SPDX-License-Identifier: MIT
// Are these roots distinct? A sweep finds the pairs whose balls overlap, and the balls are made
// smaller until it is proved.
//
//   distinct:  |m_a - m_b|_j > error_a_j + error_b_j for some coordinate j
//   the same:  |m_a - m_b|_j + error_a_j <= radius_b_j for all j: the root of a lies in the ball of
//              b, where there is but one
//
// The sweep sorts the points' projections on a random direction. Only pairs whose intervals overlap
// are compared, in exact rational arithmetic where double does not tell. It takes N log N steps,
// and one for each such pair. A pair that is neither distinct nor the same is in doubt: two
// overlapping balls prove nothing. Certificates that hold no root are left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "moivre/certify/certifier.h"

namespace moivre {

using IndexPair = std::pair<std::size_t, std::size_t>;  ///< first < second

enum class Relation { distinct, same, doubtful };

/// Of two certificates that hold a root, of one system.
Relation relation(const Certificate& a, const Certificate& b);

struct Distinctness {
  /// For each certificate the first one with the same root; itself where it is the first, or holds
  /// none.
  std::vector<std::size_t> first_of;
  std::vector<IndexPair> same;  ///< pairs proved to be one root; chains of them make up first_of
  std::vector<IndexPair> doubtful;  ///< neither proved distinct nor proved the same, in order
  std::size_t holding = 0;          ///< certificates that hold a root
  /// The number of different roots that is proved; exact if nothing is in doubt.
  std::size_t distinct_roots = 0;
};

/// seed: of the random direction; it changes the work, never the result. Of certificates that lie
/// anywhere too: there may be too many to copy.
Distinctness compare(std::span<const Certificate> certificates, std::uint64_t seed = 1);
Distinctness compare(std::span<const Certificate* const> certificates, std::uint64_t seed = 1);

/// As compare, but doubtful certificates are sharpened by doubling the precision, up to the
/// certifier's most_bits.
Distinctness tell_apart(Certifier& certifier, std::span<Certificate> certificates,
                        std::uint64_t seed = 1);

}  // namespace moivre
