// SPDX-License-Identifier: MIT
// Is the file typed from one drawing? Then q = 0, the drawn pose, closes every joint, and every
// body's frame is the drawing's.
//
// Numbers are typed with few digits: a drawing counts as closed where no joint misses by more than
// a hundredth of the mechanism's largest length. Drivers are looked at apart, since a file may
// begin elsewhere than in the drawn pose.
// A file with a frame of its own for each body misses by the lengths of its links, and its q = 0
// means nothing.
// Not drawn: typed equations.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// By how much each joint misses at q = 0, in the file's unit of length (misfit in phi.h).
std::vector<double> drawn_misfits(const Mechanism& mechanism);

/// The drawn pose closes every joint.
bool is_drawn(const Mechanism& mechanism);

/// And the drivers at time t have it as well: Newton-Raphson from q = 0 comes to the closure that
/// was drawn.
bool is_drawn_at(const Mechanism& mechanism, double t);

/// What keeps the drawn pose from being a closure at t: the row that misses most, and by how much,
/// "revolute B: y misses by 0.2 mm".
std::string drawn_miss(const Mechanism& mechanism, double t);

}  // namespace moivre
