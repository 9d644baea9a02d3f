// SPDX-License-Identifier: MIT
// Reading PHCpack's text: count line, polynomials, headings behind them.
// And what a lost `;` looks like.
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <unordered_map>

#include "expand.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/lookalikes.h"
#include "moivre/expression/words.h"
#include "number_functions.h"
#include "read_formats.h"
#include "statements.h"

namespace moivre {

namespace {

/// A message lists at most this many polynomials, names or hints, and counts the others.
constexpr std::size_t kListed = 200;

struct CountLine {
  std::size_t polynomials = 0;
  std::size_t unknowns = 0;
  SourcePosition at;
};

struct Layout {
  std::optional<CountLine> count;
  std::vector<Statement> polynomials;
  std::vector<Statement> conditions;
  Statement rest;  // text behind the last `;`, up to a heading
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

/// The line's non-negative integers; none when it holds anything else. Too large ones saturate.
std::vector<std::size_t> integers_of(std::string_view line) {
  std::vector<std::size_t> integers;
  while (!(line = trimmed(line)).empty()) {
    const auto end = std::find_if_not(line.begin(), line.end(), is_digit);
    const auto length = static_cast<std::size_t>(end - line.begin());
    if (length == 0 || (length < line.size() && !is_blank(line[length]))) return {};
    std::size_t value = 0;
    const auto read = std::from_chars(line.data(), line.data() + length, value);
    if (read.ec != std::errc{}) value = std::numeric_limits<std::size_t>::max();
    integers.push_back(value);
    line.remove_prefix(length);
  }
  return integers;
}

/// Consumes the count line, when there is one.
std::optional<CountLine> take_count_line(std::string_view& text, SourcePosition& at,
                                         std::vector<Diagnostic>& faults) {
  const std::string_view body = trimmed(text);
  const std::string_view line = body.substr(0, body.find('\n'));
  const std::vector<std::size_t> integers = integers_of(line);
  if (integers.empty()) return std::nullopt;
  const auto lead = static_cast<std::size_t>(body.data() - text.data());
  const SourcePosition begin = after(at, text.substr(0, lead));
  const std::size_t length = lead + line.size();
  at = after(at, text.substr(0, length));
  text.remove_prefix(length);
  if (integers.size() > 2) {
    faults.push_back({begin, "the count line holds " + counted(integers.size(), "number") +
                                 "; expected `n` or `n m` (n polynomials, m unknowns)"});
    return std::nullopt;
  }
  return CountLine{.polynomials = integers.front(), .unknowns = integers.back(), .at = begin};
}

/// Is this line a heading behind the polynomials (TITLE : ..., THE SOLUTIONS, ROOT COUNTS, ======)?
bool is_heading(std::string_view line) {
  line = trimmed(line);
  if (line.substr(0, 4) == "====") return true;
  const auto word_end = std::find_if_not(line.begin(), line.end(), is_capital);
  const std::string_view word = line.substr(0, static_cast<std::size_t>(word_end - line.begin()));
  if (word.size() < 3) return false;
  const std::string_view behind = trimmed(line.substr(word.size()));
  if (!behind.empty() && behind.front() == ':') return true;
  constexpr std::array<std::string_view, 8> kFirstWords = {
      "TITLE", "ROOT", "THE", "START", "TIMING", "MIXED", "SYMMETRY", "GENERATING"};
  const bool is_known =
      std::find(kFirstWords.begin(), kFirstWords.end(), word) != kFirstWords.end();
  if (!is_known) return false;
  return behind.empty() || (behind.front() >= 'A' && behind.front() <= 'Z') ||
         (behind.front() >= 'a' && behind.front() <= 'z');
}

/// Where the first heading of `text` begins, or its end.
std::size_t heading_in(std::string_view text) {
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (is_heading(text.substr(begin, end - begin))) return begin;
    begin = end + 1;
  }
  return text.size();
}

bool has_equals(std::string_view text) { return equals_sign(text).length > 0; }

/// The lines that hold something.
std::vector<Statement> lines_of(const Statement& text) {
  std::vector<Statement> lines;
  std::string_view rest = text.text;
  SourcePosition at = text.begin;
  while (!rest.empty()) {
    const std::string_view raw = rest.substr(0, rest.find('\n'));
    const std::string_view line = trimmed(raw);
    const auto lead = static_cast<std::size_t>(line.data() - raw.data());
    const SourcePosition end = after(at, raw);
    if (!line.empty()) lines.push_back({line, after(at, raw.substr(0, lead)), end, true});
    at = raw.size() < rest.size() ? after(end, "\n") : end;
    rest.remove_prefix(std::min(raw.size() + 1, rest.size()));
  }
  return lines;
}

/// Appends a fault for each place, the last one with a count of what is not listed.
void add_faults(const std::vector<SourcePosition>& places, const std::string& message,
                std::vector<Diagnostic>& faults) {
  const std::size_t listed = std::min(places.size(), kListed);
  for (std::size_t k = 0; k < listed; ++k) faults.push_back({places[k], message});
  if (places.size() > listed) {
    faults.back().message +=
        "\n  and so at " + std::to_string(places.size() - listed) + " more lines";
  }
}

/// An equation or a condition, or what is meant as one or as a comment (x ≤ 2, // a circle): such a
/// line is refused where it is read, with what to type for it.
bool is_meant_as_statement(const Statement& line) {
  if (has_equals(line.text) || is_condition(line.text)) return true;
  const std::string meant = with_what_is_meant(line.text);
  return has_equals(meant) || is_condition(meant) || meant.starts_with('#');
}

/// Of a text without `;`: the equations and conditions, one a line. None where no line is either;
/// where some are, each other line is a fault.
std::vector<Statement> equations_by_line(const Statement& text, std::vector<Diagnostic>& faults) {
  std::vector<Statement> lines = lines_of(text);
  const auto others = std::stable_partition(lines.begin(), lines.end(), is_meant_as_statement);
  std::vector<SourcePosition> unread;
  for (auto line = others; line != lines.end(); ++line) unread.push_back(line->begin);
  lines.erase(others, lines.end());
  if (lines.empty()) return lines;
  add_faults(unread,
             "this line has no `=`, and an equation stands on one line; where one goes on over "
             "several, every equation ends with `;`",
             faults);
  return lines;
}

/// Conditions among the equations; no count line counts them.
void set_conditions_apart(Layout& layout) {
  std::vector<Statement>& all = layout.polynomials;
  const auto is_equation = [](const Statement& each) { return !is_condition(each.text); };
  const auto first = std::stable_partition(all.begin(), all.end(), is_equation);
  layout.conditions.assign(first, all.end());
  all.erase(first, all.end());
}

Layout statements_of(const Source& source, std::vector<Diagnostic>& faults) {
  Layout layout;
  std::string_view text = source.text;
  SourcePosition at;
  layout.count = take_count_line(text, at, faults);
  StatementCursor cursor(text, at);
  for (;;) {
    const std::string_view ahead = cursor.rest();
    const std::string_view piece = ahead.substr(0, ahead.find(';'));
    const std::size_t heading = heading_in(piece);
    if (heading < piece.size() || piece.size() == ahead.size()) {
      layout.rest = StatementCursor(piece.substr(0, heading), cursor.position()).next();
      if (!layout.count && layout.polynomials.empty()) {
        layout.polynomials = equations_by_line(layout.rest, faults);
        if (!layout.polynomials.empty()) layout.rest = {};
      }
      return layout;
    }
    layout.polynomials.push_back(cursor.next());
  }
}

Layout layout_of(const Source& source, std::vector<Diagnostic>& faults) {
  Layout layout = statements_of(source, faults);
  set_conditions_apart(layout);
  return layout;
}

bool reads_like_mathematics(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  return with_what_is_meant(line).find_first_of("+*^=") != std::string::npos;
}

/// Does the text behind the last `;` parse as a polynomial that lost its own?
bool is_expression(const Statement& rest) {
  std::vector<Diagnostic> faults;
  parse_expression(rest.text, rest.begin, faults, NumberRange::any);
  return faults.empty();
}

/// Where a polynomial goes on, outside parentheses, on a line that begins with a sign.
struct Seam {
  std::size_t line = 0;
  bool is_likely_end = false;  // the text before it ends with a number, or a blank line follows it
};

bool ends_with_summed_number(std::string_view text) {
  text = trimmed(text);
  const std::size_t before = text.find_last_not_of("0123456789.");
  return before != std::string_view::npos && before + 1 < text.size() &&
         std::string_view("+- \n").find(text[before]) != std::string_view::npos;
}

std::vector<Seam> seams_of(const Statement& polynomial) {
  std::vector<Seam> seams;
  const std::string_view text = polynomial.text;
  std::size_t line = polynomial.begin.line;
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '(') ++depth;
    if (text[k] == ')') --depth;
    if (text[k] != '\n') continue;
    const std::size_t next =
        k + static_cast<std::size_t>(trimmed(text.substr(k)).data() - &text[k]);
    const auto breaks = std::count(&text[k], &text[next], '\n');
    line += static_cast<std::size_t>(breaks);
    if (depth == 0 && (text[next] == '-' || text[next] == '+')) {
      seams.push_back({line, breaks > 1 || ends_with_summed_number(text.substr(0, k))});
    }
    k = next - 1;
  }
  return seams;
}

