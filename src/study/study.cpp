// SPDX-License-Identifier: MIT
// The study of one system: careful runs for the reference, then every setting, timed and walked.
#include "moivre/study/study.h"

#include <algorithm>
#include <cmath>

#include "moivre/numeric/invalid_input.h"
#include "moivre/solver/drift.h"
#include "moivre/study/cpu_time.h"
#include "plain_newton.h"
#include "reference.h"

namespace moivre {
namespace {

// More seeds than this prove nothing more, and take hours.
constexpr int kMostSeeds = 1000;

void keep_largest(std::optional<double>& largest, double value) {
  largest = std::max(largest.value_or(0), value);
}

/// The counter in `count` whose value over the seeds is the median.
StepCount median_work(std::vector<StepCount> counts) {
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>((counts.size() - 1) / 2);
  std::nth_element(counts.begin(), middle, counts.end(), [](const auto& a, const auto& b) {
    return a.work.factorizations < b.work.factorizations;
  });
  return *middle;
}

/// One study, from the careful runs to the last setting.
class Study {
 public:
  Study(const StudySubject& subject, const StudyOptions& options, const std::atomic<bool>& stop)
      : subject_(subject), f_(subject.system), options_(options), stop_(stop), plain_(f_) {}

  StudyResult run(const std::vector<StudySetting>& settings, const Tracker& reference_tracker,
                  const Tracker* witness);

 private:
  bool is_stopped() const { return stop_.load(std::memory_order_relaxed); }
  SolveOptions solve_options(std::size_t seed) const;
  void find_reference(const Tracker& reference_tracker, const Tracker* witness);
  StudyRow study(const StudySetting& setting);
  enum class Repairs { none, all };
  /// Fills one outcome from all seeds. True when nothing was left for the solver to repair.
  bool measure(const Tracker& tracker, Repairs repairs, StudyOutcome& outcome);
  void compare(const SolveResult& run, StudyOutcome& outcome) const;
  std::optional<StudyWalk> walk(const Tracker& tracker);
  void take_end(const PathDrift& drift, std::size_t own, StudyWalk& walk) const;
  std::vector<std::uint64_t> walked_paths(std::size_t seed) const;
  void tell(const std::string& now, std::uint64_t done, std::uint64_t total) const {
    if (options_.progress) options_.progress({done, total, now});
  }

