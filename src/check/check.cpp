// SPDX-License-Identifier: MIT
// The judgement from beginning to end: system, roots one by one, roots together, sums, bounds.
#include "moivre/check/check.h"

#include <algorithm>
#include <stdexcept>

#include "bench.h"
#include "moivre/algebra/quotient_ring.h"
#include "moivre/certify/isolate.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/polynomial/digits.h"

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

/// Bounds on the stand-in's roots, and whether the distinct ones, and those that exact algebra
/// counts, meet one.
void find_bounds(const StandIn& stand_in, Judgement& judgement, const std::atomic<bool>& stop) {
  const std::size_t distinct = judgement.roots.distinct;
  const KnownRoots known{distinct + judgement.roots.counted,
                         distinct + judgement.roots.counted_points};
  judgement.bounds = root_bounds(stand_in.system, known, &stop);
  for (const RootBound& bound : judgement.bounds) {
    if (!bound.value) continue;
    if (*bound.value < distinct) {
      throw std::logic_error(std::to_string(distinct) + " distinct roots are certified, and " +
                             to_string(bound.kind) + " bounds them by " +
                             std::to_string(*bound.value));
    }
    if (*bound.value == known.count(bound.kind)) judgement.proved_by = bound.kind;
  }
}

std::uint64_t sum_of_multiplicities(const Claims& claims) {
  std::uint64_t sum = 0;
  for (const RootClaim& root : claims.roots) {
    if (root.multiplicity > UINT64_MAX - sum)
      sum = UINT64_MAX;
    else
      sum += root.multiplicity;
  }
  return sum;
}

/// Multiplicities bounded by what is known beforehand.
void judge_sum(const Claims& claims, Verdicts& verdicts) {
  const std::uint64_t sum = sum_of_multiplicities(claims);
  for (const RootBound& bound : verdicts.judgement().bounds) {
    if (!bound.value || bound.kind == BoundKind::strata) continue;
    verdicts.judge(ClaimKind::multiplicity, sum <= *bound.value,
                   "the multiplicities add up to " + std::to_string(sum) +
                       ", and there are at most " + counted(*bound.value, "root") + " (" +
                       to_string(bound.kind) + ")");
  }
}

/// Every path decided: no root is left out. The dimension of the quotient ring is not a bound
/// alone, but their number.
void judge_all_there(const System& f, const Claims& claims, Verdicts& verdicts) {
  const auto& bounds = verdicts.judgement().bounds;
  const auto ring = std::find_if(bounds.begin(), bounds.end(), [](const RootBound& bound) {
    return bound.kind == BoundKind::quotient_ring && bound.value;
  });
  const std::uint64_t sum = sum_of_multiplicities(claims);
  const std::uint64_t missing =
      ring == bounds.end() || sum >= *ring->value ? 0 : *ring->value - sum;
  if (!claims.complete || missing <= claims.left_out) return;
  const std::string untold =
      claims.left_out > 0 ? ", and " + std::to_string(claims.left_out) + " are not told" : "";
  const std::string why = "exact algebra counts " + counted(*ring->value, "root") +
                          " with their multiplicities, these add up to " + std::to_string(sum) +
                          untold;
  if (coefficient_errors(f).empty()) return verdicts.refute(ClaimKind::complete, why);
  verdicts.leave_open(ClaimKind::complete,
                      why + "; the digits of the file may not tell the others from infinity");
}

// The prime of the algebra is another one than the solver's.
constexpr std::uint64_t kSeed = 101;

std::optional<std::uint64_t> different_roots(const System& f, const std::atomic<bool>& stop) {
  if (f.variables.size() != 1) {
    return quotient_ring(f, {.stop = &stop, .counts_points = true, .seed = kSeed}).points;
  }
  if (f.polynomials.size() != 1) return std::nullopt;
  for (int bits = 2 * kFirstArbBits; bits <= kMostArbBits; bits *= 2) {
    if (const auto roots = isolated_roots(f.polynomials.front(), bits))
      return roots->roots.size() + roots->other_simple;
  }
  return std::nullopt;
}

/// The list has every different root where it has as many as exact algebra counts. A cluster may be
/// several.
void judge_points(const System& f, const Claims& claims, Verdicts& verdicts,
                  const std::atomic<bool>& stop) {
  if (claims.left_out > 0) return;
  const bool has_isolated = f.polynomials.size() >= f.variables.size() && f.groups.empty();
  if (!has_isolated || !claims.complete || !coefficient_errors(f).empty()) return;
  const auto points = different_roots(f, stop);
  if (!points) return;
  std::uint64_t most = 0;
  for (const RootClaim& root : claims.roots) most += root.cluster ? root.multiplicity : 1;
  verdicts.judge(ClaimKind::complete, claims.roots.size() <= *points && *points <= most,
                 "exact algebra counts " + counted(*points, "different root") + ", these are " +
                     std::to_string(claims.roots.size()));
}

