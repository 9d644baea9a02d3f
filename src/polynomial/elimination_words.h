// SPDX-License-Identifier: MIT
// What is said of an elimination? A sentence for each thing that was left out, or could not be.
//
// Private to the module.
#pragma once

#include <cstdint>
#include <vector>

#include "elimination_state.h"

namespace moivre::elimination {

/// Of equations of the degrees `before` that were combined to `after`; left: without those that
/// have become constant.
Omission told_combination(const std::vector<std::uint64_t>& before,
                          const std::vector<std::uint64_t>& after,
                          const std::vector<std::uint64_t>& left);

/// Of the way from f to the reduced system.
std::vector<Omission> account(const State& s, const System& reduced, const System& f);

/// Which unknowns occur in f.
std::vector<bool> appears(const System& f);

}  // namespace moivre::elimination
