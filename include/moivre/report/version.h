// SPDX-License-Identifier: MIT
// Which Moivre is this? The version that every report carries.
#pragma once

#include <string_view>

namespace moivre {

/// "0.1.0", as in moivre/version.h.
std::string_view version();

}  // namespace moivre
