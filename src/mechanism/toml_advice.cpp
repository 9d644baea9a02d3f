// SPDX-License-Identifier: MIT
// Advice by the parser's words and by the characters around the place where it stopped.
#include "toml_advice.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace moivre {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Where the parser stopped, and what stands around it.
struct Stop {
  std::string_view text;
  std::size_t at = 0;
  std::string_view fault;

  bool says(std::string_view words) const { return fault.find(words) != std::string_view::npos; }
  /// "\n" at the end.
  char here() const { return at < text.size() ? text[at] : '\n'; }
  std::string_view rest() const { return text.substr(std::min(at, text.size())); }
  std::size_t line_begin() const {
    const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    return before == std::string_view::npos ? 0 : before + 1;
  }
  std::string_view line() const {
    const std::size_t begin = line_begin();
    return text.substr(begin, std::min(text.find('\n', begin), text.size()) - begin);
  }
  /// The last character on the line before the fault that is no blank; "\n" where there is none.
  char before() const {
    std::size_t k = std::min(at, text.size());
    while (k > line_begin() && (text[k - 1] == ' ' || text[k - 1] == '\t')) --k;
    return k > line_begin() ? text[k - 1] : '\n';
  }
  /// What stands around the fault without blanks, commas and brackets: the number that is read.
  std::string_view word() const {
    constexpr std::string_view kEnds = " \t\r\n,=[](){};#\"";
    const std::size_t here = std::min(at, text.size());
    const std::size_t before =
        here == 0 ? std::string_view::npos : text.find_last_of(kEnds, here - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    return text.substr(begin, std::min(text.find_first_of(kEnds, here), text.size()) - begin);
  }
  /// Whether the value that begins behind the last '=' has a bracket open here.
  bool is_in_array() const {
    const std::string_view read = text.substr(0, at);
    const std::string_view value = read.substr(std::min(read.rfind('='), read.size()));
    return std::count(value.begin(), value.end(), '[') >
           std::count(value.begin(), value.end(), ']');
  }
};

bool begins_with_any(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return text.starts_with(word); });
}

/// "// ..." and the like, at the beginning of a line or behind a value; ";" that ends one.
std::string comment_advice(const Stop& stop) {
  const bool begins_line = stop.before() == '\n';
  const bool has_value = stop.line().find('=') < stop.at - stop.line_begin();
  const bool is_behind_value = stop.here() == ';' && has_value && !stop.is_in_array();
  if (is_behind_value && stop.rest().find_first_not_of(" \t\r", 1) == stop.rest().find('\n')) {
    return "; a value ends with its line, without ';'";
  }
  const bool is_comment = is_behind_value || begins_with_any(stop.rest(), {"//", "/*"}) ||
                          (begins_line && begins_with_any(stop.rest(), {";", "%", "--", "!"}));
  return is_comment ? "; comments begin with #" : "";
}

/// Where a number goes on with something that is none of it: an operator, a decimal comma or a
/// unit.
std::string number_advice(const Stop& stop) {
  if (stop.says("leading zeroes")) return "; a number has no zeros in front: 7, not 007";
  const char c = stop.here();
  const char last = stop.before();
  if (stop.says("floating-point") && (last == '.' || (c == '.' && !is_digit(last)))) {
    return "; digits stand on both sides of the point: 0.5, 5.0";
  }
  // "40deg" is read as far as an exponent's e.
  const bool is_exponent = stop.says("floating-point") && (last == 'e' || last == 'E');
  if (!is_digit(last) && !(is_exponent && is_letter(c))) return "";
  if (is_digit(c)) return "; the digits of a number stand without blanks";
  if (c == ';') return "; the entries of an array are parted by commas";
  if (c == ',') {
    const bool is_decimal = stop.at + 1 < stop.text.size() && is_digit(stop.text[stop.at + 1]);
    return is_decimal ? "; decimals have a point: 40.5, not 40,5"
                      : "; several numbers stand in brackets, as in [40, 0]";
  }
  if (std::string_view("/*+-^(").find(c) != std::string_view::npos) {
    return "; numbers are written out, such as 13.3333333 for 40/3";
  }
  const bool is_word = is_letter(c) || static_cast<unsigned char>(c) >= 0x80U || c == '%';
  return is_word ? "; numbers stand without a unit, [units] says it once for the whole file" : "";
}

