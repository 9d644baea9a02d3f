// SPDX-License-Identifier: MIT
// Both members in the units that suit the one that is sought.
#include "moivre/solver/member_start.h"

#include <cmath>

#include "prepare.h"
#include "solver_sentences.h"

namespace moivre {

Scaling scaling_to(const System& member) {
  Scaling scaling = choose_scaling(member);
  const Scaling rows = unit_rows(scale(member, scaling));
  for (std::size_t i = 0; i < rows.equation_log2.size(); ++i) {
    scaling.equation_log2[i] += rows.equation_log2[i];
  }
  return scaling;
}

std::vector<Point> scaled_roots(const std::vector<Point>& roots, const Scaling& scaling) {
  std::vector<Point> points;
  for (const Point& root : roots) {
    Point& z = points.emplace_back();
    for (std::size_t j = 0; j < root.size(); ++j) {
      z.push_back(std::ldexp(1.0, -scaling.variable_log2[j]) * root[j]);
    }
    z.push_back(1);
  }
  return points;
}

GivenStart start_from_member(const System& f, const System& g,
                             const std::vector<Point>& roots_of_g) {
  GivenStart start;
  start.scaling = scaling_to(f);
  start.plan = plan_from_roots(Homotopy(scale(f, start.scaling), scale(g, start.scaling)),
                               scaled_roots(roots_of_g, start.scaling));
  start.why = start_from_roots_of_member(roots_of_g.size());
  return start;
}

}  // namespace moivre
