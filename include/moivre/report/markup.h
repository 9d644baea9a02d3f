// SPDX-License-Identifier: MIT
// How does a user's text get into XML and HTML without becoming markup?
#pragma once

#include <string>
#include <string_view>

namespace moivre {

/// Markup characters escaped; what is no UTF-8, and control characters, become U+FFFD.
std::string escaped(std::string_view text);

}  // namespace moivre
