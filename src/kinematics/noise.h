// SPDX-License-Identifier: MIT
// Which coordinates of a pose are rounding noise? Those that vanish relative to the mechanism: its
// lengths, or a radian.
#pragma once

#include <vector>

#include "moivre/mechanism/phi.h"

namespace moivre {

/// q with 0 for each coordinate below a few roundings of the largest of its kind, the mechanism's
/// length and a radian among them; those in `held` stay.
Eigen::VectorXd without_noise(const Phi& phi, const Eigen::VectorXd& q,
                              const std::vector<Eigen::Index>& held = {});

}  // namespace moivre
