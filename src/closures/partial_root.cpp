// SPDX-License-Identifier: MIT
// What is known of a root when some blocks are solved: values in its equations, and its image.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "moivre/closures/stages.h"
#include "moivre/formulation/exact.h"

namespace moivre {

Polynomial substituted(const Polynomial& p, const std::vector<KnownValue>& value,
                       const std::vector<std::uint32_t>& place) {
  TermMap terms;
  for (const Term& term : p.terms) {
    Coefficient c = term.coefficient;
    Monomial rest;
    for (const Power& power : term.monomial) {
      if (const auto& known = value[power.variable]) {
        for (std::uint32_t k = 0; k < power.exponent; ++k) c = c * known->exact;
      } else {
        rest.push_back({place[power.variable], power.exponent});
      }
    }
    std::sort(rest.begin(), rest.end());
    const auto [at, is_new] = terms.emplace(std::move(rest), c);
    if (!is_new) at->second = at->second + c;
  }
  return to_polynomial(std::move(terms));
}

double distance_from_image(const Formulation& formulation, const PartialRoot& root) {
  double size = 1;
  double apart = 0;
  for (std::size_t v = 0; v < root.value.size(); ++v) {
    const auto& image = root.value[formulation.mirror[v]];
    if (!root.value[v] || !image) continue;
    const Complex x = root.value[v]->rounded;
    size = std::max(size, std::abs(x));
    apart = std::max(apart, std::abs(x - std::conj(image->rounded)));
  }
  return apart / size;
}

bool may_be_real(const Formulation& formulation, const PartialRoot& root) {
  return distance_from_image(formulation, root) <= (root.singular ? kHoldsSingular : kHolds);
}

bool is_rounded(const Formulation& formulation) {
  const System& f = formulation.system;
  return formulation.has_rounded_frames || f.polynomials.size() > f.variables.size();
}

bool is_of_parted(double condition, double product) {
  constexpr double kExplained = 1e6;
  // Of a pivot that rounding made 0 it is as large as it can.
  constexpr double kMeasured = 1 / std::numeric_limits<double>::epsilon();
  return product * std::min(condition, kMeasured) <= kExplained;
}

Point known_values(const PartialRoot& root) {
  Point x;
  for (const KnownValue& value : root.value) x.push_back(value ? value->rounded : 0);
  return x;
}

double rounding_left(const Formulation& formulation) {
  constexpr double kOfSolution = 1e-15;
  constexpr double kOfCoefficients = 1e-14;
  return is_rounded(formulation) ? kOfCoefficients : kOfSolution;
}

std::vector<std::size_t> of_known_alone(const Formulation& formulation, const PartialRoot& root,
                                        const std::vector<std::size_t>& equations) {
  std::vector<std::size_t> found;
  for (const std::size_t e : equations) {
    const auto& terms = formulation.system.polynomials[e].terms;
    const bool is_known = std::all_of(terms.begin(), terms.end(), [&](const Term& term) {
      return std::all_of(term.monomial.begin(), term.monomial.end(),
                         [&](const Power& power) { return root.value[power.variable] != nullptr; });
    });
    if (is_known) found.push_back(e);
  }
  return found;
}

}  // namespace moivre
