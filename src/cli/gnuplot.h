// SPDX-License-Identifier: MIT
// Is gnuplot there, and does it draw this script?
#pragma once

#include <string>

namespace moivre {

enum class Drawing { drawn, no_gnuplot, failed };

/// Runs `gnuplot SCRIPT` in `folder`, and waits for it. What it has to say goes to stderr.
Drawing run_gnuplot(const std::string& folder, const std::string& script);

}  // namespace moivre
