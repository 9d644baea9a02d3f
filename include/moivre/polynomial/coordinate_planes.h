// SPDX-License-Identifier: MIT
// On which coordinate planes is every equation zero? Sets of roots that are known by looking.
//
//   x_j = 0 for j in Z:  a plane of n - |Z| dimensions, less one for every homogeneous group; every
//                        term of every equation has a factor x_j with j in Z
//
// Told are planes of one dimension or more that lie in no other of them, and on which no
// denominator is zero throughout.
// Exact. Edges: an equation with a constant term leaves none; a projective point has a coordinate
// that is not 0, so a group does not vanish as a whole. Where terms allow very many choices of Z
// some of the planes are not found.
// Not supported: sets that are no coordinate planes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

struct CoordinatePlane {
  std::vector<std::uint32_t> zeros;  ///< Z, ascending
  std::uint64_t dimension = 1;

  friend bool operator==(const CoordinatePlane&, const CoordinatePlane&) = default;
};

/// p where these unknowns are 0, in the same unknowns.
Polynomial on_plane(const Polynomial& p, const std::vector<std::uint32_t>& zeros);

/// Of the plane where these unknowns, ascending, are 0; 0 where a homogeneous group vanishes as a
/// whole.
std::uint64_t plane_dimension(const System& f, const std::vector<std::uint32_t>& zeros);

/// The unknowns that are 0 there.
std::vector<std::string> zero_names(const CoordinatePlane& plane,
                                    const std::vector<std::string>& variables);

/// By dimension, the largest first, and then by Z.
std::vector<CoordinatePlane> coordinate_planes(const System& f);

}  // namespace moivre
