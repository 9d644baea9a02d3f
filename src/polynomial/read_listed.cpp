// SPDX-License-Identifier: MIT
// Texts that list their polynomials with commas between: msolve's, and the Julia of
// HomotopyContinuation.jl.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "expand.h"
#include "number_functions.h"
#include "read_formats.h"
#include "statements.h"

namespace moivre {
namespace {

/// A piece of the text and where it begins.
struct Piece {
  std::string_view text;
  SourcePosition begin;
};

/// Without the blanks around it.
Piece tightened(const Piece& piece) {
  const std::string_view text = trimmed(piece.text);
  const auto lead = static_cast<std::size_t>(text.data() - piece.text.data());
  return {text, after(piece.begin, piece.text.substr(0, lead))};
}

Piece part_of(const Piece& piece, std::size_t from, std::size_t to) {
  return tightened(
      {piece.text.substr(from, to - from), after(piece.begin, piece.text.substr(0, from))});
}

/// Cut where `separates(text, k)` holds outside all brackets; blank pieces are left out.
template <class Separates>
std::vector<Piece> cut(const Piece& whole, Separates separates) {
  std::vector<Piece> pieces;
  int depth = 0;
  std::size_t begin = 0;
  SourcePosition here = whole.begin;
  for (std::size_t k = 0; k <= whole.text.size(); ++k) {
    const char c = k < whole.text.size() ? whole.text[k] : '\0';
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (k < whole.text.size() && (depth > 0 || !separates(whole.text, k))) continue;
    const std::string_view text = whole.text.substr(begin, k - begin);
    const Piece piece = tightened({text, here});
    if (!piece.text.empty()) pieces.push_back(piece);
    if (k == whole.text.size()) break;
    here = after(here, whole.text.substr(begin, k + 1 - begin));
    begin = k + 1;
  }
  return pieces;
}

std::vector<Piece> cut_at_commas(const Piece& whole) {
  return cut(whole, [](std::string_view text, std::size_t k) { return text[k] == ','; });
}

/// Where the bracket at `open` is closed; the end of the text where it is not.
std::size_t closing(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t k = open; k < text.size(); ++k) {
    if (text[k] == '(' || text[k] == '[') ++depth;
    if (text[k] == ')' || text[k] == ']') --depth;
    if (depth == 0) return k;
  }
  return text.size();
}

bool continues(char c) { return std::string_view("+-*/^=,([").find(c) != std::string_view::npos; }

/// A line ends there, and nothing says that it goes on.
bool ends_line(std::string_view text, std::size_t k) {
  if (text[k] == ';') return true;
  if (text[k] != '\n') return false;
  const std::string_view before = trimmed(text.substr(0, k));
  return before.empty() || !continues(before.back());
}

void add_unknown(const Piece& name, System& system, Environment& names,
                 std::vector<Diagnostic>& faults) {
  const std::string text(name.text);
  if (!is_one_name(text)) {
    faults.push_back({name.begin, "`" + text + "` is no name of an unknown"});
  } else if (std::find(system.variables.begin(), system.variables.end(), text) !=
             system.variables.end()) {
    faults.push_back({name.begin, "`" + text + "` is declared twice"});
  } else {
    names.insert_or_assign(text, unknown(static_cast<std::uint32_t>(system.variables.size())));
    system.variables.push_back(text);
  }
}

void add_polynomials(const std::vector<Piece>& pieces, const Environment& names, Expander& expander,
                     std::vector<Diagnostic>& faults, System& system) {
  for (const Piece& piece : pieces) {
    const auto typed = expander.expand(piece.text, piece.begin, names);
    if (typed) expander.add_equation(*typed, piece.begin, system);
  }
  if (pieces.empty()) faults.push_back({{}, "the file holds no polynomial"});
  system.denominators = expander.denominators();
}

/// The lines of a text that are not blank, with their places.
std::vector<Piece> lines_of(std::string_view text) {
  return cut(Piece{text, {}}, [](std::string_view all, std::size_t k) { return all[k] == '\n'; });
}

bool is_whole_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Julia, statement by statement.
class JuliaReader {
 public:
  explicit JuliaReader(std::vector<Diagnostic>& faults) : faults_(faults), expander_(faults) {
    names_.emplace("im", constant({0, 1}));
    for (const char* pi : {"pi", "\u03c0"}) names_.emplace(pi, constant(number_pi()));
  }