/// Of more equations than unknowns, where roots lie on curves: exact algebra counts the roots of
/// the file that are simple ones of the combinations.
void judge_common_roots(const System& f, const StandIn& stand_in, const Claims& claims,
                        Verdicts& verdicts) {
  const bool is_overdetermined = f.polynomials.size() > f.variables.size() && f.groups.empty();
  if (!is_overdetermined || !coefficient_errors(f).empty()) return;
  const auto ring =
      quotient_ring(f, {.seed = kSeed, .counts_simple = true, .square = &stand_in.system});
  if (ring.verdict != QuotientRing::Verdict::infinite || !ring.simple) return;
  const auto claimed = static_cast<std::uint64_t>(
      std::count_if(claims.roots.begin(), claims.roots.end(),
                    [](const RootClaim& root) { return root.singular == false; }));
  if (claimed <= *ring.simple) return;
  verdicts.refute(ClaimKind::root, "exact algebra counts " + counted(*ring.simple, "root") +
                                       " of the file's equations beside curves that are not "
                                       "singular, " +
                                       std::to_string(claimed) + " are claimed");
}

/// Beside curves exact algebra counts the simple roots alone.
void judge_simple_roots(const StandIn& stand_in, const Claims& claims, Verdicts& verdicts,
                        const std::atomic<bool>& stop) {
  const Judgement& judgement = verdicts.judgement();
  if (claims.left_out > 0 || !claims.complete || judgement.proved_by ||
      !coefficient_errors(stand_in.system).empty()) {
    return;
  }
  const auto simple = quotient_ring(stand_in.system, {.stop = &stop, .seed = kSeed}).simple;
  if (!simple) return;
  if (judgement.roots.distinct >= *simple) return verdicts.hold(ClaimKind::complete);
  const std::string why = "exact algebra counts " + counted(*simple, "simple root") +
                          " beside curves, " + std::to_string(judgement.roots.distinct) +
                          " are certified";
  if (claims.roots.size() < *simple) return verdicts.refute(ClaimKind::complete, why);
  verdicts.leave_open(ClaimKind::complete, why);
}

/// Of a proof every root that is not singular has its part.
std::optional<std::size_t> first_without_proof(const Claims& claims) {
  for (std::size_t k = 0; k < claims.roots.size(); ++k) {
    const RootClaim& root = claims.roots[k];
    if (root.singular == false && root.certified != true) return k;
  }
  return std::nullopt;
}

/// Whether a bound is met if what is said to be certified is.
bool would_meet_bound(const Judgement& judgement) {
  const RootTally& roots = judgement.roots;
  const KnownRoots said{roots.distinct + roots.counted + roots.unproved,
                        roots.distinct + roots.counted_points + roots.unproved};
  return std::any_of(judgement.bounds.begin(), judgement.bounds.end(), [&](const RootBound& bound) {
    return !bound.value || *bound.value == said.count(bound.kind);
  });
}

void judge_completeness(const Claims& claims, const StandIn& stand_in, Verdicts& verdicts) {
  if (!claims.completeness || *claims.completeness == "open") return;
  const Judgement& judgement = verdicts.judgement();
  const bool is_proved = *claims.completeness == "proved";
  if (const auto k = first_without_proof(claims); is_proved && k) {
    return verdicts.refute(ClaimKind::completeness,
                           "\"proved\", and " + root_name(*k + 1) + " is not said to be certified");
  }
  if (judgement.proved_by) return verdicts.hold(ClaimKind::completeness);
  if (*claims.completeness == "shown") {
    return verdicts.leave_open(ClaimKind::completeness,
                               "\"shown\" rests on paths, which are not followed here");
  }
  if (claims.left_out > 0) {
    return verdicts.leave_proof_open(
        ClaimKind::completeness, "\"proved\" of all roots, and " + std::to_string(claims.left_out) +
                                     " are not listed: left out by a filter, a condition or a "
                                     "denominator that is zero");
  }
  if (!stand_in.has_all_roots) {
    return verdicts.refute(ClaimKind::completeness,
                           "\"proved\", and there is no bound on roots of this file: its equations "
                           "are not as many as its unknowns, or homogeneous");
  }
  if (!claims.bound) {
    return verdicts.refute(ClaimKind::completeness, "\"proved\", and no bound is named");
  }
  const std::string why = "\"proved\", and " + std::to_string(judgement.roots.distinct) +
                          " distinct roots are certified: " + bounds_text(judgement.bounds);
  // A root of which nothing is proved here may be the one that is missing.
  const bool are_settled = std::none_of(
      judgement.claims.begin(), judgement.claims.end(),
      [](const ClaimTally& tally) { return tally.claim == ClaimKind::root && tally.open > 0; });
  if (would_meet_bound(judgement) || !are_settled) {
    return verdicts.leave_proof_open(ClaimKind::completeness, why);
  }
  verdicts.refute(ClaimKind::completeness, why);
}

