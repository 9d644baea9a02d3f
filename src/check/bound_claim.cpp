// SPDX-License-Identifier: MIT
// Is the bound that a result names met, and is it one? Its value beside the roots of the result,
// and beside the bound of its kind.
#include <algorithm>

#include "bench.h"
#include "moivre/expression/counted.h"
#include "moivre/polynomial/eliminate.h"

namespace moivre {
namespace {

/// As it is called here: a mixed volume of supports that have 0 all is a stable one.
std::optional<BoundKind> kind_of(const std::string& name) {
  const std::optional<BoundKind> kind = bound_named(name);
  return kind == BoundKind::mixed_volume ? BoundKind::stable_mixed_volume : kind;
}

std::uint64_t roots_counted(const Claims& claims, BoundKind kind) {
  if (kind == BoundKind::strata) return claims.roots.size();
  std::uint64_t sum = 0;
  for (const RootClaim& root : claims.roots) sum += root.multiplicity;
  return sum;
}

/// Of what elimination leaves, and of the whole: which of them was tracked is the solver's choice.
std::vector<RootBound> bounds_of_kind(const System& f, BoundKind kind, const KnownRoots& known,
                                      const std::atomic<bool>& stop) {
  const Reduction reduction = eliminate(f, &stop);
  using enum Reduction::Verdict;
  if (reduction.verdict == solved || reduction.verdict != square) {
    return {{BoundKind::elimination, reduction.verdict == solved ? 1 : 0, ""}};
  }
  std::vector<RootBound> bounds{root_bound(reduction.system, kind, known, &stop)};
  if (!reduction.substitutions.empty() || reduction.system != f) {
    bounds.push_back(root_bound(f, kind, known, &stop));
  }
  return bounds;
}

/// What they are instead; nothing is known of some.
std::string found_text(const std::vector<RootBound>& bounds) {
  std::string text;
  for (const RootBound& bound : bounds) {
    if (!bound.value) continue;
    text += (text.empty() ? "" : " or ") + std::to_string(*bound.value);
  }
  return text.empty() ? "none was found" : "found is " + text;
}

}  // namespace

void judge_bound(const Claims& claims, const StandIn& stand_in, Verdicts& verdicts,
                 const std::atomic<bool>& stop) {
  if (!claims.bound) return;
  const auto& [name, value, certainty] = *claims.bound;
  const std::optional<BoundKind> kind = kind_of(name);
  if (!kind) return verdicts.refute(ClaimKind::bound, "no bound is called \"" + name + "\"");
  const std::string rests_on = to_string(certainty_of(*kind));
  if (certainty && *certainty != rests_on) {
    return verdicts.refute(ClaimKind::bound, "the " + name + " is said to rest on \"" + *certainty +
                                                 "\", and rests on \"" + rests_on + "\"");
  }
  if (claims.completeness != "proved") {
    return verdicts.refute(ClaimKind::bound, "said to be met, and completeness not to be proved");
  }
  // Of roots that are not listed it is known how often they count, not how many they are.
  const std::uint64_t roots = roots_counted(claims, *kind);
  if (roots > value || value - roots > claims.left_out) {
    const std::string untold =
        claims.left_out > 0 ? " and " + std::to_string(claims.left_out) + " that are not told" : "";
    return verdicts.refute(ClaimKind::bound, "a " + name + " of " + std::to_string(value) +
                                                 " is said to be met, by " +
                                                 counted(roots, "root") + untold);
  }
  if (!stand_in.has_all_roots) return;
  const auto is_it = [&kind, value = value](const RootBound& bound) {
    return bound.kind == *kind && bound.value == value;
  };
  const std::vector<RootBound>& known = verdicts.judgement().bounds;
  if (std::any_of(known.begin(), known.end(), is_it)) return verdicts.hold(ClaimKind::bound);
  const std::vector<RootBound> bounds =
      bounds_of_kind(stand_in.system, *kind, {value, value}, stop);
  if (stop) throw JudgementEnds();
  if (std::any_of(bounds.begin(), bounds.end(), is_it)) return verdicts.hold(ClaimKind::bound);
  const std::string why =
      std::to_string(value) + " is said to be the " + name + ", and " + found_text(bounds);
  // Another partition of the unknowns may have fewer paths than the one that was found.
  const bool are_known =
      std::all_of(bounds.begin(), bounds.end(), [](const RootBound& b) { return b.value; });
  const bool is_told =
      *kind == BoundKind::elimination || (*kind != BoundKind::multihomogeneous && are_known);
  if (is_told) return verdicts.refute(ClaimKind::bound, why);
  verdicts.leave_proof_open(ClaimKind::bound, why);
}

}  // namespace moivre
