// SPDX-License-Identifier: MIT
// Writing a system as text that reads back as the same system.
// Exact coefficients and the order of variables are kept.
#include <algorithm>

#include "moivre/expression/expression.h"
#include "moivre/expression/joined.h"
#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/double_range.h"
#include "moivre/polynomial/read.h"
#include "read_formats.h"

namespace moivre {

namespace {

/// Lines are broken before a sign once they are longer than this.
constexpr std::size_t kLineWidth = 90;
/// A fraction whose decimal form has at most this many digits is written as a decimal.
constexpr std::size_t kPlainDigits = 40;

Integer power_of_ten(std::size_t k) { return pow(Integer(10), static_cast<unsigned>(k)); }

/// n / 10^places in scientific notation: every digit stands, and only the exponent is large.
std::string scaled(const Integer& n, std::size_t places) {
  const std::string digits = n.str();
  const auto exponent = static_cast<long long>(digits.size()) - 1 - static_cast<long long>(places);
  std::string text = digits.substr(0, 1);
  if (digits.size() > 1) text += '.' + digits.substr(1);
  return exponent == 0 ? text : text + 'e' + std::to_string(exponent);
}

/// k such that n/d = integer / 10^k, when there is a small one.
std::optional<std::size_t> decimal_places(Integer d) {
  std::size_t twos = 0;
  std::size_t fives = 0;
  for (; d % 2 == 0 && twos <= kPlainDigits; ++twos) d /= 2;
  for (; d % 5 == 0 && fives <= kPlainDigits; ++fives) d /= 5;
  const std::size_t places = std::max(twos, fives);
  if (d != 1 || places > kPlainDigits) return std::nullopt;
  return places;
}

std::string plain_decimal(const Integer& n, std::size_t places) {
  std::string digits = n.str();
  if (places == 0) return digits;
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  return digits.insert(digits.size() - places, 1, '.');
}

struct Written {
  std::string text;
  bool is_fraction = false;
};

/// A positive number, exactly: an integer or a decimal where short, else a fraction of two numbers
/// that stay in double's range (both are divided by the same power of ten).
Written written(const Rational& r) {
  const Integer n = numerator(r);
  const Integer d = denominator(r);
  const std::optional<std::size_t> places = decimal_places(d);
  if (places && n.str().size() <= kPlainDigits) {
    return {plain_decimal(Integer(n * (power_of_ten(*places) / d)), *places)};
  }
  const std::size_t digits_n = n.str().size();
  const std::size_t digits_d = d.str().size();
  if (std::max(digits_n, digits_d) <= kPlainDigits) return {n.str() + '/' + d.str(), true};
  const std::size_t shift = (digits_n + digits_d) / 2;
  if (d == 1) return {scaled(n, 0)};
  return {scaled(n, shift) + '/' + scaled(d, shift), true};
}

/// "a", "(a/b)" or "(re+im*i)" and whether a minus stands before it.
struct Factor {
  std::string text;
  bool is_negative = false;
};

Factor factor_of(const Coefficient& c, const std::string& unit) {
  const Written re = written(abs(c.re));
  if (is_real(c)) return {re.is_fraction ? '(' + re.text + ')' : re.text, c.re < 0};
  const Written im = written(abs(c.im));
  const std::string imaginary = (im.is_fraction ? '(' + im.text + ')' : im.text) + '*' + unit;
  if (c.re.is_zero()) return {imaginary, c.im < 0};
  return {
      '(' + std::string(c.re < 0 ? "-" : "") + re.text + (c.im < 0 ? "-" : "+") + imaginary + ')',
      false};
}

class Writer {
 public:
  Writer(const System& f, std::string unit) : f_(f), unit_(std::move(unit)) {}

  /// The polynomial's terms; `lead` stands before them (an expression that is zero, or nothing).
  std::string polynomial(const Polynomial& p, const std::string& lead) const {
    if (p.terms.empty()) return lead.empty() ? "0" : lead;
    std::string text = lead;
    std::size_t line = 0;
    for (const Term& t : p.terms) {
      if (text.size() - line > kLineWidth) {
        line = text.size();
        text += "\n ";
      }
      append(text, t);
    }
    return text;
  }

  /// Behind the last polynomial: read back, they are the system's, and add nothing.
  std::string denominators() const {
    std::string text;
    for (const Polynomial& d : f_.denominators) text += "\n + 0/(" + polynomial(d, {}) + ")";
    return text;
  }

 private:
  void append(std::string& text, const Term& t) const {
    const Factor factor = factor_of(t.coefficient, unit_);
    if (text.empty()) {
      text += factor.is_negative ? "-" : "";
    } else {
      text += factor.is_negative ? " - " : " + ";
    }
    const bool shows_factor = factor.text != "1" || t.monomial.empty();
    if (shows_factor) text += factor.text;
    bool needs_times = shows_factor;
    for (const Power& power : t.monomial) {
      if (needs_times) text += '*';
      needs_times = true;
      text += f_.variables[power.variable];
      if (power.exponent > 1) text += '^' + std::to_string(power.exponent);
    }
  }

