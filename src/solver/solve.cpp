// SPDX-License-Identifier: MIT
// The solve: prepare, track, refine, settle doubts, close the account.
#include "moivre/solver/solve.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <stdexcept>
#include <thread>

#include "coincidence.h"
#include "dimension.h"
#include "facts.h"
#include "ledger.h"
#include "moivre/tracker/double_double_tracker.h"
#include "path_pool.h"
#include "prepare.h"

namespace moivre {
namespace {

// A simple root is known this much better than ends of different paths are apart.
constexpr double kSimpleTolerance = 1e-13;
// On a curve of roots J is singular; as rounded it may still pass for a simple root's, of a condition above this.
constexpr double kDoubtfulCondition = 1e14;
// A singular end is not known better than this; ends nearer than that are one root.
constexpr double kSingularTolerance = 1e-7;
// A singular end known worse than this is not known at all.
constexpr double kWorstAccuracy = 1e-3;
// One on a set of roots may be: it names no root, and where the set crosses itself residuals tell little of the error.
constexpr double kWorstAccuracyOnSet = 3e-2;
// Of a root that is not simple.
constexpr int kLeastMultiplicity = 2;

// More threads than any machine has cores only cost memory.
constexpr int kMostThreads = 1024;

// A thread is worth waking for so many ends to refine.
constexpr std::size_t kEndsOfAThread = 16;

// A root may be larger than the others by the spread of an equation's coefficients. From the first spread on (as log2) a
// path is taken for one to infinity only where x_0 is rounding noise; from the second on the smallest terms are noise too,
// and ends at infinity, at multiple roots and on sets may be those of the system without them.
constexpr double kWideSpread = 20;
constexpr double kHopelessSpread = 36;
constexpr double kNoiseFloor = 1e-12;

// The tracker itself tries first, with one level of care, before a path goes to the fallback.
constexpr int kFallbackCare = 2;

// Followed in double-double until it is this large, and to no regular end, a path is one to infinity.
constexpr double kBeyondRoots = 1e-18;

// So few climb one by one: a step of many lanes takes several times as long as one of a single path.
constexpr std::size_t kFewClimbers = 2;

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// One run of solve(), from the prepared problem to the closed account.
class Run {
 public:
  Run(const System& f, const Tracker& tracker, const SolveOptions& options,
      const std::atomic<bool>& stop)
      : f_(f),
        unit_f_(with_unit_rows(f)),
        tracker_(tracker),
        options_(options),
        endgame_(options.endgame),
        stop_(stop),
        threads_(options.threads > 0 ? options.threads
                                     : static_cast<int>(std::thread::hardware_concurrency())) {
    if (options.precision != Precision::double_precision) {
      fine_tracker_ = make_double_double_tracker();
      fine_own_ = tracker.in_double_double();
    }
  }

  SolveResult run();

 private:
  void describe();
  bool decided_without_tracking();
  void track_all();
  void refine_ends();
  void settle_doubts();
  std::set<std::uint64_t> doubtful_paths(int care);
  void add_paths_of_missing_conjugates(int care, std::set<std::uint64_t>& doubtful);
  void track_again(const std::set<std::uint64_t>& paths, int care);
  void resolve_clusters();
  std::set<std::uint64_t> paths_failed_by(const std::set<Failure>& reasons) const;
  void climb(std::set<std::uint64_t> paths);
  std::set<std::uint64_t> climb(const std::set<std::uint64_t>& paths, const Tracker& tracker);
  Rung rung_of(std::uint64_t path) const;
  void close_account();
  void fail_unsettled();
  Solution solution_of(const std::vector<std::uint64_t>& group, const std::vector<int>& winding);
  bool is_on_set(const Root& root);
  /// Terms that no coordinate tells: only a simple root, proved on the system as given, says something about the system.
  bool hides_terms() const { return prepared_.spread_log2 > kHopelessSpread; }
  Root refined_root(Refiner& refiner, std::uint64_t path, const PathEnd& end) const;
  void take(std::uint64_t path, PathEnd&& end);
  bool falls_back(int care) const { return options_.fallback != nullptr && care >= kFallbackCare; }
  bool is_fine() const { return options_.precision == Precision::double_double; }
  const Tracker& tracker() const {
    if (!is_fine()) return tracker_;
    return fine_own_ ? *fine_own_ : *fine_tracker_;
  }
  PathProblem problem(int care) const {
    return {*prepared_.homotopy, prepared_.start, falls_back(care) ? *options_.fallback : tracker(),
            endgame_};
  }

