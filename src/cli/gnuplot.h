// SPDX-License-Identifier: MIT
// Is gnuplot there, and does it draw this script?
#pragma once

#include <string>

namespace moivre {

enum class GnuplotOutcome { drawn, no_gnuplot, failed };

/// Runs `gnuplot SCRIPT` in `folder`, and waits for it. What it has to say goes to stderr.
GnuplotOutcome run_gnuplot(const std::string& folder, const std::string& script);

}  // namespace moivre
