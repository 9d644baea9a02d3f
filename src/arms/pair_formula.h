// SPDX-License-Identifier: MIT
// Which joint values does an eigenvalue problem propose, where no three neighbours make a group?
// The sixteen closures of a general arm.
//
//   f_i(t_1, t_2, t_3, t_4) = 0,  i = 1 ... 4:  the loop cut at two neighbours (cut.h), multilinear
//                                 in the tangents of the others
// t_4 is hidden: with the multipliers t_2^b t_3^c, b <= 1, c <= 2, the four are 24 equations, and
// linear in the 24 monomials of degrees (1, 2, 3) in (t_1, t_2, t_3), as many as there are roots
// [SturmfelsZelevinsky94]:
//   (A + t_4 B) m = 0,  eigenvalues t_4; vectors m tell the other three
// Eight roots, more of special arms, are no closures: a joint has no inverse there, t = +-i. The
// two neighbours are determined by the coordinates of what they must do.
// Nothing is decided here, as with group_formula.h. Where B has no inverse nothing is proposed.
// Not supported: slides, and a cut at neighbours whose axes all nearly meet or are parallel.
// Sources: [RaghavanRoth93], [ManochaCanny94], [SturmfelsZelevinsky94].
#pragma once

#include <optional>

#include "group_formula.h"
#include "pose_loop.h"

namespace moivre {

struct PairFormula {
  PoseLoop loop;
  Eigen::Matrix<double, 4, 8> forms;        ///< rows: what vanishes on what the pair can do
  Eigen::Matrix<double, 4, 8> coordinates;  ///< of what it must do: c c, c s, s c, s s
};

/// Of an arm of six joints. nullopt where it is not supported.
std::optional<PairFormula> pair_formula(const Arm& arm, std::uint64_t seed);

ProposedClosures proposed_closures(const PairFormula& formula, const Eigen::Isometry3d& pose);

}  // namespace moivre
