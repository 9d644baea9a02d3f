// SPDX-License-Identifier: MIT
// Which Moivre is this, and what was built into it? For --version, and with --verbose for a report
// of a fault.
#pragma once

#include <string>

namespace moivre {

/// Without an end of line. Verbose: components, compiler, versions of packages, instruction sets of
/// the lanes.
std::string version_text(bool verbose);

}  // namespace moivre
