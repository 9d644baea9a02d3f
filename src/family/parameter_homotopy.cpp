// SPDX-License-Identifier: MIT
// A family whose roots the caller knows: moved to a generic member, and from there to the wanted
// one.
#include "moivre/family/parameter_homotopy.h"

#include <algorithm>
#include <cmath>

#include "family_sentences.h"
#include "loops.h"
#include "moivre/expression/counted.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/threads.h"
#include "root_set.h"

namespace moivre {
namespace {

Point as_doubles(const ParameterValues& p) {
  Point point;
  for (const Coefficient& pj : p) point.push_back(to_complex(pj));
  return point;
}

/// Near p0 and p1, so that what is between them is like them.
std::vector<NamedParameter> sized(const ParameterProblem& problem, const Point& from,
                                  const Point& to) {
  std::vector<NamedParameter> parameters;
  for (std::size_t j = 0; j < problem.parameters.size(); ++j) {
    const double size = std::max(std::abs(from[j]), std::abs(to[j]));
    parameters.push_back({problem.parameters[j], size > 0 ? size : 1});
  }
  return parameters;
}

void require_fitting(const ParameterProblem& problem, const ParameterValues& to) {
  std::vector<std::string> broken = broken_rules(problem.system);
  const std::size_t k = problem.parameters.size();
  for (const auto& [values, name] : {std::pair(&problem.from, "p0"), std::pair(&to, "p1")}) {
    if (values->size() == k) continue;
    broken.push_back(std::string(name) + " has " + counted(values->size(), "number") +
                     ", there are " + counted(k, "parameter"));
  }
  const std::size_t all = problem.system.variables.size();
  const std::size_t unknowns = all - std::min(all, k);
  for (std::size_t r = 0; r < problem.roots.size(); ++r) {
    const Point& x = problem.roots[r];
    const std::string name = "start point " + std::to_string(r);
    if (x.size() != unknowns) {
      broken.push_back(name + " has " + counted(x.size(), "number") + ", there are " +
                       counted(unknowns, "unknown"));
    } else if (!std::isfinite(max_norm(x))) {
      broken.push_back(name + " has a number that is not finite");
    }
  }
  require_unbroken(broken);
}

/// With p0 as its generic member.
Family family_at_start(const ParameterProblem& problem, const ParameterValues& to) {
  require_fitting(problem, to);
  const Point from = as_doubles(problem.from);
  Family family = unlearned_family(problem.system, sized(problem, from, as_doubles(to)));
  family.generic = from;
  family.roots = problem.roots;
  return family;
}

/// Each once: start points may be one root.
std::vector<Point> different(const std::vector<std::optional<Point>>& ends) {
  RootSet set;
  for (const std::optional<Point>& end : ends) {
    if (end) set.add(*end);
  }
  return set.roots();
}

}  // namespace

SolveResult solve(const ParameterProblem& problem, const ParameterValues& to,
                  const Tracker& tracker, const SolveOptions& options,
                  const std::atomic<bool>& stop) {
  require_unbroken(validate(options));
  Family family = family_at_start(problem, to);
  family.seed = options.seed;
  const Point generic = generic_member(family, options.seed);
  const Follower follower{tracker, stop, thread_count(options.threads), options.observations};
  const auto ends = follow_roots(family.system, family.generic, generic, family.roots, follower);
  family.generic = generic;
  family.roots = different(ends);
  SolveResult result = solve_member(family, to, tracker, options, stop);
  result.start.why = start_from_given_roots(problem.roots.size());
  const auto lost = static_cast<std::size_t>(std::count(ends.begin(), ends.end(), std::nullopt));
  if (lost > 0) {
    result.complete = false;
    result.left_out.push_back(lost_start_points_left_out(lost));
  }
  return result;
}

std::vector<std::optional<Point>> track(const ParameterProblem& problem, const ParameterValues& to,
                                        const Tracker& tracker, int threads,
                                        const std::atomic<bool>& stop) {
  const Family family = family_at_start(problem, to);
  return follow_roots(family.system, family.generic, as_doubles(to), family.roots,
                      {tracker, stop, thread_count(threads), nullptr});
}

}  // namespace moivre
