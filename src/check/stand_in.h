// SPDX-License-Identifier: MIT
// Which square system is judged for the file's? The file's own where it can be.
//
//   square                itself, or the bases of its equations where these are powers
//                         (polynomial/powers.h): the same roots, with `sheets` times less
//                         multiplicity
//   fewer equations       the slices of the result's seed are appended (polynomial/square_up.h):
//                         the roots are witness points
//   more equations        random combinations of a seed of the judge's own: a root of them need not
//                         be one of the file
//   homogeneous groups    a patch a group (polynomial/patches.h); points are brought onto it
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

struct StandIn {
  System system;
  std::string name;  ///< empty: the file's own
  bool has_all_roots =
      true;  ///< its isolated roots are those that are claimed: bounds on it bound them
  bool proves_roots = true;  ///< a root of it is one of the file
  std::uint64_t sheets =
      1;  ///< of each multiplicity, bound and count of paths of the file, 1 is the stand-in's
  std::vector<Polynomial> patches;  ///< a . x_j - 1, one for each homogeneous group
  bool has_patches() const { return !patches.empty(); }
};

/// Powers are taken apart only where `counts_paths`. Throws std::invalid_argument where the file's
/// groups cannot be patched.
StandIn make_stand_in(const System& f, std::uint64_t seed, bool counts_paths);

/// x on the patches of the stand-in; x itself where there are none.
Point on_patches(const StandIn& stand_in, Point x);

}  // namespace moivre
