// SPDX-License-Identifier: MIT
// Reading Bertini's input files: sections, declarations, assignments in their order.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "expand.h"
#include "moivre/polynomial/patches.h"
#include "read_formats.h"
#include "statements.h"

namespace moivre {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name_character(char c) {
  return is_letter(c) || (c >= '0' && c <= '9') || c == '[' || c == ']';
}

std::string_view word_at_front(std::string_view text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_name_character);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

bool is_name(std::string_view text) {
  return !text.empty() && is_letter(text.front()) && word_at_front(text).size() == text.size();
}

constexpr std::string_view kImaginaryUnit = "I";

/// What a declaration's keyword asks for, when it cannot be done; empty when it can.
struct Keyword {
  std::string_view word;
  std::string_view refusal;
};

constexpr std::string_view kAffineGroup = "variable_group";
constexpr std::string_view kParameter = "parameter";
constexpr std::string_view kHomogeneousGroup = "hom_variable_group";

constexpr std::array<Keyword, 10> kKeywords = {{
    {kAffineGroup, ""},
    {"variable", ""},
    {"function", ""},
    {"constant", ""},
    {kHomogeneousGroup, ""},
    {"pathvariable",
     "the file describes a homotopy of its own; only systems are read, without a path variable"},
    {kParameter,
     "the file describes a family of systems; give the parameter's value as a constant, or learn "
     "the family with moivre family learn"},
    {"random", "a number drawn at random is not part of a file's system; give its value"},
    {"random_real", "a number drawn at random is not part of a file's system; give its value"},
    {"definedSubfunction", "functions defined in other files are not read"},
}};

bool is_group(const Keyword& keyword) {
  return keyword.word == kAffineGroup || keyword.word == kHomogeneousGroup;
}

const Keyword* find_keyword(std::string_view word) {
  const auto* const found = std::find_if(kKeywords.begin(), kKeywords.end(),
                                         [&](const Keyword& k) { return k.word == word; });
  return found == kKeywords.end() ? nullptr : found;
}

/// `text` without its first `count` characters and the blanks behind them.
Statement behind(const Statement& statement, std::size_t count) {
  Statement rest = statement;
  rest.text = trimmed(statement.text.substr(count));
  const auto skipped = static_cast<std::size_t>(rest.text.data() - statement.text.data());
  rest.begin = after(statement.begin, statement.text.substr(0, skipped));
  return rest;
}

constexpr std::string_view kInput = "INPUT";
constexpr const char* kOpenConfig = "CONFIG is not closed by `END;`";

/// Where a line of `text` begins with the word INPUT; npos when none does.
std::size_t input_heading(std::string_view text) {
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    if (word_at_front(line) == kInput) return static_cast<std::size_t>(line.data() - text.data());
    begin = end + 1;
  }
  return std::string_view::npos;
}

/// The statements of the INPUT section, or of the whole text when it has no sections.
std::vector<Statement> input_statements(std::string_view text, std::vector<Diagnostic>& faults) {
  enum class Section { none, config, input };
  Section section = Section::none;
  SourcePosition opened;
  std::vector<Statement> statements;
  StatementCursor cursor(text, {});
  while (!cursor.rest().empty()) {
    Statement statement = cursor.next();
    std::string_view word = word_at_front(statement.text);
    if (section == Section::none && (word == "CONFIG" || word == "INPUT")) {
      section = word == "CONFIG" ? Section::config : Section::input;
      opened = statement.begin;
      statement = behind(statement, word.size());
      word = word_at_front(statement.text);
    }
    if (word == "END" && word.size() == statement.text.size() && statement.is_ended) {
      if (section == Section::input) return statements;
      section = Section::none;
      continue;
    }
    if (section == Section::config) {
      // A CONFIG that lost its `END;` would swallow the whole file, and the faults in it.
      const std::size_t input = input_heading(statement.text);
      if (input == std::string_view::npos) continue;
      faults.push_back({opened, kOpenConfig});
      section = Section::input;
      opened = after(statement.begin, statement.text.substr(0, input));
      statement = behind(statement, input + kInput.size());
    }
    if ((statement.text.empty() && !statement.is_ended)) continue;
    statements.push_back(statement);
  }
  if (section == Section::config) faults.push_back({opened, kOpenConfig});
  if (section == Section::input) faults.push_back({opened, "INPUT is not closed by `END;`"});
  return statements;
}

/// A file's declarations and values as they become known.
class BertiniReader {
 public:
  /// constants: those that stay names; nullptr where parameters are refused.
  explicit BertiniReader(std::vector<Diagnostic>& faults,
                         const std::vector<std::string>* constants = nullptr)
      : faults_(faults), expander_(faults), constants_(constants) {
    names_.emplace(kImaginaryUnit, constant({0, 1}));
  }

  System read(const std::vector<Statement>& statements);
  ParametricSystem read_parametric(const std::vector<Statement>& statements);

 private:
  enum class Role { variable, function, constant, subfunction, parameter, refused };
  struct Declared {
    Role role;
    SourcePosition at;
    std::optional<SourcePosition> value_at = {};  // of what is assigned
  };

