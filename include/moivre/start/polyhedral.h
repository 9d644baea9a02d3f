// SPDX-License-Identifier: MIT
// Which start has no more paths than the monomials allow? The polyhedral one: as many as the mixed
// volume.
//
//   G       a generic member: F's supports with 0 added, so that roots with zero coordinates are
//           found too; coefficients of F's moduli and of random phases (modulus 1 for terms that F
//           has not)
//   cell    alpha, w >= 0: with x_j = y_j e^{alpha_j tau} term k of G carries e^{w_k tau}, and two
//           terms of each equation w = 0
//   stage 1 toric, from G's binomials at tau = -T to G at tau = 0:  c_k(t) = g_k e^{-W_k (1 - t)},
//   W = w T stage 2 the straight line from G to F
//
// The lifting is -log |f_k| plus a random part of a few units. Its cells belong to the sizes of the
// roots, so that sizes change little along a path, whatever range the coefficients have. Each cell
// has its own T, so that at the start every other term is at most kLeastPart of the two dominant
// ones. A path number means a cell and a root of its binomials (start/path_index.h,
// start/binomial.h). G has the moduli of F, so that its roots have the sizes of F's roots.
//
// Edges: a mixed volume of 0 is a plan without paths: no isolated roots. Not supported: stable
// cells as starts.
// Sources: [HuberSturmfels95], [LiWang96] for the 0 in every support.
#pragma once

#include "moivre/start/mixed_cells.h"
#include "moivre/start/start_plan.h"

namespace moivre {

/// The supports whose cells polyhedral_plan() takes: those of F, with 0 added.
std::vector<Support> start_supports(const System& f);

/// The mixed cells of start_supports(f) for a lifting by the coefficients of F.
CellSearch start_cells(const System& f, std::uint64_t seed, const CellSearchOptions& options);

/// `cells`: of start_supports(f).
StartPlan polyhedral_plan(const System& f, MixedSubdivision cells, std::uint64_t seed);

}  // namespace moivre