/// Each seam as a question, the likely ends of a polynomial first.
std::string seam_hints(const Layout& layout) {
  constexpr std::size_t kHints = 20;
  std::vector<std::string> hints;
  std::vector<std::string> unlikely;
  for (std::size_t k = 0; k < layout.polynomials.size(); ++k) {
    for (const Seam& seam : seams_of(layout.polynomials[k])) {
      const std::string hint = "\n  polynomial " + std::to_string(k + 1) + " goes on at line " +
                               std::to_string(seam.line) +
                               ", which begins with a sign: is a `;` missing before it?";
      (seam.is_likely_end ? hints : unlikely).push_back(hint);
    }
  }
  hints.insert(hints.end(), unlikely.begin(), unlikely.end());
  std::string text;
  for (std::size_t k = 0; k < std::min(hints.size(), kHints); ++k) text += hints[k];
  if (hints.size() > kHints) {
    text += "\n  and so at " + std::to_string(hints.size() - kHints) + " more lines";
  }
  return text;
}

std::string counted(std::size_t n, const std::string& singular, const std::string& plural) {
  return std::to_string(n) + ' ' + (n == 1 ? singular : plural);
}

/// "3 unknowns"; of a saturated number what is known of it.
std::string expected_count(std::size_t n, const std::string& one, const std::string& many) {
  return n == std::numeric_limits<std::size_t>::max() ? "more than 1.8e19 " + many
                                                      : counted(n, one, many);
}

