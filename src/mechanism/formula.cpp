// SPDX-License-Identifier: MIT
// How does a typed expression become a formula? Names and functions looked up once, numbers rounded
// once.
#include "moivre/mechanism/formula.h"

#include <algorithm>
#include <numbers>
#include <optional>

#include "moivre/mechanism/gradient.h"
#include "moivre/mechanism/jet.h"
#include "moivre/mechanism/nearest.h"
#include "refusals.h"

namespace moivre {
namespace {

using Kind = Formula::Kind;

const std::map<std::string, Kind>& functions() {
  static const std::map<std::string, Kind> table{
      {"sin", Kind::sin},   {"cos", Kind::cos},   {"tan", Kind::tan},
      {"asin", Kind::asin}, {"acos", Kind::acos}, {"atan", Kind::atan},
      {"sqrt", Kind::sqrt}, {"exp", Kind::exp},   {"log", Kind::log}};
  return table;
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const auto& [name, kind] : functions()) names.push_back(name);
  return names;
}

std::vector<std::string> known_names(const Names& names) {
  std::vector<std::string> known;
  for (const auto& [name, index] : names.unknowns) known.push_back(name);
  for (const auto& [name, value] : names.constants) known.push_back(name);
  known.emplace_back("pi");
  if (names.has_time) known.emplace_back("t");
  return known;
}

/// Whether a name or a function looks like a derivative: phi_dot, dot(phi), dphi_dt, dphi/dt,
/// der(phi), diff(phi, t).
bool is_derivative(const std::string& name) {
  static const std::vector<std::string> words{"der", "diff", "deriv",    "derivative",
                                              "d",   "D",    "velocity", "acceleration",
                                              "dot", "ddot", "dt"};
  const bool ends_in_dot = name.size() > 3 && name.substr(name.size() - 3) == "dot";
  const bool ends_in_dt = name.size() > 3 && name.substr(name.size() - 3) == "_dt";
  return ends_in_dot || ends_in_dt || std::find(words.begin(), words.end(), name) != words.end();
}

Formula resolve_name(const Expression& expression, const Names& names,
                     std::vector<Diagnostic>& faults) {
  Formula result;
  if (const auto unknown = names.unknowns.find(expression.name); unknown != names.unknowns.end()) {
    result.kind = Kind::unknown;
    result.index = unknown->second;
  } else if (const auto constant = names.constants.find(expression.name);
             constant != names.constants.end()) {
    result.value = constant->second;
  } else if (expression.name == "pi") {
    result.value = std::numbers::pi;
  } else if (names.has_time && expression.name == "t") {
    result.kind = Kind::time;
  } else if (is_derivative(expression.name)) {
    faults.push_back({expression.at, "'" + expression.name + "'" + kLooksLikeADerivative});
  } else {
    faults.push_back({expression.at, "'" + expression.name +
                                         "' is neither an unknown nor a constant" +
                                         suggestion(expression.name, known_names(names))});
  }
  return result;
}

Kind function_of(const Expression& call, std::vector<Diagnostic>& faults) {
  const auto found = functions().find(call.name);
  if (found == functions().end()) {
    faults.push_back({call.at, is_derivative(call.name)
                                   ? "'" + call.name + "'" + kLooksLikeADerivative
                                   : "unknown function '" + call.name + "'" +
                                         suggestion(call.name, function_names())});
    return Kind::sin;
  }
  if (call.operands.size() != 1) {
    faults.push_back({call.at, "'" + call.name + "' takes one argument"});
  }
  return found->second;
}

Kind checked_kind(const Expression& expression, std::vector<Diagnostic>& faults) {
  switch (expression.kind) {
    case Expression::Kind::sum:
      return Kind::sum;
    case Expression::Kind::product:
      return Kind::product;
    case Expression::Kind::negate:
      return Kind::negate;
    case Expression::Kind::reciprocal:
      return Kind::reciprocal;
    case Expression::Kind::power:
      return Kind::power;
    case Expression::Kind::call:
      return function_of(expression, faults);
    case Expression::Kind::number:
    case Expression::Kind::name:
      break;
  }
  return Kind::constant;
}

/// The value of a formula without names of unknowns or time.
std::optional<double> constant_value(const Formula& formula) {
  if (depends_on_time(formula) || !unknowns_of(formula).empty()) return std::nullopt;
  return evaluate<Jet>(formula, {}, Jet(0)).f;
}

void collect(const Formula& formula, std::vector<std::size_t>& found) {
  if (formula.kind == Kind::unknown) found.push_back(formula.index);
  for (const Formula& operand : formula.operands) collect(operand, found);
}

template <class S>
S evaluate_power(const Formula& formula, std::span<const S> q, const S& t) {
  const S base = evaluate<S>(formula.operands[0], q, t);
  const Formula& exponent = formula.operands[1];
  if (exponent.kind == Kind::constant) return power(base, exponent.value);
  return exp(evaluate<S>(exponent, q, t) * log(base));
}

template <class S>
S evaluate_call(const Formula& formula, const S& a) {
  switch (formula.kind) {
    case Kind::negate:
      return -a;
    case Kind::reciprocal:
      return reciprocal(a);
    case Kind::sin:
      return sin(a);
    case Kind::cos:
      return cos(a);
    case Kind::tan:
      return tan(a);
    case Kind::asin:
      return asin(a);
    case Kind::acos:
      return acos(a);
    case Kind::atan:
      return atan(a);
    case Kind::sqrt:
      return sqrt(a);
    case Kind::exp:
      return exp(a);
    case Kind::log:
      return log(a);
    case Kind::constant:
    case Kind::unknown:
    case Kind::time:
    case Kind::sum:
    case Kind::product:
    case Kind::power:
      break;
  }
  return a;
}

}  // namespace

