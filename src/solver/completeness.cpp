// SPDX-License-Identifier: MIT
// The bounds, cheapest first, and what follows where one is met.
#include "completeness.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include "certificates.h"
#include "coincidence.h"
#include "exact_roots.h"
#include "judge.h"
#include "moivre/expression/counted.h"
#include "moivre/start/choose_start.h"
#include "moivre/start/mixed_volume.h"
#include "moivre/start/polyhedral.h"
#include "moivre/start/strata.h"
#include "solver_sentences.h"

namespace moivre {
namespace {

// Steps of a search that are always worth it: some milliseconds.
constexpr std::uint64_t kLeastSearch = 10'000;
// Terms of the algebra that are always worth it, some thirty milliseconds at most; beyond them, a
// share of what the paths cost, in multiply-adds a term.
constexpr double kLeastTerms = 3'000'000;
constexpr double kAlgebraShare = 0.5;
// Some ten seconds.
constexpr std::uint64_t kMostTerms = 1'000'000'000;
constexpr double kTermCost = 20;
// A path in 100 and then in 300 digits takes some thousands of times as long as in double.
constexpr double kAllDigits = 5000;

/// The bound whose value is `roots`; throws where it is less.
bool is_met(const std::optional<std::uint64_t>& bound, std::uint64_t roots, BoundKind kind) {
  if (bound && *bound < roots) {
    throw std::logic_error(counted(roots, "root") + " are proved, but the " +
                           name_in_results(kind) + " is " + std::to_string(*bound));
  }
  return bound == roots;
}

/// So many paths a bound would spare.
std::uint64_t paths_at_stake(const Run& run) {
  return run.waiting.empty() ? run.setting.prepared.start.paths : run.waiting.size();
}

CellSearchOptions bounded_search(const Run& run, const System& f) {
  CellSearchOptions options;
  options.stop = &run.setting.stop;
  const std::uint64_t least = run.waiting.empty() ? kLeastSearch : 1;
  options.most_steps = std::max(least, search_steps_for(f, paths_at_stake(run)));
  return options;
}

/// The stable mixed volume, where two liftings agree; it is the mixed volume where no support lacks
/// 0.
std::optional<std::uint64_t> verified_volume(const Run& run, const System& f) {
  const std::uint64_t seed = run.setting.options.seed;
  const CellSearchOptions search = bounded_search(run, f);
  if (!lacks_origin(f)) return verified_mixed_volume(start_supports(f), seed, search).value;
  const std::vector<Support> supports = supports_of(f);
  const auto first = stable_mixed_volume(supports, seed, search).value;
  if (!first || first != stable_mixed_volume(supports, ~seed, search).value) return std::nullopt;
  return first;
}

/// Where it may be `roots` as far as the start has counted it, and the start was not told to give
/// the search up.
bool is_worth_a_search(const Run& run, std::uint64_t roots) {
  const Setting& setting = run.setting;
  const auto counted = setting.prepared.start.counts.mixed_volume.paths;
  if (!counted) return setting.options.start != StartKind::automatic;
  return counted == roots || lacks_origin(setting.prepared.reduction.system);
}

std::uint64_t terms_worth_looking_at(const Run& run) {
  const Prepared& prepared = run.setting.prepared;
  const double cost = cost_of_paths(prepared.reduction.system, paths_at_stake(run));
  const PathSet open = open_to_more_digits(run);
  const double least = !run.waiting.empty() ? 0
                       : open.empty()       ? kLeastTerms
                                            : static_cast<double>(terms_instead_of(run, open));
  return static_cast<std::uint64_t>(
      std::min(std::max(least, kAlgebraShare * cost / kTermCost), 1e18));
}

/// Looked for when `roots` are known; not where some are left out.
const QuotientRing& ring_of(Run& run, std::uint64_t roots) {
  if (run.setting.prepared.leaves_out) return run.bounds.ring;
  Bounds& bounds = run.bounds;
  if (bounds.ring.verdict != QuotientRing::Verdict::not_found) return bounds.ring;
  const std::uint64_t most_terms = terms_worth_looking_at(run);
  if (bounds.for_ring.allows(most_terms)) {
    bounds.ring =
        quotient_ring(run.setting.prepared.reduction.system, {.known = roots,
                                                              .most_terms = most_terms,
                                                              .stop = &run.setting.stop,
                                                              .seed = run.setting.options.seed});
  }
  return bounds.ring;
}

std::optional<MetBound> volume_met_by(Run& run, std::uint64_t roots) {
  if (!is_worth_a_search(run, roots)) return std::nullopt;
  const System& f = run.setting.prepared.reduction.system;
  Bounds& bounds = run.bounds;
  if (!bounds.volume && bounds.for_volume.allows(bounded_search(run, f).most_steps)) {
    bounds.volume = verified_volume(run, f);
  }
  const BoundKind kind = lacks_origin(f) ? BoundKind::stable_mixed_volume : BoundKind::mixed_volume;
  if (is_met(bounds.volume, roots, kind)) return MetBound{kind, roots};
  return std::nullopt;
}

/// No mixed volume is less than the number of roots.
std::optional<MetBound> ring_or_volume_met_by(Run& run, std::uint64_t roots) {
  const QuotientRing& ring = ring_of(run, roots);
  if (ring.verdict != QuotientRing::Verdict::finite) return volume_met_by(run, roots);
  if (is_met(ring.dimension, roots, BoundKind::quotient_ring)) {
    return MetBound{BoundKind::quotient_ring, roots};
  }
  return std::nullopt;
}

/// Roots at 0 and curves on which coordinates vanish leave it as it is. Of the same `points` it is
/// asked once, unless another search is worth it.
std::optional<MetBound> strata_met_by(Run& run, std::uint64_t points) {
  const System& f = run.setting.f;
  if (!lacks_origin(f)) return std::nullopt;
  const CellSearchOptions search = bounded_search(run, f);
  Bounds& bounds = run.bounds;
  if (bounds.asked_by_strata != points) bounds.for_strata = {};
  if (!bounds.for_strata.allows(search.most_steps)) return std::nullopt;
  bounds.asked_by_strata = points;
  const auto most = most_isolated_points(f, run.setting.options.seed, search, points);
  if (!is_met(most, points, BoundKind::strata)) return std::nullopt;
  return MetBound{BoundKind::strata, points};
}

/// What is known: `roots` with their multiplicities, at `points`.
std::optional<MetBound> bound_met_by(Run& run, std::uint64_t roots, std::uint64_t points) {
  const std::optional<MetBound>& given = run.setting.prepared.given_bound;
  if (given && is_met(given->value, roots, given->kind)) return given;
  const StartCounts& counts = run.setting.prepared.start.counts;
  const std::pair<BoundKind, const StartCount*> degrees[]{
      {BoundKind::bezout, &counts.total_degree},
      {BoundKind::multihomogeneous, &counts.multihomogeneous}};
  for (const auto& [kind, count] : degrees) {
    if (is_met(count->paths, roots, kind)) return MetBound{kind, roots};
  }
  const auto met = counts.mixed_volume.paths == roots ? volume_met_by(run, roots)
                                                      : ring_or_volume_met_by(run, roots);
  return met ? met : strata_met_by(run, points);
}

/// Sets bounds.met where `roots`, proved and with their multiplicities, or their `points` meet a
/// bound.
bool meets_bound(Run& run, std::uint64_t roots, std::uint64_t points) {
  if (run.interrupted || run.setting.stop) return false;
  std::optional<MetBound>& met = run.bounds.met;
  // Roots that are proved no more do not meet what they did.
  if (met && met->value != (met->is_of_points() ? points : roots)) met.reset();
  if (!met) met = bound_met_by(run, roots, points);
  return met.has_value();
}

Refined point_of(const Run& run, const ExactRoot& exact) {
  Refined point;
  point.x = exact.x;
  point.condition = std::numeric_limits<double>::infinity();
  if (!exact.is_rounded) return point;
  point.accuracy = std::numeric_limits<double>::epsilon();
  Refiner refiner(run.setting.refiner_program);
  point.residual = refiner.residual(exact.x);
  return point;
}

/// What is known of an end, which is that exact root.
Root at_exact(const Run& run, const ExactRoot& exact, Root root = {}) {
  root.point = point_of(run, exact);
  root.is_exact = true;
  return root;
}

/// The exact roots and how many paths each still lacks.
class Places {
 public:
  explicit Places(std::vector<ExactRoot> exact) : places_(std::move(exact)) {}

