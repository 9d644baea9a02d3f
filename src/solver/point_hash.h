// SPDX-License-Identifier: MIT
// By what is a point known again among many, at 16 bytes each? By its hash, a number that all its
// coordinates have a part in.
//
//   hash = sum_j a_j z_j / |z_j| + b_j log |z_j|,  z_j = x_j / x_n,  a_j and b_j of random phases:
//                                                  the same for all multiples of
//   a homogeneous point, and for different points different but by chance, however small the
//   coordinates in which they differ
//
// Two paths with one hash are at one point: one of them has jumped before. Hashes are kept of the
// points to which paths have come back from their ends.
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/numeric/complex.h"

namespace moivre {

/// x: homogeneous coordinates, none of them 0.
Complex hash_of(const Point& x);

/// So far two hashes of one point may lie apart.
double tolerance_at(Complex hash);

/// Of paths by number; a path without a hash has none.
class PointHashes {
 public:
  void set(std::uint64_t path, Complex hash);
  void forget(std::uint64_t path);

  /// Paths that share a hash with another path, ascending.
  std::vector<std::uint64_t> shared() const;

 private:
  std::vector<Complex> hashes_;  // NaN: none
};

}  // namespace moivre