/// Points are as many, whatever their multiplicity.
bool counts_points(const BoundClaim& bound) { return bound_named(bound.kind) == BoundKind::strata; }

/// What is claimed of the stand-in, whose paths and multiplicities are so many times fewer.
Claims divided(const Claims& claims, std::uint64_t sheets, Verdicts& verdicts) {
  Claims result = claims;
  if (sheets == 1) return result;
  const auto divide = [&](ClaimKind claim, std::uint64_t& count,
                          std::optional<std::size_t> root = std::nullopt) {
    verdicts.judge(claim, count % sheets == 0,
                   std::to_string(count) + " is no multiple of " + std::to_string(sheets) +
                       ", the product of the equations' exponents",
                   root);
    count /= sheets;
  };
  for (std::size_t k = 0; k < result.roots.size(); ++k) {
    RootClaim& root = result.roots[k];
    divide(ClaimKind::multiplicity, root.multiplicity, k + 1);
    if (root.singular) {
      verdicts.judge(ClaimKind::multiplicity, *root.singular,
                     "equations that are powers have singular roots only", k + 1);
      root.singular = root.multiplicity > 1;
    }
  }
  if (result.bound && !counts_points(*result.bound)) divide(ClaimKind::bound, result.bound->value);
  if (result.paths) divide(ClaimKind::paths, result.paths->tracked);
  if (result.left_out > 0) divide(ClaimKind::paths, result.left_out);
  if (!result.start) return result;
  divide(ClaimKind::start, result.start->paths);
  for (auto* count : {&result.start->total_degree, &result.start->multihomogeneous,
                      &result.start->mixed_volume}) {
    if (*count) divide(ClaimKind::start, **count);
  }
  return result;
}

/// All but the books of the paths.
void judge_roots(const System& f, const Claims& given, Verdicts& verdicts,
                 const std::atomic<bool>& stop) {
  Judgement& judgement = verdicts.judgement();
  // A list has each root as often as its author's paths came to it.
  const StandIn stand_in = make_stand_in(f, given.seed, given.form == ClaimForm::solve_json);
  const Claims claims = divided(given, stand_in.sheets, verdicts);
  judgement.stand_in = stand_in.name;
  judge_start(f, stand_in, claims, verdicts, stop);
  Certifier certifier(make_certify_program(stand_in.system));
  Bench bench{f, claims, stand_in, certifier, {}, verdicts, stop};
  judge_existence(bench);
  judge_clusters(bench);
  judge_figures(bench);
  judge_relations(bench);
  judge_digits(bench);
  judge_conditions(bench);
  if (stand_in.has_all_roots) {
    find_bounds(stand_in, judgement, stop);
    bench.require_time();
    if (!bench.is_list()) {
      judge_sum(claims, verdicts);
      judge_all_there(f, claims, verdicts);
      judge_simple_roots(stand_in, claims, verdicts, stop);
    }
  }
  if (!bench.is_list()) {
    judge_points(f, claims, verdicts, stop);
    judge_common_roots(f, stand_in, claims, verdicts);
  }
  bench.require_time();
  judge_completeness(claims, stand_in, verdicts);
  judge_bound(claims, stand_in, verdicts, stop);
}

}  // namespace

Judgement check(const System& f, const Claims& claims, const std::atomic<bool>& stop) {
  Judgement judgement;
  judgement.form = claims.form;
  judgement.roots.listed = claims.roots.size();
  Verdicts verdicts(judgement);
  judge_paths(claims, verdicts);
  judgement.is_judged_whole = judge_system(f, claims, verdicts);
  if (!judgement.is_judged_whole || f.variables.empty()) return judgement;
  judge_planes(f, claims, verdicts);
  try {
    judge_roots(f, claims, verdicts, stop);
  } catch (const JudgementEnds&) {
    judgement.interrupted = true;
  }
  return judgement;
}

}  // namespace moivre
