// SPDX-License-Identifier: MIT
// The version, as the header has it that the library is compiled with.
#include "moivre/report/version.h"

#include "moivre/version.h"

namespace moivre {

std::string_view version() { return MOIVRE_VERSION_STRING; }

}  // namespace moivre
