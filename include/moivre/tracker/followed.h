// SPDX-License-Identifier: MIT
// On what do the ends of paths depend? On the homotopy and the tracker, put into a fingerprint
// here, and on where paths begin.
//
// Coefficients are taken as they are rounded, where they are followed in double; what is left out
// follows from them and from the file that they come from.
#pragma once

#include "moivre/homotopy/homotopy.h"
#include "moivre/numeric/fingerprint.h"
#include "moivre/tracker/tracker.h"

namespace moivre {

void add_to(FingerprintMaker& maker, const Homotopy& homotopy);
void add_to(FingerprintMaker& maker, const FramePointer& frame);
/// Its kind and its options, and those of this machine's lanes.
void add_to(FingerprintMaker& maker, const Tracker& tracker);

}  // namespace moivre
