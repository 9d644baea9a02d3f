// SPDX-License-Identifier: MIT
// What do all pages have in common? Numbers as short as a picture can show, data inside a script,
// the document around all.
#pragma once

#include <string>
#include <string_view>

#include "moivre/report/json.h"

namespace moivre {

/// As many digits as a plot can show, so that the page stays small.
Json rounded(double x);

/// JSON that stands inside `<script>`: no character of it can end the element.
std::string script_data(const Json& json);

/// The document: its policy forbids the network; `script` runs behind `body`, which has an element
/// `error` for what fails. `style` is put behind that of all pages.
std::string html_document(const std::string& title, std::string body, std::string_view script,
                          std::string_view style = {});

}  // namespace moivre
