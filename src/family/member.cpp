// SPDX-License-Identifier: MIT
// The start that a family gives to one of its members.
#include "moivre/family/member.h"

#include <algorithm>
#include <cmath>

namespace moivre {
namespace {

Point rounded(const ParameterValues& p) {
  Point point;
  for (const Coefficient& pj : p) point.push_back(to_complex(pj));
  return point;
}

/// choose_scaling(), and rows with their largest coefficient in [1, 2): a homotopy's equations are to be near 1.
Scaling scaling_of(const System& member) {
  Scaling scaling = choose_scaling(member);
  const System scaled = scale(member, scaling);
  for (std::size_t i = 0; i < scaled.polynomials.size(); ++i) {
    double largest = -std::numeric_limits<double>::infinity();
    for (const Term& term : scaled.polynomials[i].terms) {
      largest = std::max(largest, log2_size(term.coefficient));
    }
    if (std::isfinite(largest)) {
      scaling.equation_log2[i] -= static_cast<int>(std::floor(largest));
    }
  }
  return scaling;
}

/// The same scaling of both ends: between them lies nothing but the family. Where parameters are linear that is a straight
/// line of coefficients, which are then known beyond double.
Homotopy homotopy_to(const Family& family, const System& member, const ParameterValues& p,
                     const Scaling& scaling) {
  if (is_linear_in_parameters(family)) {
    const System generic = member_system(family, exact_values(family.generic));
    return Homotopy(scale(member, scaling), scale(generic, scaling));
  }
  Scaling of_all = scaling;
  of_all.variable_log2.resize(family.system.variables.size());
  return Homotopy::parameters(scale(family.system, of_all), family.generic, rounded(p));
}

std::vector<Point> starts(const Family& family, const Scaling& scaling) {
  std::vector<Point> points;
  for (const Point& root : family.roots) {
    Point& z = points.emplace_back();
    for (std::size_t j = 0; j < root.size(); ++j) {
      z.push_back(std::ldexp(1.0, -scaling.variable_log2[j]) * root[j]);
    }
    z.push_back(1);
  }
  return points;
}

}  // namespace

GivenStart start_of_member(const Family& family, const ParameterValues& p, const System& member) {
  GivenStart start;
  start.scaling = scaling_of(member);
  start.plan = plan_from_roots("family", homotopy_to(family, member, p, start.scaling),
                               starts(family, start.scaling));
  start.why = "the " + std::to_string(family.roots.size()) + " roots of a generic member";
  start.bound = family.learning.bound;
  start.is_complete = family.learning.complete;
  return start;
}

SolveResult solve_member(const Family& family, const ParameterValues& p, const Tracker& tracker,
                         const SolveOptions& options, const std::atomic<bool>& stop) {
  const System member = member_system(family, p);
  return solve_from(member, start_of_member(family, p, member), tracker, options, stop);
}

}  // namespace moivre
