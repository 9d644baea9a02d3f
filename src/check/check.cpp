// SPDX-License-Identifier: MIT
// The judgement from beginning to end: system, roots one by one, roots together, sums, bounds.
#include "moivre/check/check.h"

#include <algorithm>
#include <stdexcept>

#include "bench.h"
#include "moivre/expression/joined.h"

namespace moivre {
namespace {

std::string bounds_text(const std::vector<RootBound>& bounds) {
  std::vector<std::string> words;
  for (const RootBound& bound : bounds) {
    words.push_back(to_string(bound.kind) + " " +
                    (bound.value ? std::to_string(*bound.value) : "not known"));
  }
  return joined(words, ", ");
}

/// Bounds on the stand-in's roots, and whether the distinct ones, and those that exact algebra counts, meet one.
void find_bounds(const StandIn& stand_in, Judgement& judgement) {
  const std::size_t distinct = judgement.roots.distinct;
  const std::uint64_t known = distinct + judgement.roots.counted;
  judgement.bounds = root_bounds(stand_in.system, known);
  for (const RootBound& bound : judgement.bounds) {
    if (!bound.value) continue;
    if (*bound.value < distinct) {
      throw std::logic_error(std::to_string(distinct) + " distinct roots are certified, and " +
                             to_string(bound.kind) + " bounds them by " +
                             std::to_string(*bound.value));
    }
    if (*bound.value == known) judgement.proved_by = bound.kind;
  }
}

/// Multiplicities bounded by what is proved beforehand.
void judge_sum(const Claims& claims, Verdicts& verdicts) {
  std::uint64_t sum = 0;
  for (const RootClaim& root : claims.roots) {
    if (root.multiplicity > UINT64_MAX - sum)
      sum = UINT64_MAX;
    else
      sum += root.multiplicity;
  }
  for (const RootBound& bound : verdicts.judgement().bounds) {
    if (!bound.value) continue;
    verdicts.judge(ClaimKind::multiplicity, sum <= *bound.value,
                   "the multiplicities add up to " + std::to_string(sum) +
                       ", and there are at most " + std::to_string(*bound.value) + " roots (" +
                       to_string(bound.kind) + ")");
  }
}

void judge_completeness(const Claims& claims, const StandIn& stand_in, Verdicts& verdicts) {
  if (!claims.completeness || *claims.completeness == "open") return;
  if (*claims.completeness == "shown") {
    return verdicts.leave_open(ClaimKind::completeness,
                               "\"shown\" rests on paths, which are not followed here");
  }
  const Judgement& judgement = verdicts.judgement();
  if (judgement.proved_by) return verdicts.hold(ClaimKind::completeness);
  if (!stand_in.has_all_roots) {
    return verdicts.refute(ClaimKind::completeness,
                           "\"proved\", and there is no bound on roots of this file: its equations "
                           "are not as many as its unknowns, or homogeneous");
  }
  const std::string why = "\"proved\", and " + std::to_string(judgement.roots.distinct) +
                          " distinct roots are certified: " + bounds_text(judgement.bounds);
  const bool all_known = std::all_of(judgement.bounds.begin(), judgement.bounds.end(),
                                     [](const RootBound& bound) { return bound.value; });
  if (!all_known) return verdicts.leave_open(ClaimKind::completeness, why);
  verdicts.refute(ClaimKind::completeness, why);
}

}  // namespace

Judgement check(const System& f, const Claims& claims) {
  Judgement judgement;
  judgement.form = claims.form;
  judgement.roots.listed = claims.roots.size();
  Verdicts verdicts(judgement);
  judge_paths(claims, verdicts);
  judgement.is_judged_whole = judge_system(f, claims, verdicts);
  if (!judgement.is_judged_whole || f.variables.empty()) return judgement;

  const StandIn stand_in = make_stand_in(f, claims.seed);
  judgement.stand_in = stand_in.name;
  judge_start(f, stand_in, claims, verdicts);
  Certifier certifier(make_certify_program(stand_in.system));
  Bench bench{f, claims, stand_in, certifier, {}, verdicts};
  judge_existence(bench);
  judge_clusters(bench);
  judge_figures(bench);
  judge_relations(bench);
  judge_digits(bench);
  if (stand_in.has_all_roots) {
    find_bounds(stand_in, judgement);
    if (!bench.is_list()) judge_sum(claims, verdicts);
  }
  judge_completeness(claims, stand_in, verdicts);
  return judgement;
}

}  // namespace moivre
