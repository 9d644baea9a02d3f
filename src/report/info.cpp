// SPDX-License-Identifier: MIT
// Structure of a system: degrees, terms, what elimination and scaling would do, paths of each start
// system.
#include "moivre/report/info.h"

#include <algorithm>

#include "moivre/polynomial/eliminate.h"
#include "moivre/polynomial/scale.h"
#include "moivre/start/choose_start.h"

namespace moivre {
namespace {

SystemFacts facts(const System& f) { return {f.variables, degrees(f), total_degree(degrees(f))}; }

StartCost total_degree_cost(Reduction::Verdict verdict, const SystemFacts& reduced) {
  StartCost cost{StartSource::total_degree, std::nullopt, ""};
  switch (verdict) {
    case Reduction::Verdict::square:
      cost.paths = reduced.total_degree;
      cost.why = reduced.total_degree ? "the product of the degrees of what is tracked"
                                      : "the product of the degrees is beyond 64 bits";
      break;
    case Reduction::Verdict::solved:
      cost.paths = 1;
      cost.why = "elimination alone gives the one root";
      break;
    case Reduction::Verdict::inconsistent:
      cost.paths = 0;
      cost.why = "the equations contradict each other";
      break;
    case Reduction::Verdict::dependent:
      cost.paths = 0;
      cost.why = "the equations depend on each other: no root is isolated";
      break;
    case Reduction::Verdict::underdetermined:
      cost.why = "fewer equations than unknowns: roots are not isolated";
      break;
    case Reduction::Verdict::overdetermined:
      cost.why = "more equations than unknowns: solve squares them up by random combinations";
      break;
  }
  return cost;
}

Scaling identity_of(const System& f) {
  return {std::vector<int>(f.variables.size()), std::vector<int>(f.polynomials.size())};
}

void add_cost(StartSource source, const StartCount& count, const std::string& why,
              SystemInfo& info) {
  info.start_systems.push_back({source, count.paths, count.paths ? why : count.missing});
}

}  // namespace

SystemInfo inspect(const System& f, const InspectOptions& options) {
  const auto is_over = [&] { return options.stop != nullptr && *options.stop; };
  SystemInfo info;
  info.system = facts(f);
  info.equations = f.polynomials.size();
  info.terms = term_count(f);
  info.real = is_real(f);
  info.homogeneous = std::all_of(f.polynomials.begin(), f.polynomials.end(),
                                 [](const Polynomial& p) { return is_homogeneous(p); });
  for (const Condition& condition : f.conditions) info.conditions.push_back(condition.text);
  const Reduction reduction = eliminate(f, options.stop);
  info.verdict = to_string(reduction.verdict);
  info.reduced = facts(reduction.system);
  info.reduced_terms = term_count(reduction.system);
  const Scaling scaling =
      is_over() ? identity_of(reduction.system) : choose_scaling(reduction.system);
  info.variable_log2 = scaling.variable_log2;
  info.equation_log2 = scaling.equation_log2;
  info.start_systems.push_back(total_degree_cost(reduction.verdict, info.reduced));
  for (StartCount* count :
       {&info.counts.total_degree, &info.counts.multihomogeneous, &info.counts.mixed_volume}) {
    count->missing = is_over() ? "interrupted" : "there are no paths to count: " + info.verdict;
  }
  if (reduction.verdict == Reduction::Verdict::square && !is_over()) {
    StartChoiceOptions counting;
    counting.stop = options.stop;
    counting.progress = options.progress;
    info.counts = count_starts(scale(reduction.system, scaling), counting);
    add_cost(StartSource::multihomogeneous, info.counts.multihomogeneous,
             "the least of the partitions of the unknowns that were tried", info);
    add_cost(StartSource::polyhedral, info.counts.mixed_volume,
             "the mixed volume of the monomials, a constant added to each equation", info);
  }
  for (const Omission& omission : reduction.left_out) {
    info.left_out.push_back({omission.what, omission.why});
  }
  return info;
}

}  // namespace moivre
