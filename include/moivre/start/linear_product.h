// SPDX-License-Identifier: MIT
// Which system has exactly as many roots as the groups allow, all of them by linear algebra?
// Products of factors by group.
//
//   G_i(x) = prod_j G_ij(x),  G_ij of degree d_ij in the unknowns x_j of group j alone:
//     group of one unknown:  G_ij = c1 x^{d_ij} - c2, factors x - (roots of c2/c1 by De Moivre's
//                            theorem)
//     larger group:          G_ij = prod_{k=1..d_ij} L_ijk,  L_ijk = a . x_j + b, random complex
//   A root of G chooses a factor of every equation such that group j is chosen n_j times; the n_j
//   factors are then linear equations for x_j. Path number -> choice by c(r) (multihomogeneous.h),
//   so that start points are computed, never stored.
//
// For almost every choice of constants no two chosen linear systems share a root, and none is
// singular. To avoid nearly singular ones, several random factors are drawn and the one farthest
// from the existing factors is taken. The constants are multiples of 2^-kConstantBits, so that
// products of a few of them are exact in double.
//
// Edges: a number of 0 means that there is no path. A number beyond 64 bits, or with too large a
// table, is refused (std::overflow_error). For a single group of all unknowns the total-degree
// start has fewer terms.
// Source: [MorganSommese87]; [Wampler93]; [SommeseWampler05, ch. 8].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"
#include "moivre/start/multihomogeneous.h"

namespace moivre {

inline constexpr int kConstantBits = 12;
/// A start system with more terms than this is not expanded.
inline constexpr std::uint64_t kMaximumStartTerms = 50'000;

/// G_ij. Group of one unknown: c1 = forms[0][0], c2 = -forms[0][1] whatever d_ij > 0 is. Larger
/// group: forms[k] is L_ijk, (a_1, ..., a_{n_j}, b), one form for each of d_ij factors. d_ij = 0:
/// no form, G_ij = 1.
struct GroupFactor {
  std::vector<Point> forms;
};

struct LinearProductStart {
  Partition groups;
  GroupDegrees degrees;
  std::vector<std::vector<GroupFactor>> factors;  ///< row i = equation i, column j = group j
  std::vector<std::uint64_t> completions;         ///< c(r), as completion_table gives it
  std::uint64_t paths = 0;
};

/// `degrees`: n equations (std::invalid_argument where their number is not that of the unknowns, or
/// an equation is a constant).
LinearProductStart linear_product_start(const GroupDegrees& degrees, const Partition& groups,
                                        std::uint64_t seed);
/// For the groups of F given.
LinearProductStart linear_product_start(const System& f, const Partition& groups,
                                        std::uint64_t seed);

/// Terms of G multiplied out, before anything is: what a model of the costs needs. Saturates at
/// 2^64 - 1.
std::uint64_t linear_product_terms(const GroupDegrees& degrees, const Partition& groups);

/// G as a system in the same variables, multiplied out exactly; nullopt where it has more terms
/// than kMaximumStartTerms.
std::optional<System> start_system(const LinearProductStart& start,
                                   const std::vector<std::string>& variables);

/// Start point of path `number` < paths in homogeneous coordinates: (x_1, ..., x_n, 1).
Point start_point(const LinearProductStart& start, std::uint64_t number);

}  // namespace moivre
