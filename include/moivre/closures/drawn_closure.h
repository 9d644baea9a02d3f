// SPDX-License-Identifier: MIT
// Which closure was drawn? In a file typed from one drawing, the one that Newton-Raphson comes to
// from q = 0.
//
// With Mechanism::fit it may be a least-squares closure.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "moivre/mechanism/phi.h"

namespace moivre {

/// Its q, in canonical form; nullopt where the file is no drawing, or the drivers at t have another
/// pose. phi: of the mechanism.
std::optional<Eigen::VectorXd> drawn_closure(const Mechanism& mechanism, const Phi& phi, double t);

}  // namespace moivre
