// SPDX-License-Identifier: MIT
// Which roots does an inequality ask for? x > 0 and 0 < x*y <= 2, as conditions p > 0 or p >= 0.
#include <algorithm>

#include "moivre/polynomial/double_range.h"
#include "moivre/polynomial/read.h"
#include "read_formats.h"

namespace moivre {
namespace {

constexpr std::string_view kSigns = "<>";

/// A side of a sign, and the sign behind it; the last side has none.
struct Side {
  std::string_view text;
  SourcePosition begin;
  char sign = '\0';
  bool is_strict = true;
};

std::vector<Side> sides_of(const Statement& statement) {
  std::vector<Side> sides;
  std::string_view rest = statement.text;
  SourcePosition at = statement.begin;
  for (;;) {
    const std::size_t sign = rest.find_first_of(kSigns);
    if (sign == std::string_view::npos) {
      sides.push_back({rest, at});
      return sides;
    }
    const bool is_strict = sign + 1 == rest.size() || rest[sign + 1] != '=';
    sides.push_back({rest.substr(0, sign), at, rest[sign], is_strict});
    const std::size_t length = sign + (is_strict ? 1 : 2);
    at = after(at, rest.substr(0, length));
    rest.remove_prefix(length);
  }
}

/// A fault in how the sides are put together; empty where there is none.
std::string fault_between(const Side& left, const Side& right) {
  const std::string_view before = trimmed(left.text);
  if (!before.empty() && before.back() == '=') {
    return std::string("`=") + left.sign + "` is no sign; type `" + left.sign + "=`";
  }
  if (before.empty() || trimmed(right.text).empty()) {
    return std::string("a side of this `") + left.sign + "` is missing";
  }
  return "";
}

/// On one line, with one blank where there were more.
std::string in_one_line(std::string_view text) {
  std::string line;
  for (const char c : trimmed(text)) {
    if (!is_blank(c)) {
      line += c;
    } else if (line.back() != ' ') {
      line += ' ';
    }
  }
  return line;
}

std::string typed(const Side& left, const Side& right) {
  return in_one_line(left.text) + ' ' + left.sign + (left.is_strict ? " " : "= ") +
         in_one_line(right.text);
}

/// Appends a fault for each name that is no unknown. Returns the names with these as further
/// unknowns, so that they hide no other fault.
Environment check_names(const Statement& statement, const Environment& names,
                        std::vector<Diagnostic>& faults) {
  Environment all = names;
  for (const NamePlace& place : names_in(statement.text, statement.begin)) {
    const std::string name(place.name);
    if (names.count(name) > 0) continue;
    faults.push_back({place.at, "`" + name + "` occurs in this condition and in no equation"});
    all.emplace(name, unknown(static_cast<std::uint32_t>(all.size())));
  }
  return all;
}

}  // namespace

bool is_condition(std::string_view text) {
  return text.find_first_of(kSigns) != std::string_view::npos;
}

bool parses_as_condition(const Statement& statement) {
  std::vector<Diagnostic> faults;
  for (const Side& side : sides_of(statement)) {
    parse_expression(side.text, side.begin, faults, NumberRange::any);
  }
  return faults.empty();
}

void read_condition(const Statement& statement, const Environment& names, System& system,
                    std::vector<Diagnostic>& faults) {
  const std::vector<Side> sides = sides_of(statement);
  const std::size_t before = faults.size();
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const std::string fault = fault_between(sides[k], sides[k + 1]);
    if (!fault.empty()) faults.push_back({after(sides[k].begin, sides[k].text), fault});
  }
  const bool has_sides = faults.size() == before;
  const Environment all = check_names(statement, names, faults);
  if (!has_sides) return;
  Expander expander(faults);
  std::vector<std::optional<Polynomial>> values;
  for (const Side& side : sides) values.push_back(expander.expand(side.text, side.begin, all));
  if (faults.size() == before && !expander.denominators().empty()) {
    // p/q > 0 asks for the sign of p q, and p q = 0 where q is: the condition would be another.
    faults.push_back({statement.begin, "a condition does not divide by unknowns"});
  }
  if (faults.size() > before) return;
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const Polynomial& left = *values[k];
    const Polynomial& right = *values[k + 1];
    const Polynomial difference = sides[k].sign == '>' ? left - right : right - left;
    const std::optional<int> power = log2_into_double(difference);
    if (!power) faults.push_back({sides[k].begin, std::string("multiplied out, ") + kBeyondDouble});
    Condition condition{times_power_of_two(difference, power.value_or(0)), sides[k].is_strict,
                        typed(sides[k], sides[k + 1])};
    if (!is_real(condition.p)) {
      faults.push_back({sides[k].begin, "a condition has real coefficients"});
    }
    system.conditions.push_back(std::move(condition));
  }
}

std::vector<Condition> read_conditions(const Source& source,
                                       const std::vector<std::string>& unknowns) {
  Environment names = meanings_of_constants();
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    names.insert_or_assign(unknowns[k], unknown(static_cast<std::uint32_t>(k)));
  }
  System read;
  std::vector<Diagnostic> faults;
  StatementCursor cursor(source.text, {});
  for (bool is_more = true; is_more;) {
    const Statement statement = cursor.next();
    is_more = statement.is_ended;
    if (statement.text.empty()) continue;
    if (is_condition(statement.text)) {
      read_condition(statement, names, read, faults);
    } else {
      faults.push_back({statement.begin, "expected a condition, such as x > 0"});
    }
  }
  if (!faults.empty()) throw ParseError(source, std::move(faults));
  return std::move(read.conditions);
}

}  // namespace moivre
