// SPDX-License-Identifier: MIT
// Facts of a system, and the refusal of those that are not square.
#include "facts.h"

#include <algorithm>

#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"
#include "solver_sentences.h"

namespace moivre {

SystemFacts facts_of(const System& f) {
  return {f.variables, degrees(f), total_degree(degrees(f)), 0};
}

namespace {

/// Is `name` the names of two others side by side? Then a product may have been meant.
std::string meant_product(const std::vector<std::string>& names, const std::string& name) {
  const auto is_name = [&](const std::string& part) {
    return std::find(names.begin(), names.end(), part) != names.end();
  };
  for (std::size_t k = 1; k < name.size(); ++k) {
    const std::string left = name.substr(0, k);
    const std::string right = name.substr(k);
    if (is_name(left) && is_name(right)) {
      return meant_product_clause(left, right);
    }
  }
  return {};
}

/// " (xy, x, y)", for a reader who counted fewer.
std::string named_unknowns(const std::vector<std::string>& names) {
  constexpr std::size_t kListed = 20;
  std::string text = " (";
  std::string products;
  for (std::size_t k = 0; k < std::min(names.size(), kListed); ++k) {
    text += (k > 0 ? ", " : "") + names[k];
    products += meant_product(names, names[k]);
  }
  if (names.size() > kListed) text += " and " + std::to_string(names.size() - kListed) + " more";
  return text + products + ')';
}

}  // namespace

void require_square(const System& f) {
  const std::size_t equations = f.polynomials.size();
  const std::size_t unknowns = f.variables.size();
  if (equations == unknowns) return;
  throw InvalidInput(
      "the system has " + counted(equations, "equation") + " in " + counted(unknowns, "unknown") +
      (unknowns > equations ? named_unknowns(f.variables) : "") + ": " +
      (equations > unknowns
           ? "it is overdetermined, and paths belong to the system that solve squares it up to"
           : "it is underdetermined: its roots form sets of dimension " +
                 std::to_string(unknowns - equations) +
                 " or more, and none is isolated. `slice` cuts them by random linear "
                 "equations"));
}

}  // namespace moivre
