// SPDX-License-Identifier: MIT
// The closing of the books: solutions from groups of ends, counts, and the verdict.
#include "account.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <stdexcept>

#include "certificates.h"
#include "coincidence.h"
#include "completeness.h"
#include "judge.h"
#include "moivre/certify/distinct.h"
#include "moivre/expression/counted.h"
#include "solver_sentences.h"

namespace moivre {
namespace {

// A singular root may be the mean of near ones. Where three of them are together and one apart,
// that one is 2.3 times as far away as the m-th root of the residual says, which is what the
// accuracy comes from; and circles have little margin.
constexpr double kSingularMargin = 4;

// Some five megabytes and more.
constexpr std::size_t kRootsBetweenPages = 1 << 13;

constexpr std::uint64_t PathCounts::*kCounts[]{&PathCounts::tracked,
                                               &PathCounts::finite,
                                               &PathCounts::at_infinity,
                                               &PathCounts::failed,
                                               &PathCounts::not_needed,
                                               &PathCounts::by_count,
                                               &PathCounts::on_positive_dimensional,
                                               &PathCounts::retracked,
                                               &PathCounts::handed_over,
                                               &PathCounts::mixed,
                                               &PathCounts::double_double,
                                               &PathCounts::multiprecision};

/// Of the cycles of a group; none where its multiplicity was counted, not seen.
std::vector<int> windings(const Run& run, const JudgedRoot& root) {
  const auto& [group, ground] = root;
  if (ground == Ground::exact && !run.table.roots().at(group.front()).winding) return {};
  return cycles(run.table, group).value_or(std::vector<int>(group.size(), 1));
}

/// Which solution each path of the table leads to; solutions are in the order of their paths.
void enter_places(const JudgedRoots& roots, SolveResult& result) {
  const auto begin = result.solutions.begin();
  for (const auto& [group, ground] : roots) {
    const auto root =
        std::lower_bound(begin, result.solutions.end(), group.front(),
                         [](const Solution& a, std::uint64_t path) { return a.path < path; });
    if (root == result.solutions.end() || root->path != group.front()) continue;
    for (const std::uint64_t path : group) {
      result.ledger[path].solution = static_cast<std::uint32_t>(root - begin);
    }
  }
}

/// What a run comes to in the end: the roots, what has failed, and the paths of which it was not
/// found out what they end at.
struct Outcome {
  JudgedRoots roots;
  std::vector<FailedPath> failures;
  std::vector<std::uint64_t> open;
};

/// What is open at the end has failed.
Outcome outcome_of(const Run& run) {
  JudgedEnds judged = judge(run);
  Outcome outcome{std::move(judged.roots), {}, {}};
  for (const auto& [path, question] : judged.open) {
    outcome.failures.push_back(told_as_failed(run, path, question));
  }
  return outcome;
}

/// Of simple roots those that are proved to be different; nothing is known of the others.
void enter_simple_ones(const Run& run, PathGroups::Group group, Outcome& outcome) {
  std::vector<const Certificate*> taken;
  for (const std::uint64_t path : group) {
    const Certificate* proof = run.table.roots().at(path).certificate.get();
    const bool is_new = proof != nullptr && std::all_of(taken.begin(), taken.end(), [&](auto* one) {
                          return relation(*one, *proof) == Relation::distinct;
                        });
    if (is_new) {
      taken.push_back(proof);
      outcome.roots.add(path, Ground::proved);
    } else {
      outcome.open.push_back(path);
    }
  }
}

/// What an interrupted run has found out without looking further.
Outcome outcome_so_far(const Run& run) {
  Outcome outcome;
  for (const auto& [path, failure] : run.table.failures()) outcome.failures.push_back(failure);
  for (const std::uint64_t path : run.table.refuted()) outcome.open.push_back(path);
  for (const PathGroups::Group group : run.table.groups()) {
    if (const auto ground = known_ground(run, group)) {
      outcome.roots.add(group, *ground);
    } else {
      enter_simple_ones(run, group, outcome);
    }
  }
  return outcome;
}

/// Of paths that are open as if they had not been followed yet.
void enter_verdicts(const Outcome& outcome, SolveResult& result) {
  for (const std::uint64_t path : outcome.open) result.ledger[path].verdict = PathVerdict::open;
  for (const FailedPath& failure : outcome.failures) {
    result.ledger[failure.path].verdict = PathVerdict::failed;
  }
}

/// Paths that come to one point of a set are no roots near to each other.
Solution point_of_set(const Run& run, PathGroups::Group group) {
  Solution point = solution_of(run, group, {});
  point.cluster = false;
  point.radius = 0;
  return point;
}

/// Pages that hold nothing any more are given back to the system: what is freed between other
/// things the C library keeps.
void give_back_pages() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

/// Solutions that keep nothing on the heap until the ends that they are told from are freed:
/// between those it would hold their pages.
class OffTheHeap {
 public:
  void take(Solution&& solution) {
    coordinates_.insert(coordinates_.end(), solution.x.begin(), solution.x.end());
    sizes_.push_back(solution.x.size());
    solution.x = Point();
    is_plain_.push_back(solution.winding == kPlain);
    if (is_plain_.back()) solution.winding = std::vector<int>();
    solutions_.push_back(std::move(solution));
  }

