// SPDX-License-Identifier: MIT
// Telling the formats apart, and what holds for both.
// Text it must be, and every fault is thrown at once.
#include "moivre/polynomial/read.h"

#include <algorithm>
#include <functional>

#include "number_functions.h"
#include "read_formats.h"
#include "statements.h"

namespace moivre {

namespace {

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && !is_blank(c)) || byte == 0x7F;
}

std::string_view first_word(std::string_view text) {
  const auto end = std::find_if(text.begin(), text.end(), [](char c) {
    return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_');
  });
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

/// True when `text` goes on like a name behind a keyword, not like a product or a sum.
bool leads_to_name(std::string_view text) {
  if (text.empty() || !is_blank(text.front())) return false;
  const std::string_view next = trimmed(text);
  return !next.empty() &&
         std::string_view("+-*/^;,)=").find(next.front()) == std::string_view::npos;
}

void check_is_text(const Source& source, std::vector<Diagnostic>& faults) {
  const std::string& text = source.text;
  const auto control = std::find_if(text.begin(), text.end(), is_control);
  if (control != text.end()) {
    const std::string_view before(text.data(), static_cast<std::size_t>(control - text.begin()));
    faults.push_back({after({}, before), "the file is not text: it holds the control character " +
                                             std::to_string(static_cast<int>(*control))});
  } else if (trimmed(text).empty()) {
    faults.push_back({{}, "the file is empty"});
  }
}

/// Throws every fault of the text, or of what `read` makes of it.
void read_text(const Source& source, const std::function<void(std::vector<Diagnostic>&)>& read) {
  std::vector<Diagnostic> faults;
  check_is_text(source, faults);
  if (faults.empty()) read(faults);
  if (faults.empty()) return;
  const auto is_before = [](const Diagnostic& a, const Diagnostic& b) {
    return a.at.offset < b.at.offset;
  };
  std::stable_sort(faults.begin(), faults.end(), is_before);
  throw ParseError(source, std::move(faults));
}

/// With blanks in the place of comments, from a # to the end of its line, so that all places stay.
Source without_comments(const Source& source) {
  Source rest = source;
  bool is_comment = false;
  for (char& c : rest.text) {
    if (c == '#') is_comment = true;
    if (c == '\n') is_comment = false;
    if (is_comment) c = ' ';
  }
  return rest;
}

System read_as(PolynomialFormat format, const Source& source, std::vector<Diagnostic>& faults) {
  switch (format) {
    case PolynomialFormat::bertini:
      return read_bertini(source, faults);
    case PolynomialFormat::msolve:
      return read_msolve(without_comments(source), faults);
    case PolynomialFormat::julia: {
      ParametricSystem read = read_julia(without_comments(source), faults);
      if (!read.declared.empty() && faults.empty()) {
        faults.push_back({{},
                          "the file describes a family of systems, with parameters; learn it by "
                          "moivre family learn"});
      }
      return std::move(read.system);
    }
    case PolynomialFormat::phcpack:
      break;
  }
  return read_phcpack(without_comments(source), faults);
}

bool may_name_pi(std::string_view text) {
  return text.find("pi") != std::string_view::npos || text.find("\u03c0") != std::string_view::npos;
}

/// Empty where they are those of the system.
std::vector<Polynomial> nudged_polynomials(PolynomialFormat format, const Source& source,
                                           const System& system) {
  const NudgedNumbers nudge;
  std::vector<Diagnostic> faults;
  System beside = read_as(format, source, faults);
  if (!faults.empty() || beside.polynomials == system.polynomials) return {};
  return std::move(beside.polynomials);
}

}  // namespace

PolynomialFormat detect_format(const std::string& text) {
  const std::string bare = without_comments({"", text}).text;
  if (looks_like_julia(bare)) return PolynomialFormat::julia;
  if (looks_like_msolve(bare)) return PolynomialFormat::msolve;
  std::string head = without_bertini_comments(text);
  head.resize(std::min(head.find(';'), head.size()));
  std::string_view rest = head;
  bool is_first = true;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.empty()) continue;
    const std::string_view word = first_word(line);
    const bool is_section = word == "CONFIG" || word == "INPUT";
    const bool is_alone = word.size() == line.size();
    const auto word_end = static_cast<std::size_t>(word.data() + word.size() - head.data());
    const bool may_begin = is_section ? is_alone || is_first : is_first && is_bertini_keyword(word);
    if (may_begin && leads_to_name(std::string_view(head).substr(word_end))) {
      return PolynomialFormat::bertini;
    }
    is_first = false;
  }
  return PolynomialFormat::phcpack;
}

System read_system(const Source& source) { return read_system(source, detect_format(source.text)); }

System read_system(const Source& source, PolynomialFormat format) {
  System system;
  read_text(source,
            [&](std::vector<Diagnostic>& faults) { system = read_as(format, source, faults); });
  if (!system.is_exact || may_name_pi(source.text)) {
    system.nudged = nudged_polynomials(format, source, system);
  }
  return system;
}

ParametricSystem read_parametric(const Source& source, const std::vector<std::string>& constants) {
  ParametricSystem result;
  const PolynomialFormat format = detect_format(source.text);
  if (format == PolynomialFormat::julia) {
    read_text(source, [&](std::vector<Diagnostic>& faults) {
      result = read_julia(without_comments(source), faults);
    });
    return result;
  }
  if (format != PolynomialFormat::bertini) {
    result.system = read_system(source, format);
    return result;
  }
  read_text(source, [&](std::vector<Diagnostic>& faults) {
    result = read_parametric_bertini(source, constants, faults);
  });
  return result;
}

}  // namespace moivre
