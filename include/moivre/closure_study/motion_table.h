// SPDX-License-Identifier: MIT
// How exact is a mechanism's motion, and at what cost? Positions are compared with closures solved
// again, velocities and accelerations with finite differences of the motion.
//
// A pose followed over D seconds, with N = 50, 100, ..., 6400 samples, h = D / N apart. Errors,
// each relative:
//
//   position      largest |q - q*| / max(1, |q|) at D/10, 2D/10, ..., D; q* the nearest closure
//                 solved at that time
//   velocity      largest difference from v_k ~ (q_{k-2} - 8 q_{k-1} + 8 q_{k+1} - q_{k+2}) / (12
//                 h), over the largest |q'|
//   acceleration  the same of velocity, over the largest |q''|
//
//   The differences fall by 16 with h/2 until rounding, about 1e-16 |q| / h, if and only if
//   velocity is the derivative of position (acceleration that of velocity).
// Edges: a branch that ends is compared over the first three quarters of its time, since velocity
// has no bound at a dead point. A mechanism that does not move gives no row.
#pragma once

#include <Eigen/Core>

#include "moivre/mechanism/mechanism.h"
#include "moivre/study/study.h"

namespace moivre {

/// The motion of the pose q0, assembled at time 0, over `duration` seconds at most: a row a number
/// of samples. `reference_tracker` finds the closures.
StudyTable motion_table(const Mechanism& mechanism, const Eigen::VectorXd& q0, double duration,
                        const Tracker& reference_tracker,
                        const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