  std::uint64_t points() const { return places_.size(); }
  std::uint64_t count() const {
    std::uint64_t sum = 0;
    for (const ExactRoot& place : places_) sum += place.multiplicity;
    return sum;
  }

  /// Whole cycles that end there as often as the root counts keep their winding numbers.
  bool is_filled_by(Run& run, PathGroups::Group group) {
    const Root& end = run.table.roots().at(group.front());
    for (ExactRoot& place : places_) {
      const bool fits = place.multiplicity == group.size() && cycles(run.table, group) &&
                        relative_distance(place.x, end.point.x) <= end.tolerance;
      if (!fits) continue;
      for (const std::uint64_t path : group) {
        run.table.enter_root(path, at_exact(run, place, run.table.roots().at(path)));
      }
      place.multiplicity = 0;
      return true;
    }
    return false;
  }

  /// With paths whose ends were seen there, and then with any: of those a count tells no more than
  /// that so many lead there. The paths that were not needed.
  std::vector<std::uint64_t> fill(Run& run, std::vector<std::uint64_t> paths) {
    for (ExactRoot& place : places_) {
      std::erase_if(paths, [&](std::uint64_t path) {
        if (place.multiplicity == 0 || !run.table.is_seen_at(path, place.x)) return false;
        run.table.enter_root(path, at_exact(run, place));
        --place.multiplicity;
        return true;
      });
    }
    auto next = paths.begin();
    for (const ExactRoot& place : places_) {
      for (std::uint64_t k = 0; k < place.multiplicity; ++k) {
        run.table.enter_by_count(*next++, at_exact(run, place));
      }
    }
    return {next, paths.end()};
  }

