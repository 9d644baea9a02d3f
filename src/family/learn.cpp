// SPDX-License-Identifier: MIT
// A generic member, its solve, and what of it is kept.
#include "moivre/family/learn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "family_sentences.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/patches.h"

namespace moivre {
namespace {

// Of the parts of a generic parameter: exact algebra on a generic member costs as its numbers have
// digits, and 2^40 points are enough (decision 104).
constexpr int kBitsOfMember = 20;

double rounded(double value, double quantum) { return std::round(value / quantum) * quantum; }

std::vector<std::string> broken_rules(const System& system,
                                      const std::vector<NamedParameter>& parameters) {
  std::vector<std::string> broken;
  std::map<std::string, int> seen;
  for (const NamedParameter& parameter : parameters) {
    const auto& names = system.variables;
    const bool is_known = std::find(names.begin(), names.end(), parameter.name) != names.end();
    if (!is_known) {
      broken.push_back("the system has no name " + parameter.name + "; its names are " +
                       joined(names, ", "));
    }
    if (++seen[parameter.name] == 2) {
      broken.push_back("the parameter " + parameter.name + " is named twice");
    }
    if (!(parameter.size > 0) || !std::isfinite(parameter.size)) {
      broken.push_back("the size of the parameter " + parameter.name + " must be positive");
    }
  }
  if (parameters.empty()) broken.push_back("a family has at least one parameter");
  if (!broken.empty()) return broken;
  const std::size_t unknowns = system.variables.size() - parameters.size();
  if (unknowns != system.polynomials.size()) {
    broken.push_back("a family has as many equations as unknowns: without the " +
                     counted(parameters.size(), "parameter") + " there are " +
                     counted(unknowns, "unknown") + " and " +
                     counted(system.polynomials.size(), "equation"));
  }
  return broken;
}

/// The place of each variable in the family.
std::vector<std::uint32_t> places(const System& system,
                                  const std::vector<NamedParameter>& parameters) {
  std::vector<std::uint32_t> place;
  std::uint32_t next = 0;
  const auto unknowns = static_cast<std::uint32_t>(system.polynomials.size());
  for (const std::string& name : system.variables) {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const NamedParameter& p) { return p.name == name; });
    place.push_back(found == parameters.end()
                        ? next++
                        : unknowns + static_cast<std::uint32_t>(found - parameters.begin()));
  }
  return place;
}

Polynomial renumbered(const Polynomial& p, const std::vector<std::uint32_t>& place) {
  TermMap terms;
  for (const Term& term : p.terms) {
    Monomial monomial = term.monomial;
    for (Power& power : monomial) power.variable = place[power.variable];
    std::sort(monomial.begin(), monomial.end());
    terms[monomial] = term.coefficient;
  }
  return to_polynomial(std::move(terms));
}

std::string standing_of(const SolveResult& result, const Learning& learning) {
  using enum SolvedStanding;
  if (!result.complete) return standing_of_solved(undecided);
  if (learning.dropped > 0) return standing_of_solved(has_irregular_roots);
  if (result.bound) return standing_by_bound(result.bound->kind);
  if (result.completeness == RootCompleteness::shown) return standing_of_solved(shown);
  return standing_of_solved(result.completeness ? not_all_certified : decided);
}

bool has_zero(const Point& x) {
  return std::any_of(x.begin(), x.end(), [](const Complex& xj) { return xj == 0.0; });
}

Learning learning_of(const SolveResult& result, bool nonzero) {
  Learning learning;
  learning.start = to_string(result.start.source);
  learning.paths = result.paths.tracked;
  learning.dropped = result.paths.on_positive_dimensional;
  for (const Solution& root : result.solutions) {
    if (root.singular && !(nonzero && has_zero(root.x))) ++learning.dropped;
    if (root.certified == true) ++learning.certified;
  }
  const bool is_open = result.completeness == RootCompleteness::open;
  learning.complete = result.complete && learning.dropped == 0 && !is_open;
  if (learning.complete) learning.bound = result.bound;
  learning.standing = standing_of(result, learning);
  return learning;
}

void keep_roots(const SolveResult& result, Family& family) {
  family.learning = learning_of(result, family.nonzero);
  family.roots.clear();
  for (const Solution& root : result.solutions) {
    if (!root.singular && !(family.nonzero && has_zero(root.x))) family.roots.push_back(root.x);
  }
  // The bound counts those with zeros too.
  if (family.learning.bound && family.learning.bound->value != family.roots.size()) {
    family.learning.bound.reset();
  }
}

/// A denominator of parameters alone is no zero of a member that has a meaning.
void require_whole(const System& system, const std::vector<NamedParameter>& parameters) {
  const auto is_unknown = [&](const Power& power) {
    const std::string& name = system.variables[power.variable];
    return std::none_of(parameters.begin(), parameters.end(),
                        [&](const NamedParameter& p) { return p.name == name; });
  };
  for (const Polynomial& d : system.denominators) {
    for (const Term& term : d.terms) {
      if (std::none_of(term.monomial.begin(), term.monomial.end(), is_unknown)) continue;
      throw InvalidInput(
          "a family's equations must not divide by unknowns: roots on the denominators would be "
          "told as roots; solve a member by itself");
    }
  }
}

}  // namespace

Family unlearned_family(const System& system, const std::vector<NamedParameter>& parameters) {
  require_unbroken(moivre::broken_rules(system));
  require_unbroken(broken_rules(system, parameters));
  if (has_homogeneous_groups(system)) {
    throw InvalidInput("a family has no homogeneous groups of unknowns");
  }
  if (!system.conditions.empty()) {
    throw InvalidInput("a family has no conditions, such as '" + system.conditions.front().text +
                       "': which roots are wanted is asked of a member");
  }
  require_whole(system, parameters);
  const std::vector<std::uint32_t> place = places(system, parameters);
  Family family;
  family.system.variables.resize(system.variables.size());
  for (std::size_t v = 0; v < place.size(); ++v) {
    family.system.variables[place[v]] = system.variables[v];
  }
  for (const Polynomial& p : system.polynomials) {
    family.system.polynomials.push_back(renumbered(p, place));
  }
  family.system.scaled_log2 = system.scaled_log2;
  for (const NamedParameter& parameter : parameters) family.sizes.push_back(parameter.size);
  return family;
}

Point generic_member(const Family& family, std::uint64_t seed) {
  Point p;
  for (std::size_t j = 0; j < family.parameters(); ++j) {
    const double radius = 0.5 + random_unit(seed, RandomStream::family, 2 * j);
    const double quantum = std::max(std::ldexp(1, std::ilogb(family.sizes[j]) - kBitsOfMember),
                                    std::numeric_limits<double>::denorm_min());
    const Complex pj =
        family.sizes[j] * radius * random_phase(seed, RandomStream::family, 2 * j + 1);
    p.emplace_back(rounded(pj.real(), quantum), rounded(pj.imag(), quantum));
  }
  return p;
}

Family learn(Family unlearned, const Tracker& tracker, const SolveOptions& options,
             const std::atomic<bool>& stop) {
  require_unbroken(broken_rules_of_unlearned(unlearned));
  Family family = std::move(unlearned);
  family.seed = options.seed;
  family.generic = generic_member(family, options.seed);
  const System member = member_system(family, exact_values(family.generic));
  const SolveResult result = solve(member, tracker, options, stop);
  keep_roots(result, family);
  return family;
}

}  // namespace moivre
