// SPDX-License-Identifier: MIT
// The bounds, cheapest first, and what follows where one is met.
#include "completeness.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "certificates.h"
#include "moivre/start/mixed_volume.h"
#include "moivre/start/polyhedral.h"

namespace moivre {
namespace {

/// The bound whose value is `roots`; throws where it is less.
bool is_met(const std::optional<std::uint64_t>& bound, std::uint64_t roots,
            const std::string& kind) {
  if (bound && *bound < roots) {
    throw std::logic_error(std::to_string(roots) + " roots are proved, but the " + kind + " is " +
                           std::to_string(*bound));
  }
  return bound == roots;
}

CellSearchOptions bounded_search(const Run& run) {
  CellSearchOptions options;
  options.stop = &run.setting.stop;
  options.most_steps =
      search_steps_for(run.setting.prepared.reduction.system, run.setting.prepared.start.paths);
  return options;
}

/// Of the supports with 0 added, where two liftings agree.
std::optional<std::uint64_t> mixed_volume_of(Run& run) {
  std::optional<std::uint64_t>& known = run.bounds.mixed_volume;
  if (std::exchange(run.bounds.mixed_volume_was_sought, true)) return known;
  const Setting& setting = run.setting;
  const std::vector<Support> supports = start_supports(setting.prepared.reduction.system);
  const auto& counted = setting.prepared.start.counts.mixed_volume.paths;
  const std::uint64_t seed = setting.options.seed;
  if (!counted) {
    // An automatic start has given the search up.
    if (setting.options.start == StartKind::automatic) return known;
    known = verified_mixed_volume(supports, seed, bounded_search(run)).value;
  } else if (mixed_volume(supports, seed, bounded_search(run)).value == *counted) {
    known = counted;  // that one came from the coefficients, this one from random numbers
  }
  return known;
}

bool lacks_origin(const Support& support) {
  return std::none_of(support.terms.begin(), support.terms.end(), [](const auto& term) {
    return std::all_of(term.begin(), term.end(), [](auto exponent) { return exponent == 0; });
  });
}

std::optional<std::uint64_t> stable_mixed_volume_of(Run& run) {
  std::optional<std::uint64_t>& known = run.bounds.stable_mixed_volume;
  if (std::exchange(run.bounds.stable_mixed_volume_was_sought, true)) return known;
  const std::vector<Support> supports = supports_of(run.setting.prepared.reduction.system);
  if (std::none_of(supports.begin(), supports.end(), lacks_origin)) return known;
  const std::uint64_t seed = run.setting.options.seed;
  const auto first = stable_mixed_volume(supports, seed, bounded_search(run)).value;
  if (first && first == stable_mixed_volume(supports, ~seed, bounded_search(run)).value) {
    known = first;
  }
  return known;
}

std::optional<RootBound> bound_met_by(Run& run, std::uint64_t roots) {
  const StartCounts& counts = run.setting.prepared.start.counts;
  const auto met = [&](const std::string& kind) { return RootBound{kind, roots}; };
  if (is_met(counts.total_degree.paths, roots, "total degree")) return met("total degree");
  if (is_met(counts.multihomogeneous.paths, roots, "multihomogeneous number")) {
    return met("multihomogeneous number");
  }
  const auto& counted = counts.mixed_volume.paths;
  if ((!counted || *counted == roots) && is_met(mixed_volume_of(run), roots, "mixed volume")) {
    return met("mixed volume");
  }
  if (is_met(stable_mixed_volume_of(run), roots, "stable mixed volume")) {
    return met("stable mixed volume");
  }
  return std::nullopt;
}

/// The path is at no root, and has not failed either.
void leave(Run& run, std::uint64_t path) {
  run.ledger.strike(path);
  run.rungs.erase(path);
  run.ledger.enter_infinity(path);
  ++run.left_by_bound;
}

}  // namespace

std::optional<RootBound> met_bound(Run& run) {
  if (!run.setting.certify_program || run.interrupted || run.setting.stop) return std::nullopt;
  if (!run.bounds.met) run.bounds.met = bound_met_by(run, proved_roots(run));
  return run.bounds.met;
}

bool settle_by_bound(Run& run) {
  if (!met_bound(run)) return false;
  for (const auto& group : groups_of(run)) {
    const auto root = [&](std::uint64_t path) -> const Root& {
      return run.ledger.roots().at(path);
    };
    const auto proved = std::find_if(group.begin(), group.end(), [&](std::uint64_t path) {
      return root(path).certificate != nullptr;
    });
    if (proved == group.end() && is_on_set(run, root(group.front()))) continue;
    for (const std::uint64_t path : group) {
      if (proved == group.end() || path != *proved) leave(run, path);
    }
  }
  std::vector<std::uint64_t> failed;
  for (const auto& [path, failure] : run.ledger.failures()) failed.push_back(path);
  for (const std::uint64_t path : failed) leave(run, path);
  run.unsettled_conjugates = 0;
  return true;
}

void tell_completeness(const Run& run, SolveResult& result) {
  if (!run.setting.certify_program) return;
  const bool all_certified =
      std::all_of(result.solutions.begin(), result.solutions.end(),
                  [](const Solution& root) { return root.singular || *root.certified; });
  result.bound = run.bounds.met;
  result.completeness = result.bound                       ? Completeness::proved
                        : result.complete && all_certified ? Completeness::shown
                                                           : Completeness::open;
  if (run.left_by_bound == 0) return;
  result.left_out.push_back(
      {std::to_string(run.left_by_bound) + (run.left_by_bound == 1 ? " path" : " paths") +
           " in doubt",
       "the certified roots are as many as the " + result.bound->kind + ": it leads to no other"});
}

}  // namespace moivre
