// SPDX-License-Identifier: MIT
// How does a name become a cell of CSV? As it is, but where a program would take it for something
// else.
//
// In quotes where a comma, a quote or a line break is in it (RFC 4180). An apostrophe goes before
// =, +, -, @ and a tabulator: a sheet would compute what begins with these, and names come from
// files of others.
#pragma once

#include <string>
#include <string_view>

namespace moivre {

inline std::string csv_cell(std::string_view name) {
  std::string cell;
  if (!name.empty() && std::string_view("=+-@\t\r").find(name.front()) != std::string_view::npos) {
    cell += '\'';
  }
  cell += name;
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) {
    quoted += c;
    if (c == '"') quoted += c;
  }
  return quoted + '"';
}

}  // namespace moivre
