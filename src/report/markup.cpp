// SPDX-License-Identifier: MIT
// Characters that begin markup, and bytes that are no character.
#include "moivre/report/markup.h"

#include <algorithm>

#include "moivre/expression/utf8.h"

namespace moivre {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const char first = text.front();
    if (length == 0 || (length == 1 && static_cast<unsigned char>(first) < ' ') || first == 0x7F) {
      safe += kReplacement;
    } else if (first == '&') {
      safe += "&amp;";
    } else if (first == '<') {
      safe += "&lt;";
    } else if (first == '>') {
      safe += "&gt;";
    } else if (first == '"') {
      safe += "&quot;";
    } else if (first == '\'') {
      safe += "&#39;";
    } else {
      safe += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return safe;
}

std::string element(std::string_view name, const std::vector<Attribute>& attributes,
                    std::string_view content) {
  std::string text = "<";
  text += name;
  for (const Attribute& attribute : attributes) {
    text.append(1, ' ').append(attribute.name).append("=\"");
    text.append(escaped(attribute.value)).append(1, '"');
  }
  if (content.empty()) return text + "/>";
  return text.append(1, '>').append(content).append("</").append(name).append(1, '>');
}

}  // namespace moivre
