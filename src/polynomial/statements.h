// SPDX-License-Identifier: MIT
// Where does each `;`-ended statement of a text begin and end?
#pragma once

#include <string>
#include <string_view>

#include "moivre/expression/source.h"
#include "moivre/expression/words.h"

namespace moivre {

/// Text up to its `;` (not held), without the blanks around it; `begin` is its first character,
/// or the `;` of a blank statement.
struct Statement {
  std::string_view text;
  SourcePosition begin;
  SourcePosition end;  ///< of the `;`, or of the text's end
  bool is_ended = false;
};

/// The statements of a text one by one; the last one, without a `;`, may be blank.
class StatementCursor {
 public:
  StatementCursor(std::string_view text, SourcePosition begin) : rest_(text), at_(begin) {}

  std::string_view rest() const { return rest_; }
  SourcePosition position() const { return at_; }
  Statement next();

 private:
  std::string_view rest_;
  SourcePosition at_;
};

bool is_blank(char c);
/// The first line of a text as a message shows it: cut when long, no control characters.
std::string first_line(std::string_view text);

}  // namespace moivre
