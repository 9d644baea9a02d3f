// SPDX-License-Identifier: MIT
// How are typed equations parsed? Both sides of an equals sign, inequalities and derivatives
// refused with the reason.
#include "read_formula.h"

#include <algorithm>

#include "moivre/expression/words.h"
#include "refusals.h"

namespace moivre {

bool refuse_constraint(Reading& reading, const toml::node& node, const std::string& text) {
  const std::size_t found = text.find_first_of("<>'");
  if (found == std::string::npos) return false;
  SourcePosition at = reading.text_begin(node, text);
  at.offset += found;
  at.column += found;
  const bool is_prime = text[found] == '\'';
  reading.fault(at, is_prime ? std::string("`'`") + kLooksLikeADerivative : kOneSidedEquation);
  return true;
}

std::optional<Expression> read_expression(Reading& reading, const toml::node& node,
                                          const std::string& text) {
  if (refuse_constraint(reading, node, text)) return std::nullopt;
  const std::size_t faults_before = reading.faults().size();
  const SourcePosition begin = reading.text_begin(node, text);
  const EqualsSign equals = equals_sign(text);
  const bool has_sides = equals.length > 0;
  Expression left =
      parse_expression(std::string_view(text).substr(0, has_sides ? equals.at : text.size()), begin,
                       reading.faults());
  if (has_sides) {
    const std::size_t sign_end = equals.at + equals.length;
    SourcePosition behind = begin;
    behind.offset += sign_end;
    behind.column += sign_end;
    Expression right =
        parse_expression(std::string_view(text).substr(sign_end), behind, reading.faults());
    Expression minus_right{Expression::Kind::negate, right.at, {}, {}, {}};
    minus_right.operands.push_back(std::move(right));
    Expression difference{Expression::Kind::sum, begin, {}, {}, {}};
    difference.operands.push_back(std::move(left));
    difference.operands.push_back(std::move(minus_right));
    left = std::move(difference);
  }
  if (reading.faults().size() != faults_before) return std::nullopt;
  return left;
}

void check_names(Reading& reading, const toml::node& node, const std::string& text,
                 const Names& names) {
  SourcePosition begin = reading.text_begin(node, text);
  std::vector<Diagnostic> known_faults;
  const auto resolve_summand = [&](const Expression& summand) {
    resolve(summand, names, reading.faults());
  };
  std::size_t at = 0;
  while (at <= text.size()) {
    const std::size_t end = std::min(text.find('=', at), text.size());
    parse_summands(std::string_view(text).substr(at, end - at), begin, known_faults,
                   resolve_summand);
    begin.offset += end + 1 - at;
    begin.column += end + 1 - at;
    at = end + 1;
  }
}

std::optional<Formula> read_formula(Reading& reading, const Expression& expression,
                                    const Names& names) {
  const std::size_t faults_before = reading.faults().size();
  Formula formula = resolve(expression, names, reading.faults());
  if (reading.faults().size() != faults_before) return std::nullopt;
  return formula;
}

}  // namespace moivre
