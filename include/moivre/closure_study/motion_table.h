// SPDX-License-Identifier: MIT
// Is a mechanism's velocity the derivative of its positions, and at what cost? Its motion against differences of itself.
//
// A pose followed over `duration`, with N = 50, 100, ..., 800 samples, h apart:
//
//   v_k ~ (q_{k-2} - 8 q_{k-1} + 8 q_{k+1} - q_{k+2}) / (12 h)      and acceleration from velocity alike
//
//   the largest difference, relative to the largest |q'| (|q''|); it falls by 16 with h/2 until rounding, about
//   1e-16 |q| / h, if and only if velocity is the derivative of position (acceleration that of velocity).
// Edges: a branch that ends within four samples gives no row.
#pragma once

#include <Eigen/Core>

#include "moivre/mechanism/mechanism.h"
#include "moivre/study/study.h"

namespace moivre {

/// The motion of the pose q0, assembled at time 0, over `duration` seconds: a row a number of samples.
StudyTable motion_table(const Mechanism& mechanism, const Eigen::VectorXd& q0, double duration,
                        const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
