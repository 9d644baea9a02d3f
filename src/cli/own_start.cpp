// SPDX-License-Identifier: MIT
// A start system of one's own: its variables brought into the target's order, its points read.
#include "own_start.h"

#include <algorithm>
#include <stdexcept>

#include "moivre/expression/joined.h"
#include "moivre/polynomial/read.h"
#include "moivre/report/point_list.h"

namespace moivre {
namespace {

/// The same polynomials, with the variables in the order of `names`.
System in_order_of(const System& g, const std::vector<std::string>& names,
                   const std::string& file) {
  std::vector<std::uint32_t> place;
  for (const std::string& name : g.variables) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end() || g.variables.size() != names.size()) {
      throw std::invalid_argument(file + ": the start system is in " + joined(g.variables, " ") +
                                  ", the problem in " + joined(names, " "));
    }
    place.push_back(static_cast<std::uint32_t>(found - names.begin()));
  }
  System ordered;
  ordered.variables = names;
  for (const Polynomial& p : g.polynomials) {
    TermMap terms;
    for (const Term& term : p.terms) {
      Monomial monomial = term.monomial;
      for (Power& power : monomial) power.variable = place[power.variable];
      std::sort(monomial.begin(), monomial.end());
      terms[monomial] = term.coefficient;
    }
    ordered.polynomials.push_back(to_polynomial(std::move(terms)));
  }
  return ordered;
}

}  // namespace

OwnStart read_own_start(const std::string& system_file, const std::string& points_file,
                        std::uint64_t number, const System& target) {
  OwnStart start;
  start.system = in_order_of(read_system(read_source(system_file)), target.variables, system_file);
  std::vector<Point> points = read_points(read_source(points_file), target.variables);
  if (number >= points.size()) {
    throw std::invalid_argument("there is no path " + std::to_string(number) + ": " + points_file +
                                " lists " + std::to_string(points.size()) +
                                (points.size() == 1 ? " start point" : " start points") +
                                ", numbered from 0 to " + std::to_string(points.size() - 1));
  }
  start.points = points.size();
  start.point = std::move(points[number]);
  return start;
}

}  // namespace moivre
