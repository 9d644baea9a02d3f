// SPDX-License-Identifier: MIT
// Escapes for a script's data, and the head of every page.
#include "moivre/closure_report/document.h"

#include <cmath>
#include <cstdlib>

#include "moivre/report/markup.h"
#include "moivre/report/number_text.h"
#include "page_assets.h"
#include "svg.h"

namespace moivre {

Json rounded(double x) {
  constexpr int kDigits = 7;
  if (!std::isfinite(x)) return nullptr;
  return std::strtod(short_text(x, kDigits).c_str(), nullptr);
}

std::string script_data(const Json& json) {
  const std::string plain = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  for (const char c : plain) {
    switch (c) {
      case '<':
        safe += "\\u003c";
        break;
      case '>':
        safe += "\\u003e";
        break;
      case '&':
        safe += "\\u0026";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string html_document(const std::string& title, std::string body, std::string_view script,
                          std::string_view style) {
  constexpr std::string_view kErrorHook =
      "addEventListener('error',e=>{document.documentElement.dataset.state='failed';"
      "document.getElementById('error').textContent='This page failed: '+e.message;});";
  body +=
      element("script", {}, kErrorHook) + '\n' + element("script", {}, std::string(script)) + '\n';
  const std::string head =
      std::string(
          "<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
          "content=\"width=device-width,initial-scale=1\">\n"
          "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
          "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n")
          .append(element("title", {}, escaped(title)))
          .append(element("style", {}, style_sheet()))
          .append(element("style", {}, std::string(page_style()).append(style)));
  return std::string("<!DOCTYPE html>\n")
      .append(element("html", {{"lang", "en"}},
                      element("head", {}, head) + '\n' + element("body", {}, body)))
      .append(1, '\n');
}

}  // namespace moivre
