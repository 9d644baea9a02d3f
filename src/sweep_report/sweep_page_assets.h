// SPDX-License-Identifier: MIT
// What are the style and script of a sweep's page? The texts of sweep_page.css and sweep_page.js,
// put in by the build.
#pragma once

#include <string_view>

namespace moivre {

std::string_view sweep_page_style();
std::string_view sweep_page_script();

}  // namespace moivre
