// SPDX-License-Identifier: MIT
// From the mechanism to its closures: roots of its closure polynomials, poses of the real ones, and
// the verdict.
#include "moivre/closures/closures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "closure_poses.h"
#include "closure_product.h"
#include "closure_roots.h"
#include "closure_sentences.h"
#include "fitted_poses.h"
#include "moivre/closures/idle_joints.h"
#include "moivre/kinematics/local_dimension.h"
#include "moivre/mechanism/drawn_pose.h"
#include "moivre/mechanism/driver_law.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/stopwatch.h"
#include "moving_pose.h"
#include "witness.h"

namespace moivre {
namespace {

/// All that is known before anything is solved.
ClosureResult described(const ClosureSearch& search) {
  const System& f = search.formulation.system;
  ClosureResult result;
  result.seed = search.options.solve.seed;
  result.time = search.options.time;
  result.system = {f.variables, degrees(f), total_degree(degrees(f))};
  result.start.why = why_blocks_are_solved_in_order();
  for (StartCount* count :
       {&result.start.counts.total_degree, &result.start.counts.multihomogeneous,
        &result.start.counts.mixed_volume}) {
    count->missing = why_blocks_have_counts();
  }
  result.tracker = search.tracker.kind();
  result.tracker_options = search.tracker.options_in_force();
  result.coordinates = search.phi.dimension();
  result.complete = true;
  for (const auto& [what, why] : search.formulation.left_out)
    result.left_out.push_back({what, why});
  return result;
}

/// `phi`: of the mechanism as it is, nothing held.
void add_mobility(const Phi& phi, double fit, bool is_wanted, ClosureResult& result) {
  result.constraints = phi.size() - phi.driver_size();
  if (!is_wanted) return;
  if (!result.closures.empty()) {
    result.mobility = constraint_rank(phi, result.closures.front().q, result.time, fit);
  } else if (result.moves) {
    const Eigen::VectorXd q = generic_pose(phi, result.moves->pose, result.time, result.seed);
    result.mobility = constraint_rank(phi, q, result.time, fit);
  }
}

/// Whether roots were lost by solving equations that depend on each other, and all of them combined
/// may have these.
bool may_find_more(const ClosureSearch& search) {
  const System& f = search.formulation.system;
  return search.rootless > 0 && !search.stop && f.polynomials.size() > f.variables.size();
}

void find_all(ClosureSearch& search) {
  find_roots(search);
  find_poses(search);
  look_for_witnesses(search);
  tell_limits(search);
}

/// What was done before stays in the account.
void keep_account(const ClosureResult& first, ClosureResult& result) {
  result.stages.insert(result.stages.begin(), first.stages.begin(), first.stages.end());
  result.paths += first.paths;
  result.work += first.work;
}

/// Everything anew, with all equations combined. What was done before stays in the account, and
/// what missed by little is looked at again.
void find_all_combined(ClosureSearch& search) {
  const ClosureResult first = std::move(search.result);
  for (const Closure& closure : first.closures) {
    if (closure.is_fitted) search.fitted_before.push_back(closure.q);
  }
  search.result = described(search);
  search.is_combined = true;
  search.lost_images = search.unproved = search.unpolished = search.rootless = 0;
  find_all(search);
  keep_account(first, search.result);
}

/// Why the search is not complete.
std::string shortfall(const ClosureSearch& search) {
  using enum ClosureVerdict;
  // What is missing may be what was not looked for any more.
  if (search.stop) return closure_message(interrupted);
  if (search.undecided_motion) {
    const bool is_drawn_alone = is_drawn_at(search.mechanism, search.options.time);
    return undecided_set_message(!search.result.solutions.empty(), is_drawn_alone, kMovingStarts);
  }
  if (search.lost_images > 0) return closure_message(image_lost);
  if (search.unproved > 0) return undecided_closures_message(search.unproved);
  if (search.rootless > 0) return closure_message(roots_lost);
  return closure_message(search.unpolished > 0 ? not_confirmed : paths_failed);
}

/// A fit that takes what misses by so much: its first digit, and one more.
double fit_beyond(double misfit) {
  const double digit = std::pow(10, std::floor(std::log10(misfit)));
  return digit * (std::floor(misfit / digit) + 1);
}

/// By how much the nearest pose misses, and what would take it; empty where none is near.
std::string misfit_text(const ClosureSearch& search) {
  // Of the mechanism's length: lengths typed with three digits miss by less, and what misses by
  // more is another mechanism.
  constexpr double kRounded = 1e-2;
  const std::optional<double>& misfit = search.result.least_misfit;
  if (!misfit || search.result.counts.fitted > 0) return "";
  std::optional<double> fit;
  if (!(*misfit > kRounded * search.phi.length())) fit = fit_beyond(*misfit);
  return nearest_pose_clause(*misfit, search.result.misses_most, search.mechanism.units.length,
                             fit);
}

/// Poses beside the closures that miss by rounding only, and what would take them.
std::string near_text(const ClosureSearch& search) {
  const auto& near = search.near_closures;
  if (near.empty() || search.mechanism.fit) return "";
  double most = 0;
  for (const Closure& pose : near) most = std::max(most, pose.misfit);
  return near_poses_clause(near.size(), most, search.mechanism.units.length, fit_beyond(most));
}

/// What fit leaves of the closure that it leaves most freedom.
std::string play_text(const ClosureSearch& search) {
  // Beside it a user would take the pose for another one.
  constexpr double kNotable = 0.1;
  const auto& closures = search.result.closures;
  const auto freest = std::max_element(closures.begin(), closures.end(), [](auto& a, auto& b) {
    return a.play.value_or(0) < b.play.value_or(0);
  });
  if (freest == closures.end() || freest->play.value_or(0) < kNotable) return "";
  return play_clause(freest->id, *freest->play);
}

std::string verdict(const ClosureSearch& search) {
  using enum ClosureVerdict;
  const Mechanism& mechanism = search.mechanism;
  const ClosureCounts& counts = search.result.counts;
  if (!search.result.complete) return shortfall(search);
  if (search.result.moves) {
    return closure_message(mechanism.drivers.empty() ? moves_without_driver
                                                     : moves_with_drivers_held);
  }
  if (counts.fitted > 0) {
    return fitted_closures_message(counts.fitted, mechanism.fit.value_or(0),
                                   mechanism.units.length);
  }
  if (search.result.fitted_beyond_limits > 0) return closure_message(decided);
  if (search.part_is_complex) return closure_message(partly_complex);
  if (counts.complex == 0) return closure_message(no_closure) + misfit_text(search);
  if (counts.real == 0) return complex_closures_message(counts.complex) + misfit_text(search);
  return closure_message(decided) + near_text(search);
}

void conclude(ClosureSearch& search) {
  if (search.lost_images + search.unproved + search.unpolished + search.rootless > 0) {
    search.result.complete = false;
  }
  auto& completeness = search.result.completeness;
  if (completeness && !search.result.complete) completeness = RootCompleteness::open;
  search.result.message = verdict(search) + play_text(search);
  if (search.result.counts.fitted > 0) return;
  for (const std::string& clause : search.formulation.contradictions) {
    search.result.message += "; " + clause;
  }
}

void search_whole(ClosureSearch& search) {
  search.result = described(search);
  if (!solve_apart(search)) {
    find_all(search);
    if (may_find_more(search)) find_all_combined(search);
    mark_drawn(search);
    measure_play(search);
  }
  conclude(search);
}

/// Whether the mechanism as typed may have another answer than what was told. Where equations are
/// redundant, or a fit is given, typed digits stand for a mechanism that closes.
bool may_differ_as_typed(const ClosureSearch& search) {
  const System& f = search.formulation.system;
  const bool is_plain = f.polynomials.size() == f.variables.size() && !search.mechanism.fit;
  return is_plain && !search.stop && (search.result.moves || !search.result.complete);
}

/// Whether closures form a set whatever the drivers' angles are. One that is there where angles are
/// rounded, and not at others, may be the rounding's.
bool moves_at_other_angles(const ClosureSearch& search) {
  constexpr double kOther = 0.01;  // rad: far beyond rounding, and what closes closes there too
  Mechanism other = search.mechanism;
  double step = kOther;
  for (Driver& driver : other.drivers) {
    if (driver.kind != DriverKind::angle) continue;
    driver.law = Parabola{driver_state(driver.law, search.options.time).value + step, 0, 0};
    step *= std::numbers::phi;  // no relation between them
  }
  ClosureSearch there(other, search.tracker, search.options, search.stop);
  search_whole(there);
  return there.result.moves.has_value();
}

/// A set, or nothing decided, may be what terms that were taken for rounding leave, or roots that
/// were rounded below other blocks, or an angle that was: what was typed is asked again.
void ask_as_typed(ClosureSearch& search) {
  if (!may_differ_as_typed(search)) return;
  std::optional<Formulation> typed = with_typed_terms(search.formulation);
  if (typed || (search.proves_as_typed() && search.result.stages.size() > 1)) {
    ClosureSearch again(search.mechanism, search.tracker, search.options, search.stop,
                        typed ? std::move(*typed) : search.formulation);
    again.is_as_typed = true;
    search_whole(again);
    keep_account(search.result, again.result);
    search.result = std::move(again.result);
  }
  const bool is_told_to_move = search.result.moves && search.result.complete;
  if (!is_told_to_move || !search.formulation.has_rounded_angles || moves_at_other_angles(search)) {
    return;
  }
  search.result.complete = false;
  search.result.message = closure_message(ClosureVerdict::moves_as_rounded);
}

}  // namespace

ClosureResult find_closures(const Mechanism& mechanism, const Tracker& tracker,
                            const ClosureOptions& options, const std::atomic<bool>& stop) {
  require_drivers(mechanism, options.time);
  require_unbroken(validate(options.solve));
  const Stopwatch watch;
  const HeldMechanism held = hold_idle(mechanism);
  ClosureSearch search(held.mechanism, tracker, options, stop);
  search_whole(search);
  ask_as_typed(search);
  ClosureResult result = std::move(search.result);
  result.idle = held.idle;
  add_mobility(Phi(mechanism), mechanism.fit.value_or(0), options.with_mobility, result);
  result.time_s.total = watch.total();
  return result;
}

}  // namespace moivre
