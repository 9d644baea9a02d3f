// SPDX-License-Identifier: MIT
// Values of parameters, typed on the command line or in a table.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "moivre/expression/expression.h"
#include "moivre/expression/joined.h"
#include "moivre/expression/words.h"
#include "moivre/family/members.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

constexpr std::int64_t kLargestPower = 1000;

std::optional<Coefficient> value_of(const Expression& e);

std::optional<Coefficient> power_of(const Coefficient& base, const Coefficient& exponent) {
  const double e = to_complex(exponent).real();
  if (!is_real(exponent) || e != std::floor(e) || std::abs(e) > kLargestPower) return std::nullopt;
  if (e < 0 && is_zero(base)) return std::nullopt;
  Coefficient result{1, 0};
  for (int k = 0; k < std::abs(static_cast<int>(e)); ++k) result = result * base;
  return e < 0 ? Coefficient{1, 0} / result : result;
}

/// The operands' values; nullopt where one has none.
std::optional<std::vector<Coefficient>> values_of(const std::vector<Expression>& operands) {
  std::vector<Coefficient> values;
  for (const Expression& operand : operands) {
    const std::optional<Coefficient> value = value_of(operand);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::optional<Coefficient> value_of(const Expression& e) {
  if (e.kind == Expression::Kind::number) return Coefficient{e.number, 0};
  if (e.kind == Expression::Kind::name) {
    if (e.name != "i" && e.name != "I") return std::nullopt;
    return Coefficient{0, 1};
  }
  const auto values = values_of(e.operands);
  if (!values || values->empty()) return std::nullopt;
  Coefficient result = values->front();
  switch (e.kind) {
    case Expression::Kind::sum:
      for (std::size_t k = 1; k < values->size(); ++k) result = result + (*values)[k];
      return result;
    case Expression::Kind::product:
      for (std::size_t k = 1; k < values->size(); ++k) result = result * (*values)[k];
      return result;
    case Expression::Kind::negate:
      return -result;
    case Expression::Kind::reciprocal:
      if (is_zero(result)) return std::nullopt;
      return Coefficient{1, 0} / result;
    case Expression::Kind::power:
      return power_of(result, values->back());
    case Expression::Kind::number:
    case Expression::Kind::name:
    case Expression::Kind::call:
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Coefficient> to_value(std::string_view text) {
  if (trimmed(text).empty()) return std::nullopt;
  std::vector<Diagnostic> faults;
  const Expression e = parse_expression(text, {}, faults);
  return faults.empty() ? value_of(e) : std::nullopt;
}

/// Its parts are finite as doubles, and 0 only where they are.
bool fits_a_double(const Coefficient& value) {
  const auto fits = [](const Rational& part) {
    const double rounded = to_double(part);
    return std::isfinite(rounded) && (rounded != 0 || part.is_zero());
  };
  return fits(value.re) && fits(value.im);
}

std::optional<std::size_t> index_of(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::vector<std::string> without_value(const std::vector<std::string>& names,
                                       const std::vector<bool>& is_given) {
  std::vector<std::string> missing;
  for (std::size_t j = 0; j < names.size(); ++j) {
    if (!is_given[j]) missing.push_back(names[j]);
  }
  return missing;
}

/// A table row by row.
class TableReader {
 public:
  TableReader(const Source& source, const Family& family)
      : source_(source), names_(family.parameter_names()) {}

  std::vector<Point> read() {
    std::string_view rest = source_.text;
    SourcePosition at;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      read_line(rest.substr(0, end), at);
      const std::size_t next = std::min(end + 1, rest.size());
      at = after(at, rest.substr(0, next));
      rest.remove_prefix(next);
    }
    if (!has_head_) faults_.push_back({{}, "the table is empty: its first line names the columns"});
    if (!faults_.empty()) throw ParseError(source_, std::move(faults_));
    return std::move(members_);
  }

 private:
  void read_line(std::string_view line, const SourcePosition& at) {
    const std::string_view text = trimmed(line);
    if (text.empty() || text.front() == '#') return;
    const std::vector<std::string_view> cells = cells_of(line);
    if (!has_head_) return read_head(cells, line, at);
    if (cells.size() != columns_.size()) {
      faults_.push_back({at, "this row has " + std::to_string(cells.size()) +
                                 " columns, the head " + std::to_string(columns_.size())});
      return;
    }
    Point member(names_.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::optional<Coefficient> value = to_value(cells[k]);
      if (!value) {
        faults_.push_back({position(cells[k], line, at),
                           "this is not a number: " + std::string(trimmed(cells[k]))});
      } else if (!fits_a_double(*value)) {
        faults_.push_back(
            {position(cells[k], line, at),
             "this is too large or too small for a double: " + std::string(trimmed(cells[k]))});
      } else if (columns_[k]) {
        member[*columns_[k]] = to_complex(*value);
      }
    }
    members_.push_back(std::move(member));
  }

  void read_head(const std::vector<std::string_view>& cells, std::string_view line,
                 const SourcePosition& at) {
    has_head_ = true;
    std::vector<bool> is_given(names_.size(), false);
    for (const std::string_view cell : cells) {
      const std::string name(trimmed(cell));
      columns_.push_back(index_of(names_, name));
      if (!columns_.back()) {
        faults_.push_back({position(cell, line, at), "the family has no parameter " + name +
                                                         "; its parameters are " +
                                                         joined(names_, ", ")});
      } else if (is_given[*columns_.back()]) {
        faults_.push_back({position(cell, line, at), "the column " + name + " occurs twice"});
      } else {
        is_given[*columns_.back()] = true;
      }
    }
    const std::vector<std::string> missing = without_value(names_, is_given);
    if (missing.empty()) return;
    faults_.push_back({at, "the table has no value for " + joined(missing, ", ")});
  }

  static SourcePosition position(std::string_view cell, std::string_view line,
                                 const SourcePosition& at) {
    const std::string_view text = trimmed(cell);
    const auto offset = static_cast<std::size_t>(text.data() - line.data());
    return after(at, line.substr(0, offset));
  }

  const Source& source_;
  std::vector<std::string> names_;
  std::vector<std::optional<std::size_t>> columns_;
  bool has_head_ = false;
  std::vector<Diagnostic> faults_;
  std::vector<Point> members_;
};

}  // namespace

ParameterValues values_at(const Family& family, const std::string& text) {
  const std::vector<std::string> names = family.parameter_names();
  ParameterValues values(names.size());
  std::vector<bool> is_given(names.size(), false);
  std::vector<std::string> faults;
  for (const std::string_view part : cells_of(text)) {
    const std::size_t equals = part.find('=');
    const std::string name(trimmed(part.substr(0, equals)));
    const auto index = index_of(names, name);
    if (equals == std::string_view::npos) {
      faults.push_back(name + ": write name=value");
    } else if (!index) {
      faults.push_back("the family has no parameter " + name + "; its parameters are " +
                       joined(names, ", "));
    } else if (is_given[*index]) {
      faults.push_back(name + " is given twice");
    } else {
      is_given[*index] = true;
      const std::string_view number = part.substr(equals + 1);
      if (const auto value = to_value(number)) {
        values[*index] = *value;
      } else {
        faults.push_back(name + "=" + std::string(trimmed(number)) + ": this is not a number");
      }
    }
  }
  const std::vector<std::string> missing = without_value(names, is_given);
  if (!missing.empty()) faults.push_back("no value for " + joined(missing, ", "));
  require_unbroken(faults);
  return values;
}

std::vector<Point> read_members(const Source& source, const Family& family) {
  return TableReader(source, family).read();
}

}  // namespace moivre
