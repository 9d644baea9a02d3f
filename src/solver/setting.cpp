// SPDX-License-Identifier: MIT
// The prepared system, the trackers at hand, and in which precisions an equation's smallest terms
// are lost beside its largest ones.
#include "setting.h"

#include "finer_trackers.h"
#include "moivre/certify/certifier.h"
#include "moivre/numeric/threads.h"
#include "moivre/tracker/double_double_tracker.h"

namespace moivre {
namespace {

// Where the spread of an equation's coefficients leaves its smallest terms fewer bits than these,
// they are noise to who followed the path, and ends at multiple roots and on sets may be those of
// the system without them. Ends at infinity may not: their faces have every term.
constexpr double kBitsOfTerms = 17;

/// At least.
double bits_of(PathPrecision precision) {
  switch (precision) {
    case PathPrecision::double_precision:
    case PathPrecision::mixed:
      return 53;
    case PathPrecision::double_double:
      return 106;
    case PathPrecision::multiprecision:
      return 332;  // of 100 digits, the fewest that make_finer_trackers() has
  }
  return 0;
}

std::unique_ptr<Tracker> in_double_double(const Tracker& tracker, const Tracker* fallback) {
  auto own = tracker.in_double_double();
  return own || fallback == nullptr ? std::move(own) : fallback->in_double_double();
}

Trackers trackers_of(const Tracker& tracker, const SolveOptions& options) {
  if (options.precision == Precision::double_precision) {
    return {tracker, options.fallback, nullptr, nullptr, {}};
  }
  return {tracker, options.fallback, in_double_double(tracker, options.fallback),
          make_double_double_tracker(), make_finer_trackers()};
}

}  // namespace

Setting::Setting(const System& system, const Tracker& tracker, const SolveOptions& solve_options,
                 const std::atomic<bool>& stop_flag)
    : Setting(system, prepare(system, solve_options, stop_flag), tracker, solve_options,
              stop_flag) {}

Setting::Setting(const System& system, Prepared the_prepared, const Tracker& tracker,
                 const SolveOptions& solve_options, const std::atomic<bool>& stop_flag)
    : f(system),
      options(solve_options),
      stop(stop_flag),
      threads(thread_count(options.threads)),
      trackers(trackers_of(tracker, options)),
      prepared(std::move(the_prepared)),
      endgame(options.endgame),
      refiner_program(make_refiner_program(f, natural_sizes(prepared))),
      certify_program(f.variables.empty() ? nullptr : make_certify_program(f)) {
  endgame.goes_straight = endgame.goes_straight || is_fine();
  endgame.goes_back = true;
}

bool Setting::hides_terms(PathPrecision precision) const {
  return prepared.spread_log2 > bits_of(precision) - kBitsOfTerms;
}

const Tracker& Setting::tracker() const {
  if (!is_fine()) return trackers.first;
  return trackers.fine_lanes ? *trackers.fine_lanes : *trackers.fine;
}

bool Setting::falls_back(int tolerance_level) const {
  return trackers.fallback != nullptr && !is_fine() && tolerance_level > 0;
}

PathProblem Setting::problem(int tolerance_level) const {
  return {*prepared.plan, falls_back(tolerance_level) ? *trackers.fallback : tracker(), endgame};
}

}  // namespace moivre
