// SPDX-License-Identifier: MIT
// What are the page's style and script? The texts of page.css, page.js and turning_page.js, put in
// by the build.
#pragma once

#include <string_view>

namespace moivre {

std::string_view page_style();
std::string_view page_script();
std::string_view turning_script();

}  // namespace moivre
