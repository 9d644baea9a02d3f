// SPDX-License-Identifier: MIT
// What are the pages' styles and scripts? The texts of page.css, page.js, turning_page.js,
// sweep_page.css and sweep_page.js, put in by the build.
#pragma once

#include <string_view>

namespace moivre {

std::string_view page_style();
std::string_view page_script();
std::string_view turning_script();
std::string_view sweep_page_style();
std::string_view sweep_page_script();

}  // namespace moivre
