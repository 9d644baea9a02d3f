// SPDX-License-Identifier: MIT
// The version, handed in by the build.
#include "moivre/report/version.h"

namespace moivre {

std::string_view version() { return MOIVRE_VERSION; }

}  // namespace moivre
