// SPDX-License-Identifier: MIT
// A parameter for each term, and the values that a system gives them.
#include "moivre/family/coefficients.h"

#include <algorithm>

#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

std::string name_of(std::size_t equation, std::size_t term) {
  std::string name = "c";
  return name.append(std::to_string(equation)).append("_").append(std::to_string(term));
}

/// A name that no unknown has.
std::string fresh(std::string name, const std::vector<std::string>& unknowns) {
  while (std::find(unknowns.begin(), unknowns.end(), name) != unknowns.end()) name += '_';
  return name;
}

Monomial unknowns_of(const Monomial& monomial, std::size_t unknowns) {
  Monomial result;
  for (const Power& power : monomial) {
    if (power.variable < unknowns) result.push_back(power);
  }
  return result;
}

}  // namespace

Family coefficient_family(const System& member) {
  const std::size_t n = member.variables.size();
  if (member.polynomials.size() != n) {
    throw InvalidInput("a family has as many equations as unknowns, got " +
                       std::to_string(member.polynomials.size()) + " in " + std::to_string(n));
  }
  Family family;
  family.system.variables = member.variables;
  for (std::size_t i = 0; i < n; ++i) {
    if (member.polynomials[i].terms.empty()) {
      throw InvalidInput("equation " + std::to_string(i + 1) + " is 0");
    }
    TermMap terms;
    for (std::size_t k = 0; k < member.polynomials[i].terms.size(); ++k) {
      const Term& term = member.polynomials[i].terms[k];
      Monomial monomial = term.monomial;
      monomial.push_back({static_cast<std::uint32_t>(family.system.variables.size()), 1});
      terms[monomial] = Coefficient{1, 0};
      family.system.variables.push_back(fresh(name_of(i + 1, k + 1), member.variables));
      const double size = std::abs(to_complex(term.coefficient));
      family.sizes.push_back(size > 0 && std::isfinite(size) ? size : 1);
    }
    family.system.polynomials.push_back(to_polynomial(std::move(terms)));
  }
  return family;
}

std::optional<ParameterValues> coefficients_in(const Family& family, const System& f) {
  const std::size_t n = family.unknowns();
  if (f.variables.size() != n || f.polynomials.size() != n) return std::nullopt;
  ParameterValues values(family.parameters());
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t found = 0;
    for (const Term& place : family.system.polynomials[i].terms) {
      const Monomial monomial = unknowns_of(place.monomial, n);
      const auto& terms = f.polynomials[i].terms;
      const auto term = std::find_if(terms.begin(), terms.end(),
                                     [&](const Term& t) { return t.monomial == monomial; });
      if (term == terms.end()) continue;
      values[place.monomial.back().variable - n] = term->coefficient;
      ++found;
    }
    if (found != f.polynomials[i].terms.size()) return std::nullopt;
  }
  return values;
}

}  // namespace moivre
