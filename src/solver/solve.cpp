// SPDX-License-Identifier: MIT
// The solve: prepare, track, refine, settle what is open, close the account.
#include "moivre/solver/solve.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <new>
#include <stdexcept>

#include "account.h"
#include "certificates.h"
#include "denominators.h"
#include "ends.h"
#include "facts.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/polynomial/patches.h"
#include "moivre/solver/cross_check.h"
#include "multiplicities.h"
#include "nudged.h"
#include "settle.h"
#include "sheets.h"
#include "solver_sentences.h"
#include "squared.h"
#include "tracking.h"

namespace moivre {
namespace {

// Starts of more paths are not followed by another one.
constexpr std::uint64_t kMostPathsTwice = 10'000;

/// All that is known before any path is followed.
SolveResult described(const Setting& setting) {
  SolveResult result;
  result.seed = setting.options.seed;
  result.system = facts_of(setting.f);
  result.reduced = facts_of(setting.prepared.reduction.system);
  result.reduced.isotropic_pairs = setting.prepared.reduction.isotropic.size();
  result.start = setting.prepared.start;
  result.tracker = setting.tracker().kind();
  result.tracker_options = setting.tracker().options_in_force();
  result.left_out = setting.prepared.left_out;
  if (!proves_beyond_double()) {
    result.left_out.push_back(certificates_not_built_left_out());
  }
  result.time.threads = setting.threads;
  return result;
}

/// Elimination is exact, and its one root is regular: the ball may be as large as one likes.
/// nullptr where there are no coordinates, or one is beyond double.
std::shared_ptr<const Certificate> proof_of_value(const std::vector<Coefficient>& x) {
  // Of the distance from a number to the double next to it, both parts of it.
  constexpr double kRoundedUp = 1 + 0x1p-40;
  constexpr double kLeastRadius = 0x1p-1000;
  if (x.empty()) return nullptr;
  auto proof = std::make_shared<Certificate>();
  proof->verdict = Verdict::certified;
  proof->reality = Reality::real;
  proof->bits = kDoubleBits;
  std::vector<double> radii, errors;
  for (const Coefficient& xj : x) {
    const Complex middle = to_complex(xj);
    if (!std::isfinite(middle.real()) || !std::isfinite(middle.imag())) return nullptr;
    const Coefficient rest = xj - Coefficient{Rational(middle.real()), Rational(middle.imag())};
    const Complex beyond = to_complex(rest);
    const double error = kRoundedUp * (std::abs(beyond.real()) + std::abs(beyond.imag()));
    const bool is_double = rest.re.is_zero() && rest.im.is_zero();
    proof->midpoint.push_back(middle);
    errors.push_back(is_double ? 0 : error + kLeastRadius / 4);
    radii.push_back(std::max({2 * errors.back(), 0x1p-40 * std::abs(middle), kLeastRadius}));
    if (!xj.im.is_zero()) proof->reality = Reality::not_real;
  }
  proof->sizes.assign(radii, errors);
  return proof;
}

/// The root that elimination has found.
Solution eliminated_root(const Setting& setting) {
  Refiner refiner(setting.refiner_program);
  Root root;
  const Reduction& reduction = setting.prepared.reduction;
  const Point x = restore(reduction, Point{});
  root.certificate = proof_of_value(
      restore(reduction, std::vector<Coefficient>(), [](const Coefficient& c) { return c; }));
  root.point = root.certificate ? refiner.take(*root.certificate) : refiner.keep(x, 0, 1);
  root.point.simple = root.certificate || x.empty();
  Run run(setting);
  run.table.enter_root(0, std::move(root));
  const std::uint64_t path = 0;
  return solution_of(run, PathGroups::Group(&path, 1), {1});
}

/// Elimination is exact: so many roots there are.
void tell_eliminated(std::uint64_t roots, SolveResult& result) {
  result.completeness = RootCompleteness::open;
  const bool all_certified =
      std::all_of(result.solutions.begin(), result.solutions.end(),
                  [](const Solution& root) { return root.certified == true; });
  if (!all_certified) return;
  result.completeness = RootCompleteness::proved;
  result.bound = MetBound{BoundKind::elimination, roots};
}

void enter_eliminated(Solution&& root, SolveResult& result) {
  if (!std::isfinite(max_norm(root.x))) {
    result.paths.failed = 1;
    result.failures.push_back({0, Failure::precision, 1});
    put_in_doubt(result, solve_message(SolveVerdict::eliminated_beyond_double));
    return;
  }
  result.paths.finite = 1;
  result.solutions.push_back(std::move(root));
  result.message = solve_message(SolveVerdict::eliminated);
  tell_eliminated(1, result);
}

/// A record of each path is kept in any case.
void require_memory(const Setting& setting) {
  const std::uint64_t memory = setting.options.memory;
  const std::uint64_t paths = setting.prepared.start.paths;
  if (memory == 0 || paths <= memory / sizeof(PathRecord)) return;
  throw std::invalid_argument(paths_beyond_memory(
      paths, static_cast<double>(paths) * sizeof(PathRecord), static_cast<double>(memory)));
}

/// False where paths have to be followed.
bool decided_without_tracking(const Setting& setting, SolveResult& result) {
  if (setting.prepared.interrupted) {
    result.message = solve_message(SolveVerdict::interrupted_before_tracking);
    return true;
  }
  result.complete = true;
  switch (setting.prepared.reduction.verdict) {
    case Reduction::Verdict::square:
      return false;
    case Reduction::Verdict::solved:
      // The empty product of degrees is one path, and it stands still.
      result.start.paths = result.paths.tracked = 1;
      enter_eliminated(eliminated_root(setting), result);
      return true;
    case Reduction::Verdict::inconsistent:
      result.message = solve_message(SolveVerdict::contradictory);
      tell_eliminated(0, result);
      return true;
    case Reduction::Verdict::dependent:
    case Reduction::Verdict::underdetermined:
      result.message = solve_message(SolveVerdict::dependent);
      tell_eliminated(0, result);
      return true;
    case Reduction::Verdict::overdetermined:
      throw std::logic_error("a square system became overdetermined");
  }
  return false;
}

/// Where it is to stop, or memory runs out, the run ends with what is entered.
void as_far_as_possible(Run& run, const std::function<void()>& steps) {
  if (run.interrupted) return;
  try {
    steps();
  } catch (const Interrupted&) {
    run.interrupted = true;
  } catch (const std::bad_alloc&) {
    run.interrupted = run.out_of_memory = true;
  }
}

/// A stop may come while the books are closed.
SolveResult closed(Run& run, const SolveResult& described) {
  try {
    SolveResult result = described;
    close_account(run, result);
    return result;
  } catch (const Interrupted&) {
    run.interrupted = true;
  }
  SolveResult result = described;
  close_account(run, result);
  return result;
}

SolveResult solve_in(const Setting& setting, Stopwatch& watch) {
  SolveResult result = described(setting);
  result.time.start = watch.lap();
  if (!decided_without_tracking(setting, result)) {
    require_memory(setting);
    Run run(setting);
    const std::clock_t begin = std::clock();
    as_far_as_possible(run, [&] { track_to_ends(run); });
    result.time.track_cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    result.time.track = watch.lap();
    as_far_as_possible(run, [&] {
      settle(run);
      count_ends(run);
    });
    if (setting.stop) run.interrupted = true;
    result = closed(run, result);
    result.time.refine = watch.lap();
  }
  result.time.total = watch.total();
  return result;
}

SolveResult solve_square(const System& f, const Tracker& tracker, const SolveOptions& options,
                         const std::atomic<bool>& stop) {
  Stopwatch watch;
  return solve_in(Setting(f, tracker, options, stop), watch);
}

/// With the fewest paths, and each in units of its own: where another start leaves something open
/// it gets the last word.
SolveResult solve_again(const System& f, const Tracker& tracker, SolveOptions options,
                        const std::atomic<bool>& stop, SolveResult&& first) {
  options.start = StartKind::polyhedral;
  SolveResult second = solve_square(f, tracker, options, stop);
  if (!second.complete) {
    first.time.total += second.time.total;
    return std::move(first);
  }
  std::erase_if(first.solutions, [](const Solution& root) { return root.certified != true; });
  if (compare(second, first).missed > 0) {
    put_in_doubt(second, certified_root_of_start_missing(first.start.source));
  }
  second.left_out.push_back(failed_start_left_out(first.start.source, first.paths));
  second.time.start += first.time.total;
  second.time.total += first.time.total;
  return second;
}

SolveResult solve_by_starts(const System& f, const Tracker& tracker, const SolveOptions& options,
                            const std::atomic<bool>& stop) {
  SolveResult result = solve_square(f, tracker, options, stop);
  const bool is_last =
      result.complete || stop || !options.second_start || options.start != StartKind::automatic ||
      result.start.source == StartSource::polyhedral || result.start.paths > kMostPathsTwice;
  if (is_last) return result;
  return solve_again(f, tracker, options, stop, std::move(result));
}

void leave_out_certificates(SolveResult& result) {
  for (Solution& root : result.solutions) root.certified.reset();
  result.completeness.reset();
  result.bound.reset();
}

SolveResult solve_any(const System& f, const Tracker& tracker, const SolveOptions& options,
                      const std::atomic<bool>& stop) {
  if (is_square(f)) {
    const PowerFree bases = power_free(f);
    SolveResult result = solve_by_starts(bases.system, tracker, options, stop);
    if (bases.sheets > 1) take_back_powers(f, bases, result);
    return result;
  }
  SolveResult result = solve_by_starts(squared(f, options), tracker, options, stop);
  take_back(f, options, result);
  return result;
}

void require_usable(const System& f, const SolveOptions& options) {
  std::vector<std::string> broken = broken_rules(f);
  for (std::string& rule : validate(options)) broken.push_back(std::move(rule));
  require_unbroken(broken);
}

void require_square_start(const System& f) {
  if (is_square(f)) return;
  throw InvalidInput("a given start needs as many equations as unknowns, got " +
                     std::to_string(f.polynomials.size()) + " in " +
                     std::to_string(f.variables.size()) + " without homogeneous groups");
}

/// What F itself says beside the roots, and what of them is no root of the text or not asked for.
SolveResult told(const System& f, const SolveOptions& options, SolveResult result) {
  result.planes = coordinate_planes(f);
  drop_on_denominators(f, result);
  if (!options.certify) leave_out_certificates(result);
  return result;
}

}  // namespace

SolveResult solve(const System& f, const Tracker& tracker, const SolveOptions& options,
                  const std::atomic<bool>& stop) {
  require_usable(f, options);
  SolveResult result = told(f, options, solve_any(f, tracker, options, stop));
  if (f.nudged.empty()) return result;
  System nudged = f;
  nudged.polynomials = f.nudged;
  SolveOptions once_more = options;
  once_more.observations = nullptr;
  once_more.progress = {};
  keep_what_rounding_leaves(told(nudged, once_more, solve_any(nudged, tracker, once_more, stop)),
                            result);
  return result;
}

SolveResult solve_from(const System& f, GivenStart start, const Tracker& tracker,
                       const SolveOptions& options, const std::atomic<bool>& stop) {
  require_usable(f, options);
  require_square_start(f);
  Stopwatch watch;
  return told(
      f, options,
      solve_in(Setting(f, prepare_given(f, std::move(start)), tracker, options, stop), watch));
}

}  // namespace moivre