  void give(std::vector<Solution>& to) {
    auto x = coordinates_.begin();
    for (std::size_t k = 0; k < solutions_.size(); ++k) {
      Solution& solution = to.emplace_back(std::move(solutions_[k]));
      const auto end = x + static_cast<std::ptrdiff_t>(sizes_[k]);
      solution.x.assign(x, end);
      x = end;
      if (is_plain_[k]) solution.winding = kPlain;
    }
    coordinates_.clear();
    sizes_.clear();
    is_plain_.clear();
    solutions_.clear();
  }

 private:
  inline static const std::vector<int> kPlain{1};

  std::vector<Complex> coordinates_;
  std::vector<std::size_t> sizes_;
  std::vector<bool> is_plain_;
  std::vector<Solution> solutions_;
};

/// What is told of a root is no longer kept in the table: both at once would take twice the
/// memory.
void enter_solutions(Run& run, const JudgedRoots& roots, SolveResult& result) {
  const auto sets = std::count_if(roots.begin(), roots.end(), [](const JudgedRoot& root) {
    return root.ground == Ground::on_set;
  });
  result.solutions.reserve(roots.size() - static_cast<std::size_t>(sets));
  OffTheHeap told;
  // What comparing them took.
  if (roots.size() > kRootsBetweenPages) give_back_pages();
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const auto& [group, ground] = roots[k];
    result.paths.finite += group.size();
    if (ground == Ground::on_set) {
      result.paths.on_positive_dimensional += group.size();
      result.on_sets.push_back(point_of_set(run, group));
    } else {
      told.take(solution_of(run, group, windings(run, roots[k])));
    }
    for (const std::uint64_t path : group) run.table.release(path);
    const bool is_many = k % kRootsBetweenPages == kRootsBetweenPages - 1;
    if (is_many) give_back_pages();
    if (is_many || k + 1 == roots.size()) told.give(result.solutions);
  }
  const auto by_path = [](const auto& a, const auto& b) { return a.path < b.path; };
  std::sort(result.solutions.begin(), result.solutions.end(), by_path);
  std::sort(result.on_sets.begin(), result.on_sets.end(), by_path);
}

void count_paths(const std::vector<PathRecord>& records, PathCounts& counts) {
  const auto count = [&](PathVerdict verdict) {
    return static_cast<std::uint64_t>(
        std::count_if(records.begin(), records.end(),
                      [&](const PathRecord& path) { return path.verdict == verdict; }));
  };
  counts.failed = count(PathVerdict::failed);
  counts.at_infinity = count(PathVerdict::at_infinity) + count(PathVerdict::as_rounded);
  counts.not_needed = count(PathVerdict::not_needed);
  counts.tracked = records.size() - count(PathVerdict::open);
  for (const PathRecord& path : records) {
    if (path.verdict == PathVerdict::open) continue;  // an interruption came first
    if (path.by_count && path.verdict == PathVerdict::finite) ++counts.by_count;
    if (path.followed > 1) ++counts.retracked;
    if (path.handed_over) ++counts.handed_over;
    if (path.precision == PathPrecision::mixed && path.verdict == PathVerdict::finite)
      ++counts.mixed;
    if (path.precision == PathPrecision::double_double) ++counts.double_double;
    if (path.precision == PathPrecision::multiprecision) ++counts.multiprecision;
  }
}

/// A path without an entry could not be said to be lost: a fault of ours.
void require_all_entries(const Run& run) {
  const std::uint64_t paths = run.setting.prepared.plan->paths;
  if (run.interrupted || run.table.tracked() == paths) return;
  throw std::logic_error("of " + counted(paths, "path") + " only " +
                         std::to_string(run.table.tracked()) + " have a verdict");
}

/// Of a singular root that is told as `best`. Ends further away than both are known to be may be
/// those of other roots, which the accuracy then covers.
double accuracy_of_group(const Run& run, PathGroups::Group group, const Refined& best) {
  double accuracy = kSingularMargin * best.accuracy;
  for (const std::uint64_t path : group) {
    const Refined& end = run.table.roots().at(path).point;
    const double apart = relative_distance(best.x, end.x);
    if (apart > best.accuracy + end.accuracy) accuracy = std::max(accuracy, apart + end.accuracy);
  }
  return accuracy;
}

/// `result` has its counts of paths.
SolveVerdict verdict_of(const Run& run, const SolveResult& result, bool lacks_image) {
  using enum SolveVerdict;
  if (run.out_of_memory) return out_of_memory;
  if (run.interrupted) return interrupted;
  if (result.paths.failed > 0) return paths_failed;
  if (lacks_image) return conjugate_missing;
  return result.paths.not_needed == 0 ? decided : decided_or_not_needed;
}

/// So far from the point that is told, relative to max(1, |x|_inf), the roots of a cluster may lie:
/// as far as double parts ends of paths, or as the residual leaves open.
double radius_of_cluster(const Run& run, PathGroups::Group group, const Refined& best) {
  // What a residual in double tells nothing of.
  constexpr double kRoundingOfResidual = 1e-15;
  const double share = std::max(best.residual, kRoundingOfResidual);
  double radius = kSingularMargin * std::pow(share, 1 / static_cast<double>(group.size()));
  for (const std::uint64_t path : group) {
    const Root& end = run.table.roots().at(path);
    radius = std::max(radius, relative_distance(best.x, end.point.x) + end.tolerance);
  }
  return radius;
}

/// What the certificate has of the point beyond double: nothing where a part of it, smaller than
/// that, was taken for 0.
std::vector<Point> beyond_double(const Certificate& proved, const Point& x) {
  std::vector<Point> finer(proved.finer.begin(), proved.finer.end());
  for (std::size_t j = 0; j < x.size(); ++j) {
    const bool has_real = proved.midpoint[j].real() == x[j].real();
    const bool has_imaginary = proved.midpoint[j].imag() == x[j].imag();
    if ((!has_real && x[j].real() != 0) || (!has_imaginary && x[j].imag() != 0)) return {};
    for (Point& part : finer) {
      if (!has_real) part[j].real(0);
      if (!has_imaginary) part[j].imag(0);
    }
  }
  while (!finer.empty() && finer.back() == Point(x.size())) finer.pop_back();
  return finer;
}

}  // namespace

