// SPDX-License-Identifier: MIT
// Cutting a text at its semicolons, with positions kept.
#include "statements.h"

#include <algorithm>

namespace moivre {

namespace {}

bool is_blank(char c) { return kBlanks.find(c) != std::string_view::npos; }

std::string first_line(std::string_view text) {
  constexpr std::size_t kShown = 60;
  text = trimmed(text.substr(0, text.find('\n')));
  std::string line(text.substr(0, kShown));
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text.size() > kShown ? line + "..." : line;
}

Statement StatementCursor::next() {
  const std::size_t semicolon = rest_.find(';');
  const bool is_ended = semicolon != std::string_view::npos;
  const std::string_view raw = rest_.substr(0, semicolon);
  const std::string_view text = trimmed(raw);
  const auto lead = static_cast<std::size_t>(text.data() - raw.data());
  Statement statement{.text = text,
                      .begin = after(at_, raw.substr(0, lead)),
                      .end = after(at_, raw),
                      .is_ended = is_ended};
  rest_.remove_prefix(is_ended ? semicolon + 1 : rest_.size());
  at_ = is_ended ? after(statement.end, ";") : statement.end;
  return statement;
}

}  // namespace moivre
