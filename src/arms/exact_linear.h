// SPDX-License-Identifier: MIT
// Which linear forms vanish on some displacements, and which tell coordinates among them? Exactly, without fractions.
#pragma once

#include <vector>

#include "moivre/arms/arm.h"

namespace moivre {

/// An element of the dual space: the sum of its parts times those of a displacement.
using LinearForm = ExactDisplacement;

/// A basis of the forms that vanish on all `vectors`; 8 less their rank.
std::vector<LinearForm> vanishing_forms(const std::vector<ExactDisplacement>& vectors);

/// For linearly independent `vectors`: forms that are, on their span, the coordinates, up to one factor that they share.
std::vector<LinearForm> coordinate_forms(const std::vector<ExactDisplacement>& vectors);

Integer value(const LinearForm& form, const ExactDisplacement& g);

}  // namespace moivre