  const StudySubject& subject_;
  const System& f_;
  const StudyOptions& options_;
  const std::atomic<bool>& stop_;
  PlainNewton plain_;
  ReferenceRoots reference_;
  StudyResult result_;
};

SolveOptions Study::solve_options(std::size_t seed) const {
  SolveOptions options;
  options.second_start = false;  // every figure is one of the start that is named
  options.seed = options_.seed + seed;
  options.threads = 1;
  options.certify = false;  // trackers are measured
  return options;
}

StudyResult Study::run(const std::vector<StudySetting>& settings, const Tracker& reference_tracker,
                       const Tracker* witness) {
  const double begin = cpu_seconds();
  result_.seed = options_.seed;
  result_.seeds = options_.seeds;
  find_reference(reference_tracker, witness);
  if (result_.reference.roots == 0 && !is_stopped()) {
    result_.remarks.push_back("there is no isolated root: only times can be compared");
  }
  for (std::size_t k = 0; k < settings.size() && !is_stopped(); ++k) {
    tell(settings[k].curve, k, settings.size());
    StudyRow row = study(settings[k]);
    if (!is_stopped()) result_.rows.push_back(std::move(row));
  }
  result_.complete = !is_stopped();
  result_.message = result_.complete ? "every setting was run"
                                     : "interrupted: the settings that are finished are reported";
  result_.cpu_s = cpu_seconds() - begin;
  return std::move(result_);
}

void Study::find_reference(const Tracker& reference_tracker, const Tracker* witness) {
  for (std::size_t seed = 0; seed < static_cast<std::size_t>(options_.seeds); ++seed) {
    for (const Tracker* tracker : {&reference_tracker, witness}) {
      if (tracker == nullptr || is_stopped()) continue;
      tell("reference", seed, static_cast<std::uint64_t>(options_.seeds));
      const SolveResult run = subject_.solve(*tracker, solve_options(seed), stop_);
      result_.system = run.system;
      result_.reduced = run.reduced;
      result_.paths = run.start.paths;
      reference_.enter(run, seed);
    }
  }
  const std::size_t trackers = witness == nullptr ? 1 : 2;
  reference_.close(f_, options_.known_roots, {trackers, static_cast<std::size_t>(options_.seeds)});
  result_.reference = reference_.facts();
}

StudyRow Study::study(const StudySetting& setting) {
  StudyRow row;
  row.curve = setting.curve;
  row.tolerance = setting.tolerance;
  row.tracker = setting.tracker->kind();
  row.tracker_options = setting.tracker->options_in_force();
  const bool needs_no_repair = measure(*setting.tracker, Repairs::none, row.own);
  row.repaired = row.own;
  if (!needs_no_repair) {
    row.repaired = {};
    measure(*setting.tracker, Repairs::all, row.repaired);
  }
  row.walk = walk(*setting.tracker);
  return row;
}

bool Study::measure(const Tracker& tracker, Repairs repairs, StudyOutcome& outcome) {
  std::vector<double> seconds;
  std::vector<StepCount> work;
  bool needs_no_repair = true;
  for (std::size_t seed = 0; seed < static_cast<std::size_t>(options_.seeds); ++seed) {
    if (is_stopped()) break;
    SolveOptions options = solve_options(seed);
    if (repairs == Repairs::none) {
      options.maximum_tolerance_level = 0;
      options.precision = Precision::double_precision;
    }
    SolveResult run;
    const auto times = time_runs([&] { run = subject_.solve(tracker, options, stop_); });
    seconds.insert(seconds.end(), times.begin(), times.end());
    work.push_back(run.work);
    compare(run, outcome);
    needs_no_repair = needs_no_repair && run.complete &&
                      std::none_of(run.solutions.begin(), run.solutions.end(),
                                   [](const Solution& s) { return s.multiplicity > 1; });
  }
  if (seconds.empty()) return false;
  outcome.cpu_s = spread_of(std::move(seconds));
  outcome.work = median_work(std::move(work));
  return needs_no_repair;
}

void Study::compare(const SolveResult& run, StudyOutcome& outcome) const {
  std::vector<bool> found(reference_.roots().size());
  std::uint64_t strangers = 0;
  for (const Solution& solution : run.solutions) {
    const auto root = reference_.match(solution.x, solution.accuracy);
    if (!root) {
      ++strangers;
      continue;
    }
    found[*root] = true;
    if (!reference_.roots()[*root].nearest.empty()) {
      keep_largest(outcome.error, reference_.error(*root, solution.x));
      keep_largest(outcome.plain_error, reference_.error(*root, plain_.polish(solution.x)));
    }
  }
  const auto lost = static_cast<std::uint64_t>(std::count(found.begin(), found.end(), false));
  outcome.lost = std::max(outcome.lost, lost);
  outcome.strangers = std::max(outcome.strangers, strangers);
  outcome.failed = std::max(outcome.failed, run.paths.failed);
  outcome.retracked = std::max(outcome.retracked, run.paths.retracked);
}

std::vector<std::uint64_t> Study::walked_paths(std::size_t seed) const {
  const auto& owners = reference_.owners(seed);
  const std::size_t count =
      std::min(owners.size(), static_cast<std::size_t>(options_.walked_paths));
  std::vector<std::uint64_t> all;
  for (const auto& [path, root] : owners) all.push_back(path);
  std::vector<std::uint64_t> chosen;
  for (std::size_t k = 0; k < count; ++k) chosen.push_back(all[k * all.size() / count]);
  return chosen;
}

std::optional<StudyWalk> Study::walk(const Tracker& tracker) {
  if (!subject_.has_paths || result_.reduced.variables.empty()) return std::nullopt;
  std::optional<StudyWalk> whole;
  for (std::size_t seed = 0; seed < static_cast<std::size_t>(options_.seeds); ++seed) {
    const std::vector<std::uint64_t> paths = walked_paths(seed);
    if (paths.empty() || is_stopped()) continue;
    StudyWalk walk = whole.value_or(StudyWalk{});
    walk.paths = std::max<std::uint64_t>(walk.paths, paths.size());
    const std::uint64_t jumped_before = walk.jumped;
    const std::uint64_t stuck_before = walk.stuck;
    walk.jumped = walk.stuck = 0;
    for (const PathDrift& drift : measure_drift(f_, tracker, solve_options(seed), paths, stop_)) {
      take_end(drift, reference_.owners(seed).at(drift.path), walk);
    }
    walk.jumped = std::max(walk.jumped, jumped_before);
    walk.stuck = std::max(walk.stuck, stuck_before);
    whole = walk;
  }
  return whole;
}

void Study::take_end(const PathDrift& drift, std::size_t own, StudyWalk& walk) const {
  walk.drift_before = std::max(walk.drift_before, drift.before);
  walk.drift_after = std::max(walk.drift_after, drift.after);
  if (!drift.arrived) {
    ++walk.stuck;
  } else if (reference_.nearest(drift.end) != own) {
    ++walk.jumped;
  } else if (!reference_.roots()[own].nearest.empty()) {
    keep_largest(walk.end_error, reference_.error(own, drift.end));
  }
}

}  // namespace

Spread spread_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values.front(), values[(values.size() - 1) / 2], values.back()};
}

std::vector<std::string> validate(const StudyOptions& options) {
  std::vector<std::string> broken;
  if (options.seeds < 1 || options.seeds > kMostSeeds) {
    broken.push_back("seeds must lie between 1 and " + std::to_string(kMostSeeds));
  }
  if (options.walked_paths < 1) broken.push_back("walked_paths must be at least 1");
  return broken;
}

StudyResult study_subject(const StudySubject& subject, const std::vector<StudySetting>& settings,
                          const Tracker& reference_tracker, const Tracker* witness,
                          const StudyOptions& options, const std::atomic<bool>& stop) {
  require_unbroken(validate(options));
  return Study(subject, options, stop).run(settings, reference_tracker, witness);
}

StudyResult study_system(const System& f, const std::vector<StudySetting>& settings,
                         const Tracker& reference_tracker, const Tracker* witness,
                         const StudyOptions& options, const std::atomic<bool>& stop) {
  const StudySubject subject{
      f, true, [&](const Tracker& tracker, const SolveOptions& solve_options, const auto& halt) {
        return solve(f, tracker, solve_options, halt);
      }};
  return study_subject(subject, settings, reference_tracker, witness, options, stop);
}

}  // namespace moivre
