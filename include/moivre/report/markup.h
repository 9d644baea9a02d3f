// SPDX-License-Identifier: MIT
// How are XML and HTML written, so that no user's text becomes markup?
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moivre {

/// Markup characters escaped; what is no UTF-8, and control characters, become U+FFFD.
std::string escaped(std::string_view text);

struct Attribute {
  std::string_view name;
  std::string value;
};
/// `<name attribute="value">content</name>`, values escaped, the content as it is; without content
/// `<name .../>`.
std::string element(std::string_view name, const std::vector<Attribute>& attributes,
                    std::string_view content = "");

}  // namespace moivre