  const System& f_;
  const System unit_f_;  // the same with unit rows, for all that rounds its coefficients
  const Tracker& tracker_;
  const SolveOptions& options_;
  EndgameOptions endgame_;
  const std::atomic<bool>& stop_;
  int threads_;
  Prepared prepared_;
  std::shared_ptr<const RefinerProgram> refiner_program_;
  Ledger ledger_;
  std::vector<std::pair<std::uint64_t, PathEnd>> ends_;  // finite, to be refined
  std::set<std::uint64_t> retracked_;
  std::set<std::uint64_t> handed_over_;
  std::uint64_t unsettled_conjugates_ = 0;
  bool interrupted_ = false;
  std::unique_ptr<Tracker> fine_tracker_;  // one path at a time; nullptr: no path is to be climbed
  std::unique_ptr<Tracker> fine_own_;      // tracker_ in double-double; nullptr where it has none
  std::map<std::uint64_t, Rung> rungs_;    // of paths that needed more than double
  SolveResult result_;
};

SolveResult Run::run() {
  Stopwatch total;
  Stopwatch watch;
  prepared_ = prepare(f_, options_);
  if (prepared_.spread_log2 > kWideSpread) endgame_.infinity_floor = kNoiseFloor;
  describe();
  result_.time.start = watch.lap();
  if (!decided_without_tracking()) {
    const std::clock_t begin = std::clock();
    track_all();
    result_.time.track_cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    result_.time.track = watch.lap();
    refine_ends();
    settle_doubts();
    close_account();
    result_.time.refine = watch.lap();
  }
  result_.time.total = total.lap();
  return std::move(result_);
}

void Run::describe() {
  result_.seed = options_.seed;
  result_.system = facts_of(f_);
  result_.reduced = facts_of(prepared_.reduction.system);
  result_.start.paths = prepared_.start.paths;
  result_.start.why =
      "the product of the degrees bounds the number of isolated roots; its start "
      "system is solved by De Moivre's theorem";
  result_.tracker = tracker().kind();
  result_.tracker_options = tracker().options_in_force();
  result_.left_out = prepared_.left_out;
  result_.time.threads = threads_;
}

bool Run::decided_without_tracking() {
  refiner_program_ = make_refiner_program(unit_f_, natural_sizes(prepared_));
  result_.complete = true;
  switch (prepared_.reduction.verdict) {
    case Reduction::Verdict::square:
      return false;
    case Reduction::Verdict::solved: {
      // The empty product of degrees is one path, and it stands still.
      result_.start.paths = result_.paths.tracked = result_.paths.finite = 1;
      Refiner refiner(refiner_program_);
      Root root;
      root.point = refiner.refine(restore(prepared_.reduction, Point{}), 0);
      ledger_.enter_root(0, std::move(root));
      result_.solutions.push_back(solution_of({0}, {1}));
      result_.message = "every unknown was eliminated: one root";
      return true;
    }
    case Reduction::Verdict::inconsistent:
      result_.message = "the equations contradict each other: no root";
      return true;
    case Reduction::Verdict::dependent:
    case Reduction::Verdict::underdetermined:
      result_.message =
          "the equations depend on each other: every root lies on a set of positive dimension, "
          "none is isolated";
      return true;
    case Reduction::Verdict::overdetermined:
      throw std::logic_error("a square system became overdetermined");
  }
  return false;
}

void Run::take(std::uint64_t path, PathEnd&& end) {
  result_.work += end.count;
  rungs_.erase(path);
  // Nothing is kept of a path at infinity: memory does not grow with their number.
  if (end.status != PathStatus::at_infinity) {
    if (end.count.work.fine_values > 0) rungs_[path] = Rung::mixed;
    if (is_fine()) rungs_[path] = Rung::double_double;
  }
  switch (end.status) {
    case PathStatus::finite:
      ends_.emplace_back(path, std::move(end));
      return;
    case PathStatus::at_infinity:
      if (hides_terms()) {
        ledger_.enter_failure({path, Failure::precision, end.t});
      } else {
        ledger_.enter_infinity(path);
      }
      return;
    case PathStatus::failed:
      if (end.failure == Failure::cancelled) {
        interrupted_ = true;
      } else {
        ledger_.enter_failure({path, *end.failure, end.t});
      }
      return;
  }
}

void Run::track_all() {
  Progress progress{0, prepared_.start.paths, 0};
  const EndSink sink = [&](std::uint64_t path, PathEnd&& end) {
    ++progress.done;
    if (end.status == PathStatus::finite) ++progress.finite;
    take(path, std::move(end));
    if (options_.progress) options_.progress(progress);
  };
  track_paths(
      problem(0), prepared_.start.paths, [](std::uint64_t k) { return k; }, options_.care, threads_,
      sink, stop_);
  if (progress.done < prepared_.start.paths) interrupted_ = true;
}

Root Run::refined_root(Refiner& refiner, std::uint64_t path, const PathEnd& end) const {
  const Point x = to_original(prepared_, end.x);
  // A relative error of z_0 is one of z / z_0, larger by the size of the affine point.
  const double size = max_norm(end.x) / std::abs(end.x.back());
  const double accuracy = end.accuracy * std::max(1.0, size);
  Root root;
  root.winding = end.winding;
  const bool many_sheets = end.winding.value_or(1) > 1;
  root.point = many_sheets ? refiner.keep(x, accuracy, *end.winding) : refiner.refine(x, accuracy);
  if (!root.point.simple && !many_sheets && rung_of(path) == Rung::double_double) {
    root.point = refiner.refine_fine(x);
  }
  if (root.point.simple && root.point.condition > kDoubtfulCondition) {
    root.on_set = lies_on_positive_dimensional_set(*refiner_program_, root.point.x, options_.seed);
    root.point.simple = !*root.on_set;
  }
  if (!root.point.simple) {
    if (!many_sheets) root.point = refiner.keep(x, accuracy, kLeastMultiplicity);
    root.tolerance = std::max(kSingularTolerance, 10 * root.point.accuracy);
  } else {
    root.tolerance = 4 * root.point.accuracy + kSimpleTolerance;
  }
  return root;
}

void Run::refine_ends() {
  std::sort(ends_.begin(), ends_.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Root> roots(ends_.size());
  const std::size_t chunks =
      std::min(static_cast<std::size_t>(threads_), 1 + ends_.size() / kEndsOfAThread);
  for_each_parallel(chunks, threads_, [&](std::size_t chunk) {
    Refiner refiner(refiner_program_);
    for (std::size_t k = chunk; k < ends_.size(); k += chunks) {
      roots[k] = refined_root(refiner, ends_[k].first, ends_[k].second);
    }
  });
  for (std::size_t k = 0; k < ends_.size(); ++k) {
    const auto& [path, end] = ends_[k];
    const bool singular = roots[k].winding &&
                          (roots[k].point.accuracy <= kWorstAccuracy ||
                           (roots[k].point.accuracy <= kWorstAccuracyOnSet && is_on_set(roots[k])));
    if (roots[k].point.simple) {
      ledger_.enter_root(path, std::move(roots[k]));
    } else if (hides_terms()) {
      ledger_.enter_failure({path, Failure::precision, end.t});
    } else if (singular) {
      ledger_.enter_root(path, std::move(roots[k]));
    } else {
      ledger_.enter_failure({path, Failure::precision, end.t});
    }
  }
  ends_.clear();
}

void Run::settle_doubts() {
  resolve_clusters();
  for (int care = options_.care + 1; care <= options_.maximum_care && !interrupted_; ++care) {
    const std::set<std::uint64_t> doubtful = doubtful_paths(care);
    if (doubtful.empty()) return;
    track_again(doubtful, care);
    if (care == options_.care + 1) climb(paths_failed_by({Failure::precision}));
  }
  if (interrupted_) return;
  std::set<std::uint64_t> last = doubtful_paths(options_.maximum_care + 1);
  // More digits save no steps: the caller's budget stands.
  for (const std::uint64_t path : paths_failed_by({Failure::step_limit})) last.erase(path);
  climb(last);
  if (!interrupted_) fail_unsettled();
}

// Simple roots nearer to each other than double can tell pass for one singular root. One path to each such root is
// followed in double-double: where it finds a regular end, so do the others.
void Run::resolve_clusters() {
  std::map<std::uint64_t, std::vector<std::uint64_t>> clusters;
  std::set<std::uint64_t> first;
  for (const auto& group : ledger_.groups()) {
    const Root& root = ledger_.roots().at(group.front());
    if (group.size() == 1 || root.point.simple || is_on_set(root)) continue;
    first.insert(group.front());
    clusters[group.front()] = group;
  }
  climb(first);
  std::set<std::uint64_t> others;
  for (const auto& [path, group] : clusters) {
    if (rung_of(path) == Rung::double_double) others.insert(group.begin() + 1, group.end());
  }
  climb(others);
}

bool Run::is_on_set(const Root& root) {
  if (!root.on_set) {
    root.on_set = lies_on_positive_dimensional_set(*refiner_program_, root.point.x, options_.seed);
  }
  return *root.on_set;
}

std::set<std::uint64_t> Run::doubtful_paths(int care) {
  std::set<std::uint64_t> doubtful;
  for (const auto& [path, failure] : ledger_.failures()) doubtful.insert(path);
  for (const auto& group : ledger_.groups()) {
    const Root& first = ledger_.roots().at(group.front());
    const bool all_simple = std::all_of(group.begin(), group.end(), [&](std::uint64_t path) {
      return ledger_.roots().at(path).point.simple;
    });
    const bool in_doubt = all_simple
                              ? group.size() > 1
                              : (group.size() == 1 || !cycles(ledger_, group)) && !is_on_set(first);
    if (in_doubt) doubtful.insert(group.begin(), group.end());
  }
  if (is_real(f_)) add_paths_of_missing_conjugates(care, doubtful);
  return doubtful;
}

// The image of a root is a root; one that no path found was lost by the path that leads to it.
void Run::add_paths_of_missing_conjugates(int care, std::set<std::uint64_t>& doubtful) {
  unsettled_conjugates_ = 0;
  Refiner refiner(refiner_program_);
  for (const Point& image : missing_conjugates(ledger_)) {
    const Refined root = refiner.refine(image, 1e-12);
    if (!root.simple) continue;
    ++unsettled_conjugates_;
    const auto path = path_through(problem(care), to_homogeneous(prepared_, root.x), care, stop_);
    if (path) doubtful.insert(*path);
  }
}

void Run::track_again(const std::set<std::uint64_t>& paths, int care) {
  const std::vector<std::uint64_t> list(paths.begin(), paths.end());
  retracked_.insert(list.begin(), list.end());
  if (falls_back(care)) handed_over_.insert(list.begin(), list.end());
  const EndSink sink = [&](std::uint64_t path, PathEnd&& end) {
    if (end.failure == Failure::cancelled) {
      interrupted_ = true;
      return;
    }
    ledger_.strike(path);
    take(path, std::move(end));
  };
  track_paths(
      problem(care), list.size(), [&](std::uint64_t k) { return list[k]; }, care, threads_, sink,
      stop_);
  refine_ends();
}

std::set<std::uint64_t> Run::paths_failed_by(const std::set<Failure>& reasons) const {
  std::set<std::uint64_t> paths;
  for (const auto& [path, failure] : ledger_.failures()) {
    if (reasons.contains(failure.failure)) paths.insert(path);
  }
  return paths;
}

bool has_left_for_infinity(const PathEnd& end) {
  return std::abs(end.x.back()) < kBeyondRoots * max_norm(end.x);
}

// The whole path in double-double. Where that finds no regular end either, the path's entry stays as it is. Several paths
// go together where the tracker can; what it leaves goes one by one.
void Run::climb(std::set<std::uint64_t> paths) {
  if (!fine_tracker_) return;
  if (fine_own_ && paths.size() > kFewClimbers) paths = climb(paths, *fine_own_);
  climb(paths, *fine_tracker_);
}

/// Returns the paths that came to no verdict.
std::set<std::uint64_t> Run::climb(const std::set<std::uint64_t>& paths, const Tracker& tracker) {
  std::set<std::uint64_t> left;
  if (paths.empty() || interrupted_) return left;
  const PathProblem fine{*prepared_.homotopy, prepared_.start, tracker, endgame_,
                         Endgame::Manner::straight};
  const std::vector<std::uint64_t> list(paths.begin(), paths.end());
  retracked_.insert(list.begin(), list.end());
  const EndSink sink = [&](std::uint64_t path, PathEnd&& end) {
    if (end.failure == Failure::cancelled) {
      interrupted_ = true;
      return;
    }
    if (end.failure == Failure::step_too_small && has_left_for_infinity(end)) {
      end.status = PathStatus::at_infinity;
      end.failure.reset();
    }
    if (end.status == PathStatus::failed) {
      result_.work += end.count;
      left.insert(path);
      return;
    }
    ledger_.strike(path);
    take(path, std::move(end));
    rungs_[path] = Rung::double_double;
  };
  track_paths(
      fine, list.size(), [&](std::uint64_t k) { return list[k]; }, 0, threads_, sink, stop_);
  refine_ends();
  return left;
}

Rung Run::rung_of(std::uint64_t path) const {
  const auto found = rungs_.find(path);
  return found == rungs_.end() ? Rung::double_precision : found->second;
}

// Two paths cannot end at one simple root: all but the first are lost. And one path alone cannot end
// at an isolated root that is not simple: what it ends at is no root that this precision can show.
void Run::fail_unsettled() {
  for (const auto& group : ledger_.groups()) {
    const Root& first = ledger_.roots().at(group.front());
    if (group.size() == 1 && !first.point.simple && !is_on_set(first)) {
      ledger_.strike(group.front());
      ledger_.enter_failure({group.front(), Failure::precision, 1});
      continue;
    }
    for (std::size_t k = 1; k < group.size(); ++k) {
      if (!ledger_.roots().at(group[k]).point.simple) continue;
      ledger_.strike(group[k]);
      ledger_.enter_failure({group[k], Failure::jumped, 1});
    }
  }
  unsettled_conjugates_ = 0;
  if (is_real(f_)) {
    std::set<std::uint64_t> lost;
    add_paths_of_missing_conjugates(options_.maximum_care, lost);
    for (const std::uint64_t path : lost) {
      ledger_.strike(path);
      ledger_.enter_failure({path, Failure::jumped, 1});
    }
  }
}

Solution Run::solution_of(const std::vector<std::uint64_t>& group,
                          const std::vector<int>& winding) {
  const auto best = std::min_element(group.begin(), group.end(), [&](auto a, auto b) {
    return ledger_.roots().at(a).point.accuracy < ledger_.roots().at(b).point.accuracy;
  });
  const Refined& point = ledger_.roots().at(*best).point;
  Solution solution;
  solution.path = group.front();
  solution.x = point.x;
  solution.real = is_real(point);
  solution.singular = !point.simple;
  solution.multiplicity = group.size();
  solution.winding = winding;
  solution.residual = point.residual;
  solution.accuracy = point.accuracy;
  solution.condition = point.condition;
  for (const std::uint64_t path : group) {
    solution.precision = std::max(solution.precision, rung_of(path));
  }
  if (solution.real && is_real(f_)) {
    for (Complex& xi : solution.x) xi.imag(0);
  }
  return solution;
}

void Run::close_account() {
  PathCounts& counts = result_.paths;
  for (const auto& group : ledger_.groups()) {
    counts.finite += group.size();
    const Root& first = ledger_.roots().at(group.front());
    if (!first.point.simple && is_on_set(first)) {
      counts.on_positive_dimensional += group.size();
      continue;
    }
    const auto whole = cycles(ledger_, group);
    result_.solutions.push_back(
        solution_of(group, whole.value_or(std::vector<int>(group.size(), 1))));
  }
  std::sort(result_.solutions.begin(), result_.solutions.end(),
            [](const Solution& a, const Solution& b) { return a.path < b.path; });
  for (const auto& [path, failure] : ledger_.failures()) result_.failures.push_back(failure);
  counts.failed = result_.failures.size();
  counts.at_infinity = ledger_.at_infinity();
  counts.tracked = ledger_.tracked();
  counts.retracked = retracked_.size();
  counts.handed_over = handed_over_.size();
  for (const auto& [path, rung] : rungs_) {
    ++(rung == Rung::mixed ? counts.mixed : counts.double_double);
  }
  if (is_fine()) counts.double_double = counts.tracked;
  result_.complete = !interrupted_ && counts.failed == 0 && unsettled_conjugates_ == 0;
  result_.message = interrupted_        ? "interrupted: what is finished is reported"
                    : result_.complete  ? "every path was decided"
                    : counts.failed > 0 ? "some paths failed"
                                        : "a root's conjugate is missing among the roots";
}

}  // namespace

std::string to_string(Rung rung) {
  switch (rung) {
    case Rung::double_precision:
      return "double";
    case Rung::mixed:
      return "mixed";
    case Rung::double_double:
      return "double-double";
  }
  return "";
}

PathCounts& PathCounts::operator+=(const PathCounts& other) {
  tracked += other.tracked;
  finite += other.finite;
  at_infinity += other.at_infinity;
  failed += other.failed;
  on_positive_dimensional += other.on_positive_dimensional;
  retracked += other.retracked;
  handed_over += other.handed_over;
  mixed += other.mixed;
  double_double += other.double_double;
  return *this;
}

std::vector<std::string> validate(const SolveOptions& options) {
  std::vector<std::string> broken;
  if (options.threads < 0 || options.threads > kMostThreads) {
    broken.push_back("threads must lie between 0 (all cores) and " + std::to_string(kMostThreads));
  }
  if (options.care < 0) broken.push_back("care must be 0 or more");
  if (options.maximum_care < 0) broken.push_back("maximum_care must be 0 or more");
  if (options.endgame.samples < 4 || options.endgame.samples % 2 != 0) {
    broken.push_back("endgame.samples must be even and at least 4");
  }
  if (options.endgame.maximum_winding < 1) {
    broken.push_back("endgame.maximum_winding must be at least 1");
  }
  return broken;
}

SolveResult solve(const System& f, const Tracker& tracker, const SolveOptions& options,
                  const std::atomic<bool>& stop) {
  std::string message;
  for (const std::string& sentence : validate(options)) {
    message += (message.empty() ? "" : "; ") + sentence;
  }
  if (!message.empty()) throw std::invalid_argument(message);
  require_square(f);
  return Run(f, tracker, options, stop).run();
}

}  // namespace moivre