  const System& f_;
  std::string unit_;
};

void require_writable(const System& f, const std::vector<std::string>& reserved) {
  if (f.polynomials.empty() || f.variables.empty()) {
    throw InvalidInput("a system without polynomials or without variables has no text");
  }
  for (const std::string& name : f.variables) {
    const bool is_reserved = std::find(reserved.begin(), reserved.end(), name) != reserved.end();
    if (!is_one_name(name) || is_reserved || is_bertini_keyword(name)) {
      throw InvalidInput("the variable's name `" + name + "` cannot be written");
    }
  }
}

/// The variables in the order in which the text of the polynomials would show them.
std::vector<std::uint32_t> appearance(const System& f) {
  std::vector<std::uint32_t> order;
  std::vector<bool> is_seen(f.variables.size(), false);
  for (const Polynomial& p : f.polynomials) {
    for (const Term& t : p.terms) {
      for (const Power& power : t.monomial) {
        if (is_seen[power.variable]) continue;
        is_seen[power.variable] = true;
        order.push_back(power.variable);
      }
    }
  }
  return order;
}

/// PHCpack's text declares no variables; x+y-x-y before the first polynomial fixes their order.
std::string order_lead(const System& f) {
  const std::vector<std::uint32_t> order = appearance(f);
  const bool is_natural =
      order.size() == f.variables.size() && std::is_sorted(order.begin(), order.end());
  if (is_natural) return {};
  std::string lead;
  for (const char* sign : {"+", "-"}) {
    for (const std::string& name : f.variables) {
      if (!lead.empty()) lead += sign;
      lead += name;
    }
  }
  return lead;
}

std::string phcpack_text(const System& f) {
  require_writable(f, {"i", "I", "pi", "\u03c0"});
  const Writer writer(f, "i");
  std::string text = std::to_string(f.polynomials.size());
  if (f.variables.size() != f.polynomials.size()) text += ' ' + std::to_string(f.variables.size());
  text += '\n';
  std::string lead = order_lead(f);
  for (std::size_t k = 0; k < f.polynomials.size(); ++k) {
    const bool is_last = k + 1 == f.polynomials.size();
    text +=
        writer.polynomial(f.polynomials[k], lead) + (is_last ? writer.denominators() : "") + ";\n";
    lead.clear();
  }
  return text;
}

/// A prefix that makes no function's name a variable's.
std::string function_prefix(const System& f) {
  std::string prefix = "f";
  const auto is_taken = [&](const std::string& name) {
    return name.compare(0, prefix.size(), prefix) == 0;
  };
  while (std::any_of(f.variables.begin(), f.variables.end(), is_taken)) prefix += '_';
  return prefix;
}

constexpr const char* kGroupsOutOfOrder =
    "groups whose variables do not stand one behind another, and hold all of them, cannot be "
    "written";

/// Declarations that give the variables in their order.
std::string group_declarations(const System& f) {
  std::string text;
  std::uint32_t next = 0;
  for (const VariableGroup& group : f.groups) {
    std::vector<std::string> names;
    for (const std::uint32_t v : group.variables) {
      if (v != next++) throw InvalidInput(kGroupsOutOfOrder);
      names.push_back(f.variables[v]);
    }
    text += (group.is_homogeneous ? "hom_variable_group " : "variable_group ") +
            joined(names, ", ") + ";\n";
  }
  if (f.groups.empty()) return "variable_group " + joined(f.variables, ", ") + ";\n";
  if (next != f.variables.size()) throw InvalidInput(kGroupsOutOfOrder);
  return text;
}

std::string bertini_text(const System& f) {
  require_writable(f, {"I"});
  const Writer writer(f, "I");
  std::vector<std::string> functions;
  const std::string prefix = function_prefix(f);
  for (std::size_t k = 1; k <= f.polynomials.size(); ++k)
    functions.push_back(prefix + std::to_string(k));
  std::string text = "CONFIG\nEND;\nINPUT\n" + group_declarations(f) + "function " +
                     joined(functions, ", ") + ";\n";
  for (std::size_t k = 0; k < f.polynomials.size(); ++k) {
    const bool is_last = k + 1 == f.polynomials.size();
    text += functions[k] + " = " + writer.polynomial(f.polynomials[k], {}) +
            (is_last ? writer.denominators() : "") + ";\n";
  }
  return text + "END;\n";
}

}  // namespace

std::string to_text(const System& f, PolynomialFormat format) {
  if (!f.scaled_log2.empty()) return to_text(as_typed(f), format);
  return format == PolynomialFormat::bertini ? bertini_text(f) : phcpack_text(f);
}

}  // namespace moivre
