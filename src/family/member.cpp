// SPDX-License-Identifier: MIT
// The start that a family gives to one of its members.
#include "family_sentences.h"
#include "moivre/family/members.h"
#include "moivre/solver/member_start.h"
#include "start_of_member.h"

namespace moivre {
namespace {

Point rounded(const ParameterValues& p) {
  Point point;
  for (const Coefficient& pj : p) point.push_back(to_complex(pj));
  return point;
}

/// Along the line of parameters: the same scaling of both ends, so that nothing but the family lies
/// between them.
GivenStart start_by_parameters(const Family& family, const ParameterValues& p,
                               const System& member) {
  GivenStart start;
  start.scaling = scaling_to(member);
  Scaling of_all = start.scaling;
  of_all.variable_log2.resize(family.system.variables.size());
  start.plan = plan_from_roots(
      Homotopy::parameters(scale(family.system, of_all), family.generic, rounded(p)),
      scaled_roots(family.roots, start.scaling));
  start.why = start_from_generic_roots(family.roots.size());
  return start;
}

}  // namespace

GivenStart start_of_member(const Family& family, const ParameterValues& p, const System& member) {
  GivenStart start;
  if (is_linear_in_parameters(family)) {
    const System generic = member_system(family, exact_values(family.generic));
    start = start_from_member(member, generic, family.roots);
  } else {
    start = start_by_parameters(family, p, member);
  }
  start.bound = family.learning.bound;
  start.is_complete = family.learning.complete;
  start.leaves_out = family.nonzero;
  return start;
}

SolveResult solve_member(const Family& family, const ParameterValues& p, const Tracker& tracker,
                         const SolveOptions& options, const std::atomic<bool>& stop) {
  require_unbroken(broken_rules(family));
  const System member = member_system(family, p);
  return solve_from(member, start_of_member(family, p, member), tracker, options, stop);
}

}  // namespace moivre
