// SPDX-License-Identifier: MIT
// How little does the tip move, and where to, when joints move by a unit? The smallest singular
// value of the screws, with its vectors.
//
// Of up to six joints, at every posture of a list: the smallest eigenvalue of the screws' Gram
// matrix, made tridiagonal, by Laguerre's iteration from below, which cannot pass it; its vector v
// by inverse iteration. Squares lose half of the value's digits, but none of v's, if the next value
// is not as small; the value is then |screws v|. A value below kClear relative to the largest, or a
// vector that does not settle, is left to Jacobi's rotations (svd.h).
// Edges: of two values that are equal, any vector of their plane.
// Sources: [Parlett98].
#pragma once

#include "tip.h"

namespace moivre {

struct LeastMotion {
  double singular_value = 0;
  JointVector<double> joints;  ///< unit: these joint velocities move the tip least
  Velocity6<double> tip;       ///< unit: how they move it
};

LeastMotion least_motion(const Screws<double>& screws);

/// How many singular values are not above a bound, those of more joints than six among them.
int still_count(const Screws<double>& screws, double bound);

}  // namespace moivre