  void declare(const Statement& statement);
  void declare(std::string_view name, const SourcePosition& at, const Keyword& keyword);
  void assign(const Statement& statement);
  bool may_assign(const std::string& name, const SourcePosition& at);
  void check_complete();
  void check_groups();
  void check_homogeneous(const std::string& function, const Polynomial& value);
  std::vector<VariableGroup> complete_groups() const;
  void refuse(const SourcePosition& at, const std::string& message) {
    faults_.push_back({at, message});
  }

  bool stays_name(const std::string& constant) const {
    return constants_ != nullptr &&
           std::find(constants_->begin(), constants_->end(), constant) != constants_->end();
  }

  std::vector<Diagnostic>& faults_;
  Expander expander_;
  const std::vector<std::string>* constants_;
  std::vector<std::string> parameters_;
  std::map<std::string, Coefficient> values_;  // of constants that stay names
  Environment names_;
  std::map<std::string, Declared, std::less<>> declared_;
  std::vector<std::string> variables_;
  std::vector<std::string> functions_;
  std::vector<VariableGroup> groups_;
  std::vector<SourcePosition> groups_at_;  // of the declarations of groups_
};

void BertiniReader::declare(std::string_view name, const SourcePosition& at,
                            const Keyword& keyword) {
  const std::string text(name);
  if (name.empty()) {
    refuse(at, "a name is missing here");
    return;
  }
  if (!is_name(name)) {
    refuse(at, first_line(name) + ": this is not a name; names are separated by `,`");
    return;
  }
  if (name == kImaginaryUnit) {
    refuse(at, "`I` is the imaginary unit and cannot be declared");
    return;
  }
  Role role = Role::refused;
  if (is_group(keyword) || keyword.word == "variable") role = Role::variable;
  if (keyword.word == "function") role = Role::function;
  if (keyword.word == "constant") role = Role::constant;
  if (keyword.word == kParameter && constants_ != nullptr) role = Role::parameter;
  const auto [place, is_new] = declared_.try_emplace(text, Declared{role, at});
  if (!is_new) {
    refuse(at,
           "`" + text + "` is declared already, at line " + std::to_string(place->second.at.line));
    return;
  }
  const bool is_name_of_family =
      role == Role::parameter || (role == Role::constant && stays_name(text));
  if (role == Role::parameter) parameters_.push_back(text);
  if (role == Role::variable || is_name_of_family) {
    const auto index = static_cast<std::uint32_t>(variables_.size());
    names_.emplace(text, unknown(index));
    variables_.push_back(text);
    if (is_group(keyword)) groups_.back().variables.push_back(index);
  }
  if (role == Role::function) functions_.push_back(text);
  if (role == Role::refused) names_.emplace(text, std::nullopt);
}

void BertiniReader::declare(const Statement& statement) {
  const Keyword& keyword = *find_keyword(word_at_front(statement.text));
  if (!keyword.refusal.empty() && !(keyword.word == kParameter && constants_ != nullptr)) {
    refuse(statement.begin, std::string(keyword.word) + ": " + std::string(keyword.refusal));
  }
  if (is_group(keyword)) {
    groups_.push_back({{}, keyword.word == kHomogeneousGroup});
    groups_at_.push_back(statement.begin);
  }
  Statement rest = behind(statement, keyword.word.size());
  for (;;) {
    const std::size_t comma = rest.text.find(',');
    declare(trimmed(rest.text.substr(0, comma)), rest.begin, keyword);
    if (comma == std::string_view::npos) return;
    rest = behind(rest, comma + 1);
  }
}

void BertiniReader::check_groups() {
  if (!faults_.empty()) return;  // a name at fault may be one of a group
  for (std::size_t k = 0; k < groups_.size(); ++k) {
    const VariableGroup& group = groups_[k];
    if (!group.is_homogeneous || group.variables.size() != 1) continue;
    const std::string& name = variables_[group.variables.front()];
    refuse(groups_at_[k], "hom_variable_group: one homogeneous coordinate has only one point, `" +
                              name + "` = 1; give that value as a constant");
  }
}

/// The unknowns of `variable` are a group too, the last one, where the file declares others.
std::vector<VariableGroup> BertiniReader::complete_groups() const {
  std::vector<VariableGroup> groups;
  std::vector<bool> is_in_group(variables_.size(), false);
  for (const VariableGroup& group : groups_) {
    if (!group.variables.empty()) groups.push_back(group);
    for (const std::uint32_t v : group.variables) is_in_group[v] = true;
  }
  VariableGroup rest;
  for (std::uint32_t v = 0; v < variables_.size(); ++v) {
    if (!is_in_group[v]) rest.variables.push_back(v);
  }
  if (!groups.empty() && !rest.variables.empty()) groups.push_back(std::move(rest));
  return groups;
}

