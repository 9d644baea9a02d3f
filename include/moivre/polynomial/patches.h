// SPDX-License-Identifier: MIT
// How does a system in homogeneous coordinates become one in affine space? One linear equation a .
// x_j = 1 a group.
//
//   A point of projective space is a line of vectors. The patch of group j selects the vector with
//   a . x_j = 1. The numbers a are random real rationals from the seed (so real roots stay real),
//   of size 1/2 to 3/2, multiples of 2^-kPatchBits. For all but a few seeds in 2^kPatchBits no root
//   has a . x_j = 0. Isolated roots in the product of projective spaces are isolated roots of the
//   patched system, with the same multiplicity, and none of them is at infinity.
//
// The point found depends on the seed; normalized() gives coordinates that do not: in each group
// the first coordinate whose modulus is near the group's largest becomes 1.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

inline constexpr int kPatchBits = 20;
/// "Near the largest": at least this part of it, so that rounding does not decide between
/// coordinates of equal modulus. Roots hardly ever have exactly this ratio.
inline constexpr double kNearLargest = 0.87;

bool has_homogeneous_groups(const System& f);
/// As many equations as unknowns, all of them affine: F can be tracked as it is.
bool is_square(const System& f);

/// F with a patch behind its equations for each homogeneous group; all groups of the result are
/// affine.
/// Throws std::invalid_argument where a polynomial is not homogeneous in such a group.
System with_patches(const System& f, std::uint64_t seed);

/// The degrees that p's terms have in these variables (ascending).
std::set<std::uint64_t> degrees_in(const Polynomial& p,
                                   const std::vector<std::uint32_t>& variables);
/// Are they one? (The zero polynomial: yes.)
bool is_homogeneous(const Polynomial& p, const std::vector<std::uint32_t>& variables);

/// x, all n coordinates, with each homogeneous group scaled; a group that is zero or not finite
/// stays as it is.
Point normalized(const std::vector<VariableGroup>& groups, Point x);

}  // namespace moivre
