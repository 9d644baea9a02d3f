// SPDX-License-Identifier: MIT
// Where in a file did it go wrong, and what is to be done?
// Positions, diagnostics and the error that carries them.
//
// A reader collects every fault as a Diagnostic and throws one ParseError with all of them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "moivre/numeric/invalid_input.h"

namespace moivre {

/// Line and column count from 1; column counts bytes; offset is in bytes from the file's start.
struct SourcePosition {
  std::size_t offset = 0;
  std::size_t line = 1;
  std::size_t column = 1;

  friend bool operator==(const SourcePosition&, const SourcePosition&) = default;
};

/// Where `text`, which begins at `begin`, ends.
SourcePosition after(SourcePosition begin, std::string_view text);

struct Diagnostic {
  SourcePosition at;
  std::string message;
};

/// Text of a file (or of a string) under the name that messages use.
struct Source {
  std::string name;
  std::string text;
};

/// Far more than a system at the limit of a million terms takes; a device without end is not read
/// for ever.
inline constexpr std::size_t kLongestText = 256'000'000;

/// Reads the whole file, "-": standard input, without a UTF-8 byte order mark. Throws InvalidInput
/// with the reason when it cannot be read (a directory, no permission, not there, longer than
/// `longest` bytes).
Source read_source(const std::string& path, std::size_t longest = kLongestText);

/// "file:line:column: error: message", the line (a window of it, when it is long) and a caret below
/// the fault.
std::string to_text(const Diagnostic& diagnostic, const Source& source);

/// Every fault of one input; what() is all their texts, one after another; the broken rules are
/// their messages.
class ParseError : public InvalidInput {
 public:
  ParseError(const Source& source, std::vector<Diagnostic> faults);
  const std::vector<Diagnostic>& diagnostics() const noexcept { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace moivre