bool BertiniReader::may_assign(const std::string& name, const SourcePosition& at) {
  if (name == kImaginaryUnit) {
    refuse(at, "`I` is the imaginary unit and cannot be assigned");
    return false;
  }
  const auto [place, is_new] = declared_.try_emplace(name, Declared{Role::subfunction, at});
  Declared& declared = place->second;
  if (declared.role == Role::variable || declared.role == Role::parameter) {
    refuse(at, "`" + name + "` is a " +
                   (declared.role == Role::variable ? "variable" : "parameter of the family") +
                   " and cannot be assigned");
    return false;
  }
  if (declared.value_at) {
    refuse(at, "`" + name + "` is assigned already");
    return false;
  }
  declared.value_at = at;
  return true;
}

void BertiniReader::assign(const Statement& statement) {
  const std::string name(word_at_front(statement.text));
  const Statement sign = behind(statement, name.size());
  if (!is_name(name) || sign.text.empty() || sign.text.front() != '=') {
    refuse(statement.begin,
           "expected a declaration or `name = expression`, found: " + first_line(statement.text));
    return;
  }
  if (!may_assign(name, statement.begin)) return;
  const Statement right = behind(sign, 1);
  declared_.find(name)->second.value_at = right.begin;
  std::optional<Polynomial> value = expander_.expand(right.text, right.begin, names_);
  if (value && declared_.find(name)->second.role == Role::constant && degree(*value) > 0) {
    refuse(right.begin, "the constant `" + name + "` holds a variable");
  }
  if (declared_.find(name)->second.role == Role::constant && stays_name(name)) {
    if (value && degree(*value) == 0) {
      values_[name] = value->terms.empty() ? Coefficient{} : value->terms.front().coefficient;
    }
    return;
  }
  names_.insert_or_assign(name, std::move(value));
}

void BertiniReader::check_homogeneous(const std::string& function, const Polynomial& value) {
  for (std::size_t k = 0; k < groups_.size(); ++k) {
    if (!groups_[k].is_homogeneous) continue;
    const std::set<std::uint64_t> found = degrees_in(value, groups_[k].variables);
    if (found.size() <= 1) continue;
    refuse(*declared_.find(function)->second.value_at,
           "`" + function + "` is not homogeneous in the hom_variable_group of line " +
               std::to_string(groups_at_[k].line) + ": it has terms of degree " +
               std::to_string(*found.rbegin()) + " and of degree " +
               std::to_string(*found.begin()));
  }
}

void BertiniReader::check_complete() {
  for (const auto& [name, declared] : declared_) {
    const bool needs_value = declared.role == Role::function || declared.role == Role::constant;
    if (needs_value && !declared.value_at) {
      refuse(declared.at, "`" + name + "` is declared, but nothing is assigned to it");
    }
  }
  const bool is_refused = std::any_of(declared_.begin(), declared_.end(), [](const auto& entry) {
    return entry.second.role == Role::refused;
  });
  if (variables_.empty() && !is_refused)
    refuse({}, "no variable is declared (variable_group x, y;)");
  if (functions_.empty()) refuse({}, "no function is declared (function f, g;)");
}

System BertiniReader::read(const std::vector<Statement>& statements) {
  const auto is_declaration = [](const Statement& s) {
    return is_bertini_keyword(word_at_front(s.text));
  };
  for (const Statement& statement : statements) {
    if (!statement.is_ended) {
      refuse(statement.begin, "this statement has no `;` behind it");
    }
    if (is_declaration(statement)) declare(statement);
  }
  for (const Statement& statement : statements) {
    if (statement.text.empty()) continue;
    if (!is_declaration(statement)) assign(statement);
  }
  check_complete();
  check_groups();
  System system{.variables = variables_,
                .polynomials = {},
                .groups = complete_groups(),
                .is_exact = !expander_.has_rounded_number()};
  for (const std::string& name : functions_) {
    const auto value = names_.find(name);
    if (value == names_.end() || !value->second) continue;
    const bool is_added =
        expander_.add_equation(*value->second, declared_.find(name)->second.at, system);
    if (is_added) check_homogeneous(name, system.polynomials.back());
  }
  system.denominators = expander_.denominators();
  return system;
}

ParametricSystem BertiniReader::read_parametric(const std::vector<Statement>& statements) {
  ParametricSystem result;
  result.system = read(statements);
  result.declared = parameters_;
  result.constants = values_;
  return result;
}

}  // namespace

bool is_bertini_keyword(std::string_view word) { return find_keyword(word) != nullptr; }

std::string without_bertini_comments(std::string text) {
  bool is_comment = false;
  for (char& c : text) {
    if (c == '\n') is_comment = false;
    if (c == '%') is_comment = true;
    if (is_comment) c = ' ';
  }
  return text;
}

System read_bertini(const Source& source, std::vector<Diagnostic>& faults) {
  const std::string text = without_bertini_comments(source.text);
  return BertiniReader(faults).read(input_statements(text, faults));
}

ParametricSystem read_parametric_bertini(const Source& source,
                                         const std::vector<std::string>& constants,
                                         std::vector<Diagnostic>& faults) {
  const std::string text = without_bertini_comments(source.text);
  return BertiniReader(faults, &constants).read_parametric(input_statements(text, faults));
}

}  // namespace moivre