PathCounts& PathCounts::operator+=(const PathCounts& other) {
  for (const auto count : kCounts) this->*count += other.*count;
  return *this;
}

PathCounts& PathCounts::operator*=(std::uint64_t sheets) {
  for (const auto count : kCounts) this->*count *= sheets;
  return *this;
}

Solution solution_of(const Run& run, PathGroups::Group group, const std::vector<int>& winding) {
  const auto& roots = run.table.roots();
  const auto best = std::min_element(group.begin(), group.end(), [&](auto a, auto b) {
    return roots.at(a).point.accuracy < roots.at(b).point.accuracy;
  });
  const Root& root = roots.at(*best);
  const Refined& point = root.point;
  Solution solution;
  solution.path = group.front();
  solution.x = point.x;
  if (root.certificate) solution.finer = beyond_double(*root.certificate, point.x);
  solution.real = is_real(root);
  solution.singular = !point.simple;
  solution.multiplicity = group.size();
  solution.winding = winding;
  solution.residual = point.residual;
  solution.accuracy = point.simple ? point.accuracy : accuracy_of_group(run, group, point);
  solution.condition = point.condition;
  solution.certified = root.certificate != nullptr;
  solution.cluster = group.size() > 1 && !run.counted_ends.contains(group.front());
  if (solution.cluster) {
    const double radius = radius_of_cluster(run, group, point);
    solution.accuracy = std::max(solution.accuracy, radius);
    solution.radius = solution.accuracy * std::max(1.0, max_norm(point.x));
  }
  for (const std::uint64_t path : group) {
    solution.precision = std::max(solution.precision, run.table.precision(path));
  }
  if (solution.real && is_real(run.setting.f)) {
    for (Complex& xi : solution.x) xi.imag(0);
  }
  return solution;
}

void put_in_doubt(SolveResult& result, std::string why) {
  result.complete = false;
  result.message = std::move(why);
  result.bound.reset();
  if (result.completeness) result.completeness = RootCompleteness::open;
}

void close_account(Run& run, SolveResult& result) {
  require_all_entries(run);
  Outcome outcome = run.interrupted ? outcome_so_far(run) : outcome_of(run);
  const bool lacks_image =
      !run.bounds.met && is_real(run.setting.f) && !missing_conjugates(run.table).empty();
  const auto proved = run.interrupted ? std::nullopt : roots_to_compare(run);
  enter_solutions(run, outcome.roots, result);
  result.ledger = run.table.take_records();
  enter_places(outcome.roots, result);
  enter_verdicts(outcome, result);
  count_paths(result.ledger, result.paths);
  result.failures = std::move(outcome.failures);
  result.work = run.work;
  const bool all_decided = result.paths.failed == 0 && !lacks_image;
  auto doubt = run.interrupted ? std::nullopt : contradiction_by_algebra(run, proved, result);
  if (!doubt) doubt = doubt_of_start(run);
  result.complete = !run.interrupted && all_decided && !doubt;
  const bool is_doubt_alone = doubt && !run.interrupted && all_decided;
  result.message = is_doubt_alone ? *doubt : solve_message(verdict_of(run, result, lacks_image));
  tell_completeness(run, result);
  const std::uint64_t as_rounded = run.table.count(PathVerdict::as_rounded);
  if (as_rounded == 0) return;
  result.left_out.push_back(paths_as_rounded_left_out(as_rounded));
}

}  // namespace moivre
