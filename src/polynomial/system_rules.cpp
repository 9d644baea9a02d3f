// SPDX-License-Identifier: MIT
// Which rules does a system break that was put together in code? What a reader makes breaks none.
#include <algorithm>
#include <set>

#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/double_range.h"
#include "moivre/polynomial/system.h"
#include "read_formats.h"

namespace moivre {
namespace {

using Rules = std::vector<std::string>;

void check_names(const System& f, Rules& broken) {
  std::set<std::string> names;
  for (std::size_t j = 0; j < f.variables.size(); ++j) {
    const std::string& name = f.variables[j];
    if (name.empty()) {
      broken.push_back("unknown " + std::to_string(j + 1) + " has no name");
    } else if (!names.insert(name).second) {
      broken.push_back("two unknowns are called '" + name + "'");
    }
  }
}

/// Names that an equation in a file cannot hold. Results have such ones all the same: `i` of
/// Bertini's files, x_{1} of sympy's expressions.
void check_names_are_typed(const std::vector<std::string>& names, Rules& broken) {
  const Environment meanings = meanings_of_constants();
  for (const std::string& name : names) {
    if (meanings.count(name) > 0) {
      broken.push_back("'" + name + "' has a meaning of its own; choose another name");
    } else if (!name.empty() && !is_one_name(name)) {
      broken.push_back("'" + name +
                       "' is no name of an unknown: a letter, then letters, digits, '_', '[1]'");
    }
  }
}

/// A clause; empty where the monomial is as it must be.
std::string fault_of(const Monomial& m, std::size_t unknowns) {
  for (std::size_t k = 0; k < m.size(); ++k) {
    if (m[k].variable >= unknowns) {
      return "has unknown " + std::to_string(m[k].variable) + ", counted from 0, of " +
             std::to_string(unknowns);
    }
    if (m[k].exponent == 0) return "has an exponent 0: exponents are 1 or more";
    if (k > 0 && m[k].variable <= m[k - 1].variable) {
      return "has unknowns that are not in their order, each once";
    }
  }
  return "";
}

void check_terms(const Polynomial& p, const std::string& place, std::size_t unknowns,
                 Rules& broken) {
  const std::string of_equation = " of " + place;
  const std::size_t before = broken.size();
  for (std::size_t k = 0; k < p.terms.size(); ++k) {
    std::string fault = fault_of(p.terms[k].monomial, unknowns);
    if (fault.empty() && is_zero(p.terms[k].coefficient)) fault = "has the coefficient 0";
    if (!fault.empty()) {
      broken.push_back("term " + std::to_string(k + 1) + of_equation + " " + fault);
    }
  }
  if (broken.size() > before) return;
  const auto is_out_of_order = [](const Term& a, const Term& b) {
    return !precedes(a.monomial, b.monomial);
  };
  const auto pair = std::adjacent_find(p.terms.begin(), p.terms.end(), is_out_of_order);
  if (pair != p.terms.end()) {
    broken.push_back("the terms" + of_equation +
                     " are not sorted by their monomials, each once (to_polynomial sorts them)");
  }
}

void check_groups(const System& f, Rules& broken) {
  std::vector<bool> is_in(f.variables.size());
  for (std::size_t g = 0; g < f.groups.size(); ++g) {
    const std::string group = "group " + std::to_string(g + 1);
    const std::vector<std::uint32_t>& members = f.groups[g].variables;
    if (!std::is_sorted(members.begin(), members.end())) {
      broken.push_back(group + " does not have its unknowns in their order");
    }
    for (const std::uint32_t j : members) {
      if (j >= f.variables.size()) {
        broken.push_back(group + " has unknown " + std::to_string(j) + ", counted from 0, of " +
                         std::to_string(f.variables.size()));
      } else if (is_in[j]) {
        broken.push_back("unknown '" + f.variables[j] + "' is in two groups");
      } else {
        is_in[j] = true;
      }
    }
  }
  const bool is_whole = std::find(is_in.begin(), is_in.end(), false) == is_in.end();
  if (!f.groups.empty() && !is_whole) broken.emplace_back("an unknown is in no group");
}

}  // namespace

std::vector<std::string> broken_rules(const System& f) {
  Rules broken;
  check_names(f, broken);
  for (std::size_t i = 0; i < f.polynomials.size(); ++i) {
    check_terms(f.polynomials[i], "equation " + std::to_string(i + 1), f.variables.size(), broken);
  }
  for (const Polynomial& denominator : f.denominators) {
    check_terms(denominator, "a denominator", f.variables.size(), broken);
  }
  for (const Condition& condition : f.conditions) {
    const Rules of_condition = broken_rules(condition, f.variables.size());
    broken.insert(broken.end(), of_condition.begin(), of_condition.end());
  }
  check_groups(f, broken);
  return broken;
}

std::vector<std::string> broken_rules(const Condition& condition, std::size_t unknowns) {
  Rules broken;
  const std::string place = "the condition '" + condition.text + "'";
  check_terms(condition.p, place, unknowns, broken);
  if (!is_real(condition.p)) broken.push_back(place + " has a coefficient that is not real");
  return broken;
}

System make_system(std::vector<std::string> variables, std::vector<Polynomial> polynomials) {
  System f{std::move(variables), std::move(polynomials)};
  Rules broken = broken_rules(f);
  check_names_are_typed(f.variables, broken);
  require_unbroken(broken);
  return held_by_double(std::move(f));
}

}  // namespace moivre
