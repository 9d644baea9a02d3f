// SPDX-License-Identifier: MIT
// Which rules does a mechanism break? One place for what is read and for what is put together in
// code.
//
// form        what one entry shows: indices, finite numbers, names, unit axes, planar points with z
//             = 0, laws and formulas that can be evaluated, what a type of joint needs
// structure   what no single entry shows: loose bodies, cycles of welds, links of no length, too
//             many drivers
// Whatever takes a mechanism refuses one whose form is broken (InvalidInput). The reader and the
// builder refuse both.
#pragma once

#include <string>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// Sentences; empty where none is broken.
std::vector<std::string> broken_form(const Mechanism& mechanism);
/// Of form, and, where that is whole, of structure.
std::vector<std::string> broken_rules(const Mechanism& mechanism);

/// Throws InvalidInput with every broken rule of form.
void require_form(const Mechanism& mechanism);
/// Throws InvalidInput where q has not one finite number for each coordinate. The form of the
/// mechanism is whole.
void require_pose(const Mechanism& mechanism, const Eigen::VectorXd& q);

}  // namespace moivre