  ParametricSystem read(std::string_view text) {
    const Piece whole{text, {}};
    const std::vector<Piece> statements = cut(whole, ends_line);
    // Unknowns first: Julia's order of statements does not matter for their numbers.
    for (const Piece& statement : statements) declare(statement);
    for (const Piece& statement : statements) take(statement);
    if (!system_) {
      faults_.push_back({{}, "there is no System([...]) in this file"});
      return {};
    }
    build();
    return std::move(result_);
  }

 private:
  void declare(const Piece& statement) {
    for (const std::string_view word : {"@var", "@polyvar"}) {
      if (statement.text.substr(0, word.size()) != word) continue;
      const Piece rest = part_of(statement, word.size(), statement.text.size());
      const auto is_gap = [](std::string_view text, std::size_t k) {
        return is_blank(text[k]) || text[k] == ',';
      };
      for (const Piece& name : cut(rest, is_gap)) declare_name(name);
    }
  }

  /// x, or x[1:3].
  void declare_name(const Piece& name) {
    const std::size_t bracket = name.text.find('[');
    const std::size_t colon = name.text.find(':');
    if (bracket == std::string_view::npos) return declared_.push_back(name);
    const std::string_view from = name.text.substr(bracket + 1, colon - bracket - 1);
    const std::string_view to =
        colon < name.text.size() ? name.text.substr(colon + 1, name.text.size() - colon - 2) : "";
    constexpr std::size_t kLongest = 6;
    if (!is_whole_number(from) || !is_whole_number(to) || from.size() > kLongest ||
        to.size() > kLongest) {
      faults_.push_back({name.begin, "expected unknowns with indices, such as x[1:3]"});
      return;
    }
    for (int k = std::stoi(std::string(from)); k <= std::stoi(std::string(to)); ++k) {
      made_.push_back(std::string(name.text.substr(0, bracket)) + '[' + std::to_string(k) + ']');
      declared_.push_back({"", name.begin});
      numbered_[declared_.size() - 1] = made_.size() - 1;
    }
  }

  /// name = value
  void take(const Piece& statement) {
    const std::size_t call = statement.text.find("System(");
    if (call != std::string_view::npos) {
      const std::size_t open = call + std::string_view("System").size();
      system_ = part_of(statement, open + 1, closing(statement.text, open));
      return;
    }
    const std::size_t sign = statement.text.find('=');
    if (sign == std::string_view::npos) return;
    const Piece name = part_of(statement, 0, sign);
    if (!is_one_name(name.text)) return;
    assigned_.emplace_back(std::string(name.text),
                           part_of(statement, sign + 1, statement.text.size()));
  }

  std::string name_of(std::size_t k) const {
    const auto made = numbered_.find(k);
    return made == numbered_.end() ? std::string(declared_[k].text) : made_[made->second];
  }

  /// The elements of a list, or of the list that a name stands for.
  std::vector<Piece> elements(const Piece& list) const {
    for (const auto& [name, value] : assigned_) {
      if (name == list.text) return elements_of_brackets(value);
    }
    return elements_of_brackets(list);
  }

  static std::vector<Piece> elements_of_brackets(const Piece& list) {
    if (list.text.size() < 2 || list.text.front() != '[' || list.text.back() != ']') return {list};
    const Piece inner = part_of(list, 1, list.text.size() - 1);
    return cut(inner, [](std::string_view text, std::size_t k) {
      return text[k] == ',' || ends_line(text, k);
    });
  }

  /// Names listed by `key` = [...] of the System; none where it is not there.
  std::vector<std::string> listed(const std::vector<Piece>& arguments, std::string_view key) const {
    std::vector<std::string> names;
    for (const Piece& argument : arguments) {
      const std::size_t sign = argument.text.find('=');
      if (sign == std::string_view::npos || trimmed(argument.text.substr(0, sign)) != key) continue;
      for (const Piece& name : elements(part_of(argument, sign + 1, argument.text.size()))) {
        for (std::size_t k = 0; k < declared_.size(); ++k) {
          const std::string own = name_of(k);
          const bool is_of_list =
              own.compare(0, name.text.size() + 1, std::string(name.text) + '[') == 0;
          if (own == name.text || is_of_list) names.push_back(own);
        }
      }
    }
    return names;
  }

