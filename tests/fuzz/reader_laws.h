// SPDX-License-Identifier: MIT
// What must hold for any bytes that a reader is given: a system that round-trips, or a ParseError
// with faults in the text.
//
// Shared by the fuzz targets and by the test that replays their corpora.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "moivre/polynomial/read.h"

namespace moivre {

/// Writing and reading back a larger system would slow the search for faults and find none more.
inline constexpr std::size_t kMaximumTermsWritten = 2000;

/// The law that the bytes break, if any.
inline std::optional<std::string> broken_reader_law(const std::string& bytes,
                                                    PolynomialFormat format) {
  const Source source{"fuzz", bytes};
  detect_format(bytes);
  System system;
  try {
    system = read_system(source, format);
  } catch (const ParseError& error) {
    if (error.diagnostics().empty()) return "a ParseError without a fault";
    for (const Diagnostic& fault : error.diagnostics()) {
      if (fault.at.offset > bytes.size() || fault.message.empty())
        return "a fault outside the text";
      if (after({}, std::string_view(bytes).substr(0, fault.at.offset)) != fault.at) {
        return "a fault whose line and column are not those of its offset";
      }
    }
    return std::nullopt;
  }
  if (term_count(system) > kMaximumTermsWritten) return std::nullopt;
  for (const PolynomialFormat other : {PolynomialFormat::phcpack, PolynomialFormat::bertini}) {
    std::string text;
    try {
      text = to_text(system, other);
    } catch (const std::invalid_argument&) {
      continue;  // a name that the other format reserves, or no variable at all
    }
    if (detect_format(text) != other) return "written text of another format:\n" + text;
    try {
      if (read_system({"written", text}, other) != system)
        return "another system read back:\n" + text;
    } catch (const ParseError& error) {
      return "written text is refused:\n" + text + error.what();
    }
  }
  return std::nullopt;
}

}  // namespace moivre