 private:
  std::vector<ExactRoot> places_;
};

/// Ends at no root that is proved, counted, or on a set of positive dimension. Where exact algebra
/// counts the roots there is no such set.
std::vector<std::uint64_t> spare_paths(Run& run, Places& places) {
  const bool may_be_on_sets = run.bounds.ring.verdict != QuotientRing::Verdict::finite;
  std::vector<std::uint64_t> spare;
  for (const PathGroups::Group group : groups_of(run)) {
    const auto proved = std::find_if(group.begin(), group.end(), [&](std::uint64_t path) {
      return run.table.roots().at(path).certificate != nullptr;
    });
    if (proved == group.end()) {
      if (places.is_filled_by(run, group)) continue;
      if (may_be_on_sets && is_on_set(run, run.table.roots().at(group.front()))) continue;
    }
    std::copy_if(group.begin(), group.end(), std::back_inserter(spare),
                 [&](std::uint64_t path) { return proved == group.end() || path != *proved; });
  }
  for (const auto& [path, failure] : run.table.failures()) spare.push_back(path);
  for (const std::uint64_t path : run.table.refuted()) spare.push_back(path);
  for (const auto& [path, endgame_start] : run.waiting) spare.push_back(path);
  return spare;
}

std::uint64_t ends_at_roots(const Run& run) {
  std::uint64_t ends = 0;
  for (const JudgedRoot& judged : judge(run).roots) ends += judged.paths.size();
  return ends;
}

}  // namespace

std::uint64_t terms_instead_of(const Run& run, const PathSet& paths) {
  const double of_one = cost_of_paths(run.setting.prepared.reduction.system, 1) / kTermCost;
  double terms = 0;
  for (const std::uint64_t path : paths) {
    const double instead = run.in_double_double.contains(path) ? kAllDigits * of_one : 0;
    terms += std::max(static_cast<double>(kAffordableTerms), instead);
  }
  return static_cast<std::uint64_t>(std::min(terms, static_cast<double>(kMostTerms)));
}

bool is_longest_algebra_worth_it(const Run& run) {
  return !run.waiting.empty() && terms_worth_looking_at(run) >= kMostTerms;
}

bool are_ends_as_many_as_bound(const Run& run) {
  const auto& [total_degree, multihomogeneous, mixed_volume] = run.setting.prepared.start.counts;
  const std::optional<MetBound>& given = run.setting.prepared.given_bound;
  const QuotientRing& ring = run.bounds.ring;
  const std::uint64_t ends = ends_at_roots(run);
  return (given && ends == given->value) || ends == total_degree.paths ||
         ends == multihomogeneous.paths || ends == mixed_volume.paths ||
         ends == run.bounds.volume ||
         (ring.verdict == QuotientRing::Verdict::finite && ends == ring.dimension);
}

bool settle_by_bound(Run& run) {
  run.bounds.lacks_paths = false;
  Places places(exact_roots(run));
  const std::uint64_t proved = proved_roots(run);
  if (!meets_bound(run, proved + places.count(), proved + places.points())) return false;
  const std::vector<std::uint64_t> spare = spare_paths(run, places);
  // Of the paths that are said to be at infinity some are not, and nothing tells which.
  run.bounds.lacks_paths = spare.size() < places.count();
  if (run.bounds.lacks_paths) return false;
  for (const std::uint64_t path : places.fill(run, spare)) run.table.leave(path);
  run.waiting.clear();
  return true;
}

bool is_root_missing(Run& run) {
  const QuotientRing& ring = run.bounds.ring;
  if (ring.simple) return proved_roots(run) < *ring.simple;
  return ring.verdict == QuotientRing::Verdict::finite &&
         proved_roots(run) + Places(exact_roots(run)).count() < ring.dimension;
}

bool lacks_ends(const Run& run) {
  const QuotientRing& ring = run.bounds.ring;
  if (ring.verdict != QuotientRing::Verdict::finite) return false;
  return run.table.count(PathVerdict::as_rounded) + ends_at_roots(run) < ring.dimension;
}

void look_for_ring(Run& run) {
  const bool is_wanted = run.bounds.ring.verdict == QuotientRing::Verdict::not_found &&
                         !run.setting.prepared.leaves_out &&
                         run.bounds.for_ring.allows(kAffordableTerms);
  if (!is_wanted) return;
  run.bounds.ring = quotient_ring(run.setting.prepared.reduction.system,
                                  {.stop = &run.setting.stop, .seed = run.setting.options.seed});
}

bool are_as_counted(Run& run) {
  const QuotientRing& ring = run.bounds.ring;
  if (ring.verdict != QuotientRing::Verdict::finite || run.setting.stop) return false;
  const JudgedRoots judged = judge_ends_alone(run).roots;
  std::uint64_t roots = 0;
  for (const auto& [group, ground] : judged) {
    if (ground == Ground::on_set) return false;
    roots += group.size();
  }
  if (roots != ring.dimension) return false;
  const std::uint64_t terms =
      std::max(kAffordableTerms, terms_instead_of(run, open_to_more_digits(run)));
  if (run.bounds.for_points.allows(terms)) {
    run.bounds.points =
        quotient_ring(run.setting.prepared.reduction.system, {.most_terms = terms,
                                                              .stop = &run.setting.stop,
                                                              .counts_points = true,
                                                              .seed = run.setting.options.seed})
            .points;
  }
  return judged.size() == run.bounds.points;
}

std::optional<std::uint64_t> roots_to_compare(const Run& run) {
  if (!run.bounds.ring.simple) return std::nullopt;
  return proved_roots(run);
}

std::optional<std::string> contradiction_by_algebra(const Run& run,
                                                    std::optional<std::uint64_t> proved,
                                                    const SolveResult& result) {
  if (run.bounds.lacks_paths && run.setting.prepared.leads_to_all)
    return doubt_message(SolveDoubt::too_few_paths_at_a_root);
  const QuotientRing& ring = run.bounds.ring;
  // Ends that the digits of the file do not tell from infinity may be roots of the file to the
  // letter.
  const std::uint64_t hidden = run.table.count(PathVerdict::as_rounded);
  const auto is_between = [&](std::uint64_t count, std::uint64_t found) {
    return found <= count && count <= found + hidden;
  };
  if (proved && !is_between(*ring.simple, *proved)) {
    return algebra_doubt(AlgebraCount::simple, *ring.simple, *proved);
  }
  if (ring.verdict != QuotientRing::Verdict::finite) return std::nullopt;
  if (!result.on_sets.empty()) return doubt_message(SolveDoubt::paths_end_on_a_curve);
  std::uint64_t roots = 0;
  for (const Solution& root : result.solutions) roots += root.multiplicity;
  if (!is_between(ring.dimension, roots)) {
    return algebra_doubt(AlgebraCount::with_multiplicities, ring.dimension, roots);
  }
  const std::optional<std::uint64_t>& points = run.bounds.points;
  if (!points || is_between(*points, result.solutions.size())) return std::nullopt;
  return algebra_doubt(AlgebraCount::different, *points, result.solutions.size());
}

std::optional<std::string> doubt_of_start(const Run& run) {
  const bool is_counted = run.bounds.ring.verdict == QuotientRing::Verdict::finite;
  if (run.setting.prepared.leads_to_all || run.bounds.met || is_counted) return std::nullopt;
  return doubt_message(SolveDoubt::family_may_lack_roots);
}

void tell_completeness(const Run& run, SolveResult& result) {
  const bool all_certified =
      std::all_of(result.solutions.begin(), result.solutions.end(),
                  [](const Solution& root) { return root.singular || *root.certified; });
  // Where a result contradicts what is known a bound proves nothing of it.
  if (result.complete && !run.bounds.lacks_paths) result.bound = run.bounds.met;
  const bool is_shown = result.complete && all_certified && run.setting.prepared.leads_to_all;
  result.completeness = result.bound ? RootCompleteness::proved
                        : is_shown   ? RootCompleteness::shown
                                     : RootCompleteness::open;
  const std::uint64_t left = run.table.count(PathVerdict::not_needed);
  if (left == 0) return;
  const auto& met = run.bounds.met;
  const auto bound = met ? std::optional(met->kind) : std::nullopt;
  result.left_out.push_back(paths_not_needed_left_out(left, bound));
}

}  // namespace moivre