std::string missing_end_hint(const Statement& rest) {
  return "\n  the text at line " + std::to_string(rest.begin.line) +
         " has no `;` behind it: " + first_line(rest.text);
}

/// Behind which `;` stands first, as a message says it.
std::string why_each_needs_it(const Layout& layout) {
  const Statement& first = layout.polynomials.front();
  return ": where one equation has it (line " + std::to_string(first.end.line) + "), each needs it";
}

/// The lines of a statement that end an equation without a `;`, since the next one has its own `=`.
std::vector<SourcePosition> unended_equations(const Statement& statement) {
  std::vector<SourcePosition> ends;
  for (const Statement& line : lines_of(statement)) {
    if (has_equals(line.text) && !is_condition(line.text)) ends.push_back(line.begin);
  }
  if (!ends.empty()) ends.pop_back();
  return ends;
}

/// Why is there no equation in a text without a count line?
std::string no_equation(const Layout& layout) {
  const std::string_view text = layout.rest.text;
  if (!layout.conditions.empty()) return "no equation found: the file has conditions alone";
  if (text.empty()) return "no equation found: the file has comments or headings alone";
  const bool has_sign = text.find_first_of("*/^()=") != std::string_view::npos;
  if (!has_sign && names_in(text, layout.rest.begin).empty()) {
    return "no equation found: the file has numbers alone";
  }
  return "no equation found: one equation a line has one `=`, as in x + y = 1; without `=`, each "
         "ends with `;`";
}

/// A condition behind the last `;`, or what is meant as one.
bool ends_with_condition(const Layout& layout) {
  Statement line = layout.rest;
  const std::string meant = with_what_is_meant(line.text.substr(0, line.text.find('\n')));
  line.text = trimmed(meant);
  return is_condition(line.text) && parses_as_condition(line);
}

/// Text that is no mathematics would be left alone.
void check_last_condition(const Layout& layout, std::vector<Diagnostic>& faults) {
  if (!ends_with_condition(layout)) return;
  faults.push_back({layout.rest.begin, "this condition has no `;` behind it"});
}

void check_polynomial_count(const Layout& layout, std::vector<Diagnostic>& faults) {
  const std::size_t found = layout.polynomials.size();
  const bool has_rest = !layout.rest.text.empty();
  if (!layout.count) {
    if (found == 0) {
      if (faults.empty()) faults.push_back({layout.rest.begin, no_equation(layout)});
    } else if (has_rest && !ends_with_condition(layout) &&
               (reads_like_mathematics(layout.rest.text) || is_expression(layout.rest))) {
      faults.push_back({layout.rest.begin, "this polynomial has no `;` behind it" +
                                               why_each_needs_it(layout) +
                                               lookalike_advice(layout.rest.text, 0)});
    }
    return;
  }
  const std::size_t expected = layout.count->polynomials;
  if (found == expected && expected > 0) return;
  std::string message = expected == 0
                            ? "the count line announces no polynomial"
                            : "expected " + expected_count(expected, "polynomial", "polynomials");
  message += ", found " + std::to_string(found) + (found > 0 ? ":" : "");
  for (std::size_t k = 0; k < std::min(found, kListed); ++k) {
    const Statement& polynomial = layout.polynomials[k];
    message += "\n  polynomial " + std::to_string(k + 1) + " begins at line " +
               std::to_string(polynomial.begin.line) + ": " + first_line(polynomial.text);
  }
  if (found > kListed) message += "\n  and " + std::to_string(found - kListed) + " more";
  if (found < expected) {
    message += seam_hints(layout);
    if (has_rest) message += missing_end_hint(layout.rest);
  }
  faults.push_back({layout.count->at, message});
}

