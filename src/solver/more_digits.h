// SPDX-License-Identifier: MIT
// Remedies that follow paths again: with smaller steps, in double-double, in more digits.
//
// Each takes the paths from the questions that are open (judge.h) and leaves what it finds in the
// table. More digits save no steps: where the caller's budget ended a path it stays ended. Private
// to the module.
#pragma once

#include <functional>

#include "run.h"

namespace moivre {

/// Simple roots nearer to each other than double can tell pass for one singular root, but not in
/// double-double.
void part_in_double_double(Run& run);

/// Where many paths go at once digits cost less than smaller steps, and these help none that digits
/// do not.
void raise_failed_paths(Run& run);

/// By the other tracker where there is one, but for paths that double-double has left without an
/// end.
void follow_in_smaller_steps(Run& run);

/// A path may turn out to end where another was thought to: that one is followed next. Each is
/// once. So is one that ends alone, without a proof, where fewer roots are proved than exact
/// algebra counts: that costs less than to ask it for the roots.
void raise_to_double_double(Run& run);

/// Simple roots that double-double cannot part.
void raise_to_more_digits(Run& run);

/// The ends do not add up to what exact algebra counts: one that is told without a proof is none,
/// and nothing tells which. Where there are fewer ends than roots a path that is said to end at
/// infinity may have jumped on its way, and a root of size 1e34 is there as far as double tells.
void raise_after_contradiction(Run& run);

/// Some paths go ahead by `tracker`, then twice as many, as long as one of the last ones has found
/// a simple root or `goes_on`, and the run is not settled. A path that ends at no simple root costs
/// as much as thousands in double.
void raise_while_it_helps(Run& run, const Tracker& tracker, const PathSet& paths,
                          const std::function<bool()>& goes_on);

}  // namespace moivre
