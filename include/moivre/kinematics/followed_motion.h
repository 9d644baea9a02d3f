// SPDX-License-Identifier: MIT
// Along which directions does a motion of one degree of freedom leave the pose q? What the null
// space of Phi_q has besides, where rank is lost, is none.
//
//   nullity 1   the null vector: a curve through q has no other tangent
//   else        curves are followed through q: poses at s = 4 h, 3 h, ..., h, then -h, ..., -4 h
//               along a chord of each, Gauss-Newton from where those before lead; the tangent is
//               the derivative of their polynomial at s = 0. It counts where polynomials of
//               degree 6 and 8 agree on it, and where Phi_q sees nothing of it.
// q: n coordinates, a pose (Phi = 0) that lies on a set of dimension 1.
// Edges: where curves cross, each that a start came to has its direction; a curve that two starts
// came to has one. A curve that ends at q, or has a cusp there, is not followed: it has none.
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/mechanism/phi.h"

namespace moivre {

/// Known to so much of its length; what is smaller is 0.
inline constexpr double kFollowed = 1e-7;

/// Each q' of length 1 where lengths are taken relative to the mechanism's, at the drivers' time t.
/// Starts come from `seed`. `moving`: the coordinates that move, the others are held.
std::vector<Eigen::VectorXd> followed_directions(const Phi& phi, const Eigen::VectorXd& q, double t,
                                                 std::uint64_t seed,
                                                 const std::vector<Eigen::Index>& moving);
/// Where all may move.
std::vector<Eigen::VectorXd> followed_directions(const Phi& phi, const Eigen::VectorXd& q,
                                                 double t = 0, std::uint64_t seed = 1);

}  // namespace moivre
