// SPDX-License-Identifier: MIT
// Are the books of a result right? Its system's facts from the file, its counts from each other.
#include <algorithm>
#include <limits>
#include <set>

#include "bench.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/polynomial/eliminate.h"

namespace moivre {
namespace {

std::string list_text(const std::vector<std::uint64_t>& numbers) {
  std::vector<std::string> words;
  for (const std::uint64_t number : numbers) words.push_back(std::to_string(number));
  return joined(words, " ");
}

std::string stated(const std::string& what, const std::string& is, const std::string& should) {
  return what + ": " + is + " stated, " + should + " found";
}

std::string number_text(const std::optional<std::uint64_t>& number) {
  return number ? std::to_string(*number) : "beyond 64 bits";
}

/// Saturates: a sum beyond 64 bits equals no count.
std::uint64_t sum(const std::vector<std::uint64_t>& numbers) {
  std::uint64_t total = 0;
  for (const std::uint64_t number : numbers) {
    if (number > std::numeric_limits<std::uint64_t>::max() - total) {
      return std::numeric_limits<std::uint64_t>::max();
    }
    total += number;
  }
  return total;
}

void judge_count(Verdicts& verdicts, ClaimKind claim, const std::string& what,
                 const std::optional<std::uint64_t>& is,
                 const std::optional<std::uint64_t>& should) {
  if (!is || !should) return;
  verdicts.judge(claim, *is == *should, stated(what, number_text(is), number_text(should)));
}

/// The system whose paths were counted: what elimination leaves, or the whole, in isotropic
/// unknowns where it is said so.
std::optional<System> tracked_system(const ReducedClaim& claim, const System& whole,
                                     const System& reduced) {
  for (const System* g : {&reduced, &whole}) {
    const auto pairs =
        claim.isotropic_pairs > 0 ? isotropic_pairs(*g) : std::vector<IsotropicPair>{};
    if (pairs.size() != claim.isotropic_pairs) continue;
    System tracked = pairs.empty() ? *g : in_isotropic(*g, pairs);
    if (tracked.variables.size() == claim.variables && degrees(tracked) == claim.degrees) {
      return tracked;
    }
  }
  return std::nullopt;
}

/// The count of the start of this kind.
std::optional<std::uint64_t> count_of(const StartClaim& start) {
  if (start.kind == "total-degree") return start.total_degree;
  if (start.kind == "multihomogeneous") return start.multihomogeneous;
  if (start.kind == "polyhedral") return start.mixed_volume;
  return std::nullopt;
}

void judge_partitions(const StartClaim& start, const StructureCounts& counts,
                      const std::optional<std::uint64_t>& total, Verdicts& verdicts) {
  if (!start.multihomogeneous) return;
  const std::uint64_t claimed = *start.multihomogeneous;
  // No partition has fewer than the mixed volume, and the one with a single group has the total
  // degree.
  const bool is_impossible =
      claimed < counts.mixed_volume.value_or(0) || (total && claimed > *total);
  if (!is_impossible && !counts.is_least && counts.multihomogeneous != claimed) {
    return verdicts.leave_open(ClaimKind::start, "multihomogeneous number: not found again");
  }
  judge_count(verdicts, ClaimKind::start, "multihomogeneous number", claimed,
              counts.multihomogeneous);
}

void judge_counts_of_starts(const System& tracked, const StartClaim& start, Verdicts& verdicts,
                            const std::atomic<bool>& stop) {
  const std::optional<std::uint64_t> total = total_degree(degrees(tracked));
  judge_count(verdicts, ClaimKind::start, "total degree", start.total_degree, total);
  const bool counts_paths = start.multihomogeneous || start.mixed_volume;
  const StructureCounts counts =
      structure_counts(tracked, start.multihomogeneous.has_value(), counts_paths, &stop);
  if (stop) throw JudgementEnds();
  judge_partitions(start, counts, total, verdicts);
  if (start.mixed_volume && !counts.mixed_volume) {
    verdicts.leave_open(ClaimKind::start, "mixed volume: beyond a bounded search");
  } else {
    judge_count(verdicts, ClaimKind::start, "mixed volume", start.mixed_volume,
                counts.mixed_volume);
  }
}

/// Paths are numbered by the start; an interrupted run has tracked some of them.
std::uint64_t paths_there_are(const Claims& claims) {
  const std::uint64_t tracked = claims.paths->tracked;
  return claims.complete || !claims.start ? tracked : std::max(tracked, claims.start->paths);
}

void judge_roots_of_paths(const Claims& claims, Verdicts& verdicts) {
  const std::uint64_t paths = paths_there_are(claims);
  std::set<std::uint64_t> numbers;
  for (std::size_t k = 0; k < claims.roots.size(); ++k) {
    const RootClaim& root = claims.roots[k];
    if (root.winding) {
      verdicts.judge(ClaimKind::paths, sum(*root.winding) == root.multiplicity,
                     "the windings " + list_text(*root.winding) +
                         " do not add up to the multiplicity " + std::to_string(root.multiplicity),
                     k + 1);
    }
    if (!root.path) continue;
    const bool is_seen = !numbers.insert(*root.path).second;
    verdicts.judge(ClaimKind::paths, !is_seen && *root.path < paths,
                   "path " + std::to_string(*root.path) +
                       (is_seen ? " ends at another root" : " was not tracked"),
                   k + 1);
  }
}

}  // namespace

bool judge_system(const System& f, const Claims& claims, Verdicts& verdicts) {
  if (!claims.system) return true;
  const SystemClaim& claim = *claims.system;
  const bool same_unknowns = claim.variables == f.variables;
  verdicts.judge(ClaimKind::system, same_unknowns,
                 "another file: its unknowns are " + joined(claim.variables, " ") +
                     ", the system's " + joined(f.variables, " "));
  if (!same_unknowns) return false;
  const std::vector<std::uint64_t> should = degrees(f);
  verdicts.judge(ClaimKind::system, claim.degrees == should,
                 stated("degrees", list_text(claim.degrees), list_text(should)));
  const auto total = total_degree(should);
  verdicts.judge(ClaimKind::system, claim.total_degree == total,
                 stated("total degree", number_text(claim.total_degree), number_text(total)));
  return true;
}

void judge_start(const System& f, const StandIn& stand_in, const Claims& claims, Verdicts& verdicts,
                 const std::atomic<bool>& stop) {
  if (claims.start) {
    judge_count(verdicts, ClaimKind::start, "paths of the " + claims.start->kind + " start",
                claims.start->paths, count_of(*claims.start));
    if (claims.complete && claims.paths) {
      judge_count(verdicts, ClaimKind::paths, "tracked", claims.paths->tracked,
                  claims.start->paths);
    }
  }
  if (!claims.reduced) return;
  if (f.polynomials.size() > f.variables.size() || stand_in.has_patches()) {
    return verdicts.leave_open(ClaimKind::reduced,
                               "those of a square system that stands for the file's");
  }
  const Reduction reduction = eliminate(stand_in.system, &stop);
  if (stop) throw JudgementEnds();
  const auto tracked = tracked_system(*claims.reduced, stand_in.system, reduction.system);
  const std::vector<std::uint64_t> left = degrees(reduction.system);
  verdicts.judge(
      ClaimKind::reduced, tracked.has_value(),
      stated(
          "unknowns and degrees",
          std::to_string(claims.reduced->variables) + " of " + list_text(claims.reduced->degrees),
          std::to_string(reduction.system.variables.size()) + " of " + list_text(left)));
  const bool has_paths = reduction.verdict == Reduction::Verdict::square;
  if (tracked && has_paths && claims.start) {
    judge_counts_of_starts(*tracked, *claims.start, verdicts, stop);
  }
}

void judge_paths(const Claims& claims, Verdicts& verdicts) {
  if (claims.listed) {
    verdicts.judge(ClaimKind::complete, *claims.listed == claims.roots.size(),
                   "the list announces " + counted(*claims.listed, "root") + " and holds " +
                       std::to_string(claims.roots.size()));
  }
  if (!claims.paths) return;
  const PathClaim& paths = *claims.paths;
  judge_count(verdicts, ClaimKind::paths, "tracked, as finite + at_infinity + failed + not_needed",
              paths.tracked,
              sum({paths.finite, paths.at_infinity, paths.failed, paths.not_needed}));
  std::vector<std::uint64_t> finite{paths.on_positive_dimensional, claims.excess, claims.left_out};
  for (const RootClaim& root : claims.roots) finite.push_back(root.multiplicity);
  judge_count(verdicts, ClaimKind::paths,
              "finite, as multiplicities + on_positive_dimensional + excess + roots left out",
              paths.finite, sum(finite));
  verdicts.judge(ClaimKind::paths, paths.by_count <= paths.finite,
                 "more paths end at a root by a count than are finite");
  judge_count(verdicts, ClaimKind::paths, "failed, as listed", paths.failed, claims.failures);
  if (paths.retracked) {
    verdicts.judge(ClaimKind::paths, *paths.retracked <= paths.tracked,
                   "more paths are retracked than tracked");
    verdicts.judge(ClaimKind::paths, paths.handed_over.value_or(0) <= *paths.retracked,
                   "more paths are handed over than retracked");
  }
  if (claims.complete) {
    verdicts.judge(ClaimKind::complete, paths.failed == 0,
                   std::to_string(paths.failed) + " failed, and every path is said to be decided");
  }
  judge_roots_of_paths(claims, verdicts);
}

}  // namespace moivre
