// SPDX-License-Identifier: MIT
// How is a file read whole, and how does a fault in it look on the screen?
#include "moivre/expression/source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include "moivre/numeric/invalid_input.h"

namespace moivre {

namespace {

/// A longer line is shown as a window around the fault: what fits beside "..." on a usual terminal.
constexpr std::size_t kWindow = 96;
/// Beyond this many faults the text says how many more there are; the list itself keeps them all.
constexpr std::size_t kMaximumFaultsInText = 1000;

constexpr std::size_t kMegabyte = 1'000'000;
/// Read at a time: first a mechanism's usual length, for every page of memory that is touched costs
/// a microsecond.
constexpr std::size_t kFirstPiece = 1 << 12;
constexpr std::size_t kPiece = 1 << 16;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A control character would move the caret or the terminal; a tab is kept, for the caret line
/// repeats it.
char printable(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return c == '\t' || (byte >= 0x20 && byte != 0x7F) ? c : '?';
}

std::string_view line_around(std::string_view text, std::size_t offset) {
  const std::size_t at = std::min(offset, text.size());
  const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  std::string_view line = text.substr(begin, text.find('\n', at) - begin);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

/// The line and, below it, a caret under its byte `index`.
std::string excerpt(std::string_view line, std::size_t index) {
  index = std::min(index, line.size());
  std::size_t first = 0;
  if (line.size() > kWindow && index > kWindow / 2) {
    first = std::min(index - kWindow / 2, line.size() - kWindow);
  }
  const std::string_view shown = line.substr(first, kWindow);
  const std::string lead = first > 0 ? "..." : "";
  const std::string_view tail = first + shown.size() < line.size() ? "..." : "";
  std::string text = "    " + lead;
  std::string caret(lead.size() + 4, ' ');
  for (std::size_t k = 0; k < shown.size(); ++k) {
    text += printable(shown[k]);
    const bool continues_utf8 = (static_cast<unsigned char>(shown[k]) & 0xC0U) == 0x80U;
    if (k < index - first && !continues_utf8) caret += shown[k] == '\t' ? '\t' : ' ';
  }
  text += tail;
  return text + '\n' + caret + "^\n";
}

std::string all_texts(const Source& source, const std::vector<Diagnostic>& faults) {
  const std::size_t shown = std::min(faults.size(), kMaximumFaultsInText);
  std::string text;
  for (std::size_t k = 0; k < shown; ++k) text += to_text(faults[k], source);
  if (shown < faults.size()) {
    text += source.name + ": " + std::to_string(faults.size() - shown) + " more faults\n";
  }
  return text;
}

std::vector<std::string> messages_of(const std::vector<Diagnostic>& faults) {
  std::vector<std::string> messages;
  for (const Diagnostic& fault : faults) messages.push_back(fault.message);
  return messages;
}

Source read_whole(const std::string& name, std::istream& stream, std::size_t longest) {
  std::string text;
  for (std::size_t piece = kFirstPiece; stream; piece = kPiece) {
    const std::size_t before = text.size();
    text.resize(before + piece);
    stream.read(text.data() + before, static_cast<std::streamsize>(piece));
    text.resize(before + static_cast<std::size_t>(stream.gcount()));
    if (text.size() <= longest) continue;
    throw InvalidInput(name + ": is longer than " + std::to_string(longest / kMegabyte) +
                       " MB, more than any system or mechanism that can be solved");
  }
  if (stream.bad()) {
    throw InvalidInput(name + ": cannot be read: " + std::strerror(errno));
  }
  if (text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0) {
    text.erase(0, kByteOrderMark.size());
  }
  return {.name = name, .text = std::move(text)};
}

}  // namespace

SourcePosition after(SourcePosition begin, std::string_view text) {
  SourcePosition end = begin;
  end.offset += text.size();
  end.line += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  const std::size_t last_break = text.rfind('\n');
  end.column =
      last_break == std::string_view::npos ? begin.column + text.size() : text.size() - last_break;
  return end;
}

Source read_source(const std::string& path, std::size_t longest) {
  if (path == "-") return read_whole("standard input", std::cin, longest);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InvalidInput(path + ": cannot be read: it is a directory");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw InvalidInput(path + ": cannot be opened: " + std::strerror(errno));
  }
  return read_whole(path, file, longest);
}

std::string to_text(const Diagnostic& diagnostic, const Source& source) {
  const SourcePosition& at = diagnostic.at;
  return source.name + ':' + std::to_string(at.line) + ':' + std::to_string(at.column) +
         ": error: " + diagnostic.message + '\n' +
         excerpt(line_around(source.text, at.offset), at.column - 1);
}

ParseError::ParseError(const Source& source, std::vector<Diagnostic> faults)
    : InvalidInput(all_texts(source, faults), messages_of(faults)),
      diagnostics_(std::move(faults)) {}

}  // namespace moivre
