// SPDX-License-Identifier: MIT
// Patches of homogeneous groups: one linear equation each, and points scaled so that they do not
// depend on it.
#include "moivre/polynomial/patches.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "moivre/numeric/invalid_input.h"
#include "random_share.h"

namespace moivre {
namespace {

Polynomial patch(const VariableGroup& group, std::uint64_t seed) {
  TermMap terms;
  for (const std::uint32_t v : group.variables) {
    terms[{{v, 1}}] = {random_share(seed, RandomStream::patch, v, kPatchBits), 0};
  }
  terms[{}] = {-1, 0};
  return to_polynomial(std::move(terms));
}

void check_homogeneous(const System& f, const VariableGroup& group) {
  for (std::size_t i = 0; i < f.polynomials.size(); ++i) {
    if (is_homogeneous(f.polynomials[i], group.variables)) continue;
    throw InvalidInput("equation " + std::to_string(i + 1) +
                       " is not homogeneous in the group of " +
                       f.variables[group.variables.front()]);
  }
}

}  // namespace

std::set<std::uint64_t> degrees_in(const Polynomial& p,
                                   const std::vector<std::uint32_t>& variables) {
  std::set<std::uint64_t> degrees;
  for (const Term& term : p.terms) {
    std::uint64_t sum = 0;
    for (const Power& power : term.monomial) {
      if (std::binary_search(variables.begin(), variables.end(), power.variable)) {
        sum += power.exponent;
      }
    }
    degrees.insert(sum);
  }
  return degrees;
}

bool is_homogeneous(const Polynomial& p, const std::vector<std::uint32_t>& variables) {
  return degrees_in(p, variables).size() <= 1;
}

bool has_homogeneous_groups(const System& f) {
  return std::any_of(f.groups.begin(), f.groups.end(),
                     [](const VariableGroup& group) { return group.is_homogeneous; });
}

bool is_square(const System& f) {
  return f.polynomials.size() == f.variables.size() && !has_homogeneous_groups(f);
}

System with_patches(const System& f, std::uint64_t seed) {
  System g = f;
  for (VariableGroup& group : g.groups) {
    if (!group.is_homogeneous || group.variables.empty()) continue;
    check_homogeneous(f, group);
    g.polynomials.push_back(patch(group, seed));
    group.is_homogeneous = false;
  }
  return g;
}

Point normalized(const std::vector<VariableGroup>& groups, Point x) {
  for (const VariableGroup& group : groups) {
    if (!group.is_homogeneous) continue;
    double largest = 0;
    for (const std::uint32_t v : group.variables) largest = std::max(largest, std::abs(x[v]));
    if (!(largest > 0) || !std::isfinite(largest)) continue;
    const auto first =
        std::find_if(group.variables.begin(), group.variables.end(),
                     [&](std::uint32_t v) { return std::abs(x[v]) >= kNearLargest * largest; });
    const std::uint32_t one = *first;
    const Complex scale = x[one];
    for (const std::uint32_t v : group.variables) x[v] = v == one ? Complex(1) : x[v] / scale;
  }
  return x;
}

}  // namespace moivre
