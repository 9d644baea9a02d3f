// SPDX-License-Identifier: MIT
// What is done about the questions that are open when paths were followed? One table of remedies,
// each once, in its order.
//
//   until a count settles the run, or no remedy is left:
//     the next remedy of the table acts on the questions of judge.h that it may answer
//
// What is open then has failed. Where as many roots are known as a proved bound allows, or as exact
// algebra counts with their multiplicities, nothing is open (completeness.h); that is asked
// whenever something new is known. An interrupted run is left as it is.
// Private to the module.
#pragma once

#include <span>

#include "run.h"

namespace moivre {

/// Leaves alone what it cannot answer; what it costs is for it to limit.
using Remedy = void (*)(Run&);

/// The table.
std::span<const Remedy> remedies();

/// With fewer remedies a test shows what each is for.
void settle(Run& run, std::span<const Remedy> table = remedies());

/// Whether a count tells that the paths without a root lead to no other; these are then not needed.
bool is_settled(Run& run);

}  // namespace moivre