/// Where what is read is nearly a number: two signs, two points, an exponent without digits or with
/// a point.
std::string digits_advice(const Stop& stop) {
  constexpr std::string_view kSigns = "+-";
  constexpr std::string_view kPlain = "+-.0123456789";
  const std::string_view word = stop.word();
  if (word.size() > 1 && word.find_first_not_of(kSigns) > 1) return "; a number has one sign";
  const std::size_t end = std::min(word.find_first_not_of(kPlain), word.size());
  if (end == 0) return "";
  if (end < word.size() && word[end] != 'e' && word[end] != 'E') return "";
  const std::string_view mantissa = word.substr(0, end);
  if (std::count(mantissa.begin(), mantissa.end(), '.') > 1) {
    return "; a number has one decimal point";
  }
  const bool is_power =
      end < word.size() && word.find_first_not_of(kPlain, end + 1) == std::string_view::npos;
  return is_power ? "; an exponent is a whole number, as in 1e-3" : "";
}

/// Whether a formula begins here: pi, or a function's name and its bracket.
bool begins_formula(std::string_view text) {
  const auto end = std::find_if_not(text.begin(), text.end(),
                                    [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
  const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  if (word == "pi") return true;
  constexpr std::array<std::string_view, 8> kFunctions{"sqrt", "sin",  "cos",  "tan",
                                                       "asin", "acos", "atan", "atan2"};
  const bool is_known = std::find(kFunctions.begin(), kFunctions.end(), word) != kFunctions.end();
  return is_known && end != text.end() && *end == '(';
}

/// Where a value begins with neither a quote nor a digit.
std::string value_advice(const Stop& stop) {
  if (!stop.says("value type") && !stop.says("boolean")) return "";
  if (stop.here() == '(') return "; several numbers stand in brackets, as in [40, 0]";
  if (begins_with_any(stop.rest(), {"\u201c", "\u201d", "\u201e", "\u2018", "\u2019"})) {
    return "; quotes are straight, \"...\", not those of a word processor";
  }
  if (begins_formula(stop.rest())) {
    return "; numbers are written out, such as 1.0471976 for pi/3; only a driver's value = \"...\" "
           "is an expression";
  }
  return "; text stands in quotes, as in title = \"...\"";
}

/// "[[joint]] has two brackets" where one pair was written for an array; empty for another name
/// that is taken.
std::string bracket_advice(const Stop& stop) {
  for (const std::string name : {"joint", "driver"}) {
    if (!stop.says("'" + name + "'")) continue;
    return "; every " + name + " begins with [[" + name + "]], in two brackets";
  }
  return "";
}

/// Where a key is followed by something else than its value.
std::string key_advice(const Stop& stop) {
  if (!stop.says("expected '='")) return "";
  const std::string_view line = stop.line();
  if (stop.here() == ':') return "; a key and its value are joined by '='";
  return line.find('=') == std::string_view::npos
             ? "; a key and its value are joined by '='"
             : "; names have letters, digits, '_' and '-', and no blanks";
}

std::string header_advice(const Stop& stop) {
  if (!stop.says("table header")) return "";
  const std::string_view line = stop.line();
  const auto closing = std::count(line.begin(), line.end(), ']');
  const auto opening = std::count(line.begin(), line.end(), '[');
  if (closing >= opening) return "; names have letters, digits, '_' and '-', and no blanks";
  const bool has_blank = line.substr(0, line.find('#')).find_first_of(" \t", 1) < stop.at;
  if (has_blank && closing > 0) return "; names have letters, digits, '_' and '-', and no blanks";
  return opening == 1 ? "; the line begins with '[' and ends with ']'"
                      : "; the line begins with '[[' and ends with ']]'";
}

/// What to do about a fault that is where the parser stopped; empty where its words are enough.
std::string advice(const Stop& stop) {
  if (stop.says("root table") && stop.says("saw '{'")) {
    return "; a mechanism file is TOML, not JSON: docs/mechanism-file.md shows one";
  }
  if (stop.says("redefine")) {
    const std::string brackets = bracket_advice(stop);
    return brackets.empty() ? "; two bodies, points or keys have one name, rename one of them"
                            : brackets;
  }
  for (const auto& of :
       {comment_advice, number_advice, digits_advice, value_advice, key_advice, header_advice}) {
    if (std::string found = of(stop); !found.empty()) return found;
  }
  return "";
}

/// The end of what is written on a line, comment left out: behind its last character.
std::size_t code_end(std::string_view text, std::size_t begin, std::size_t end) {
  bool is_quoted = false;
  std::size_t last = begin;
  for (std::size_t k = begin; k < end; ++k) {
    if (text[k] == '"') is_quoted = !is_quoted;
    if (text[k] == '#' && !is_quoted) break;
    if (std::isspace(static_cast<unsigned char>(text[k])) == 0) last = k + 1;
  }
  return last;
}

/// Behind the last character of the lines before `end` that belongs to the file's data.
std::size_t end_of_data_before(std::string_view text, std::size_t end) {
  while (end > 0) {
    const std::size_t before = end < 2 ? std::string_view::npos : text.rfind('\n', end - 2);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::size_t last = code_end(text, begin, end);
    if (last > begin) return last;
    end = begin;
  }
  return 0;
}

/// Whether a header or a key begins here: the array before it was not closed.
bool begins_something_else(const Stop& stop) {
  if (stop.at >= stop.text.size()) return true;
  const std::string_view rest = stop.rest();
  const std::size_t name = rest.find_first_not_of('[');
  return name != std::string_view::npos && is_letter(rest[name]);
}

struct Missing {
  std::size_t at = 0;
  std::string what;
};

/// A bracket, comma or quote that is missing before the place where the parser stopped.
Missing missing(const Stop& stop) {
  if (stop.says("parsing array") && stop.says("end-of-file")) {
    return {end_of_data_before(stop.text, stop.text.size()),
            "']' is missing: the array is not closed"};
  }
  if (stop.says("parsing array") && stop.before() == '\n') {
    return {end_of_data_before(stop.text, stop.line_begin()),
            begins_something_else(stop) ? "']' is missing: the array is not closed"
                                        : "',' is missing between two entries of the array"};
  }
  if (stop.says("parsing array") && is_digit(stop.before()) &&
      (is_digit(stop.here()) || stop.here() == '-')) {
    return {stop.at, "',' is missing before this entry of the array"};
  }
  if (stop.says("parsing array") && stop.before() == '"' && is_letter(stop.here())) {
    return {stop.at, "'\"' is missing before this: each name stands in quotes of its own"};
  }
  if (stop.says("parsing string") && stop.here() == '\n') {
    return {stop.at, "'\"' is missing: the text is not closed"};
  }
  const std::string_view line = stop.line();
  const std::size_t equals = line.find('=');
  const bool is_listed = stop.here() == ',' && stop.says("key-value pair");
  const bool is_open = is_listed && equals != std::string_view::npos &&
                       line.find('[', equals) == std::string_view::npos &&
                       line.find(']', equals) != std::string_view::npos;
  if (!is_open) return {};
  const std::size_t value = line.find_first_not_of(" \t", equals + 1);
  return {stop.line_begin() + value, "'[' is missing: several values stand in brackets"};
}

}  // namespace

Diagnostic toml_fault(const Source& source, const SourcePosition& at, const std::string& fault) {
  const Stop stop{source.text, at.offset, fault};
  const Missing what = missing(stop);
  if (what.what.empty()) return {at, fault + advice(stop)};
  return {after({}, stop.text.substr(0, what.at)), what.what};
}

}  // namespace moivre