Formula resolve(const Expression& expression, const Names& names, std::vector<Diagnostic>& faults) {
  if (expression.kind == Expression::Kind::name) return resolve_name(expression, names, faults);
  Formula result;
  if (expression.kind == Expression::Kind::number) {
    result.value = to_double(expression.number);
    return result;
  }
  const std::size_t faults_before = faults.size();
  result.kind = checked_kind(expression, faults);
  for (const Expression& operand : expression.operands) {
    result.operands.push_back(resolve(operand, names, faults));
  }
  const bool folds_exponent = result.kind == Kind::power && faults.size() == faults_before;
  if (folds_exponent) {
    if (const auto value = constant_value(result.operands[1])) {
      result.operands[1] = Formula{};
      result.operands[1].value = *value;
    }
  }
  return result;
}

std::vector<std::size_t> unknowns_of(const Formula& formula) {
  std::vector<std::size_t> found;
  collect(formula, found);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool depends_on_time(const Formula& formula) {
  return formula.kind == Kind::time ||
         std::any_of(formula.operands.begin(), formula.operands.end(), depends_on_time);
}

template <class S>
S evaluate(const Formula& formula, std::span<const S> q, const S& t) {
  switch (formula.kind) {
    case Kind::constant:
      return S(formula.value);
    case Kind::unknown:
      return q[formula.index];
    case Kind::time:
      return t;
    case Kind::power:
      return evaluate_power(formula, q, t);
    case Kind::sum: {
      S total(0);
      for (const Formula& term : formula.operands) total = total + evaluate<S>(term, q, t);
      return total;
    }
    case Kind::product: {
      S total(1);
      for (const Formula& factor : formula.operands) total = total * evaluate<S>(factor, q, t);
      return total;
    }
    case Kind::negate:
    case Kind::reciprocal:
    case Kind::sin:
    case Kind::cos:
    case Kind::tan:
    case Kind::asin:
    case Kind::acos:
    case Kind::atan:
    case Kind::sqrt:
    case Kind::exp:
    case Kind::log:
      break;
  }
  return evaluate_call(formula, evaluate<S>(formula.operands[0], q, t));
}

template Jet evaluate<Jet>(const Formula&, std::span<const Jet>, const Jet&);
template Gradient evaluate<Gradient>(const Formula&, std::span<const Gradient>, const Gradient&);
template Magnitude evaluate<Magnitude>(const Formula&, std::span<const Magnitude>,
                                       const Magnitude&);

}  // namespace moivre