bool is_imaginary_unit(std::string_view name) { return name == "i" || name == "I"; }
bool is_pi(std::string_view name) { return name == "pi" || name == "\u03c0"; }

/// The unknowns: every name but the imaginary unit and pi, in the order of first appearance.
std::vector<NamePlace> unknowns_of(const std::vector<Statement>& polynomials) {
  std::vector<NamePlace> unknowns;
  std::unordered_map<std::string_view, bool> is_known;
  for (const Statement& polynomial : polynomials) {
    for (const NamePlace& place : names_in(polynomial.text, polynomial.begin)) {
      if (is_imaginary_unit(place.name) || is_pi(place.name)) continue;
      if (is_known.try_emplace(place.name, true).second) unknowns.push_back(place);
    }
  }
  return unknowns;
}

bool names_pi(const std::vector<Statement>& polynomials, std::string_view text) {
  // Where the letters do not occur, nothing need be read again.
  const bool may_be =
      text.find("pi") != std::string_view::npos || text.find("\u03c0") != std::string_view::npos;
  return may_be &&
         std::any_of(polynomials.begin(), polynomials.end(), [](const Statement& polynomial) {
           const std::vector<NamePlace> places = names_in(polynomial.text, polynomial.begin);
           return std::any_of(places.begin(), places.end(),
                              [](const NamePlace& place) { return is_pi(place.name); });
         });
}

void check_unknown_count(const Layout& layout, const std::vector<NamePlace>& unknowns,
                         std::vector<Diagnostic>& faults) {
  if (!layout.count || layout.count->unknowns == unknowns.size()) return;
  // Polynomials too many may be prose; its words are no unknowns. That there is none is said.
  const std::size_t found = layout.polynomials.size();
  if (found == 0 || found > layout.count->polynomials) return;
  std::string message = "expected " +
                        expected_count(layout.count->unknowns, "unknown", "unknowns") + ", found " +
                        counted(unknowns.size(), "name", "names");
  for (std::size_t k = 0; k < std::min(unknowns.size(), kListed); ++k) {
    message += (k == 0 ? ": " : ", ") + std::string(unknowns[k].name) + " (line " +
               std::to_string(unknowns[k].at.line) + ", column " +
               std::to_string(unknowns[k].at.column) + ')';
  }
  if (unknowns.size() > kListed) {
    message += " and " + std::to_string(unknowns.size() - kListed) + " more";
  }
  faults.push_back({layout.count->at, message});
}

Environment meanings_of(const std::vector<NamePlace>& unknowns) {
  Environment names = meanings_of_constants();
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    names.emplace(unknowns[k].name, unknown(static_cast<std::uint32_t>(k)));
  }
  return names;
}

}  // namespace

Environment meanings_of_constants() {
  Environment names;
  for (const char* unit : {"i", "I"}) names.emplace(unit, constant({0, 1}));
  for (const char* pi : {"pi", "\u03c0"}) names.emplace(pi, constant(number_pi()));
  return names;
}

System read_phcpack(const Source& source, std::vector<Diagnostic>& faults) {
  const Layout layout = layout_of(source, faults);
  check_polynomial_count(layout, faults);
  check_last_condition(layout, faults);
  const std::vector<NamePlace> unknowns = unknowns_of(layout.polynomials);
  check_unknown_count(layout, unknowns, faults);

  System system;
  for (const NamePlace& place : unknowns) system.variables.emplace_back(place.name);
  const Environment names = meanings_of(unknowns);
  Expander expander(faults);
  for (const Statement& statement : layout.polynomials) {
    if (statement.text.empty()) {
      faults.push_back({statement.begin, "a polynomial is missing before this `;`"});
      continue;
    }
    const std::vector<SourcePosition> unended = unended_equations(statement);
    if (!unended.empty()) {
      add_faults(unended, "this equation has no `;` behind it" + why_each_needs_it(layout), faults);
      continue;
    }
    const auto typed = expander.expand_equation(statement.text, statement.begin, names);
    if (typed) expander.add_equation(*typed, statement.begin, system);
  }
  system.is_exact = !expander.has_rounded_number() && !names_pi(layout.polynomials, source.text);
  system.denominators = expander.denominators();
  for (const Statement& statement : layout.conditions) {
    read_condition(statement, names, system, faults);
  }
  return system;
}

}  // namespace moivre