  /// By these polynomials, themselves or by what they name.
  std::set<std::string> names_needed(std::vector<Piece> open) const {
    std::set<std::string> needed;
    while (!open.empty()) {
      const Piece piece = open.back();
      open.pop_back();
      for (const NamePlace& place : names_in(piece.text, piece.begin)) {
        for (const auto& [name, value] : assigned_) {
          if (name == place.name && needed.insert(name).second) open.push_back(value);
        }
      }
    }
    return needed;
  }

  void build() {
    const std::vector<Piece> arguments = cut_at_commas(*system_);
    result_.declared = listed(arguments, "parameters");
    std::vector<std::string> order = listed(arguments, "variables");
    const auto add_missing = [&](const std::string& name) {
      const auto is_in = [&](const std::vector<std::string>& list) {
        return std::find(list.begin(), list.end(), name) != list.end();
      };
      if (!is_in(order) && !is_in(result_.declared)) order.push_back(name);
    };
    for (std::size_t k = 0; k < declared_.size(); ++k) add_missing(name_of(k));
    order.insert(order.end(), result_.declared.begin(), result_.declared.end());
    for (const std::string& name : order) {
      add_unknown({name, {}}, result_.system, names_, faults_);
    }
    if (arguments.empty()) return faults_.push_back({system_->begin, "the System is empty"});
    const std::vector<Piece> polynomials = elements(arguments.front());
    const std::set<std::string> needed = names_needed(polynomials);
    for (const auto& [name, value] : assigned_) {
      if (needed.count(name) == 0 || value.text.empty() || value.text.front() == '[') continue;
      names_.insert_or_assign(name, expander_.expand(value.text, value.begin, names_));
    }
    add_polynomials(polynomials, names_, expander_, faults_, result_.system);
    result_.system.is_exact = !expander_.has_rounded_number();
  }

  std::vector<Diagnostic>& faults_;
  Expander expander_;
  Environment names_;
  std::vector<Piece> declared_;
  std::vector<std::string> made_;                // names with an index
  std::map<std::size_t, std::size_t> numbered_;  // place in declared_ -> place in made_
  std::vector<std::pair<std::string, Piece>> assigned_;
  std::optional<Piece> system_;
  ParametricSystem result_;
};

}  // namespace

bool is_one_name(std::string_view text) {
  const std::vector<NamePlace> names = names_in(text, {});
  return names.size() == 1 && names.front().name == text;
}

bool looks_like_msolve(std::string_view text) {
  if (text.find(';') != std::string_view::npos) return false;
  const std::vector<Piece> lines = lines_of(text);
  if (lines.size() < 3 || !is_whole_number(lines[1].text)) return false;
  const std::vector<Piece> names = cut_at_commas(lines[0]);
  return std::all_of(names.begin(), names.end(),
                     [](const Piece& name) { return is_one_name(name.text); });
}

bool looks_like_julia(std::string_view text) {
  for (const std::string_view word : {"@var ", "@polyvar "}) {
    const std::size_t at = text.find(word);
    if (at == std::string_view::npos) continue;
    const std::string_view before = text.substr(0, at);
    const std::size_t line = before.rfind('\n');
    const bool begins_line =
        trimmed(before.substr(line == std::string_view::npos ? 0 : line)).empty();
    if (begins_line) return true;
  }
  return false;
}

System read_msolve(const Source& source, std::vector<Diagnostic>& faults) {
  const std::vector<Piece> lines = lines_of(source.text);
  System system;
  if (lines[1].text != "0") {
    faults.push_back({lines[1].begin, "the characteristic must be 0: roots are complex numbers"});
  }
  Environment names;
  for (const Piece& name : cut_at_commas(lines[0])) add_unknown(name, system, names, faults);
  const std::size_t begin = lines[2].begin.offset;
  Expander expander(faults);
  const Piece rest{std::string_view(source.text).substr(begin), lines[2].begin};
  add_polynomials(cut_at_commas(rest), names, expander, faults, system);
  system.is_exact = !expander.has_rounded_number();
  return system;
}

ParametricSystem read_julia(const Source& source, std::vector<Diagnostic>& faults) {
  // A fraction of whole numbers, 1//2.
  std::string text = source.text;
  for (std::size_t at = 0; (at = text.find("//", at)) != std::string::npos; ++at)
    text[at + 1] = ' ';
  return JuliaReader(faults).read(text);
}

}  // namespace moivre
