// SPDX-License-Identifier: MIT
// Compares the roots of two runs, and follows the paths on which they differ once more.
#include "moivre/solver/cross_check.h"

#include <algorithm>
#include <map>

#include "account.h"
#include "coincidence.h"
#include "moivre/polynomial/patches.h"
#include "moivre/solver/trace.h"
#include "solver_sentences.h"

namespace moivre {
namespace {

// Two reports of one simple root differ by their accuracies and rounding; singular ones are known
// less well, and ends as a tracker leaves them are not refined.
constexpr double kSimpleTolerance = 1e-10;
constexpr double kLooseTolerance = 1e-6;
// Disagreements that are settled by following the path again: more of them mean a tracker that does
// not work.
constexpr std::size_t kMostSettled = 64;
constexpr int kSettlingTolerance = 2;

bool is_same(const Solution& a, const Solution& b) {
  const double tolerance = a.singular || b.singular ? kLooseTolerance : kSimpleTolerance;
  return relative_distance(b.x, a.x) <= tolerance + a.accuracy + b.accuracy;
}

using ByPath = std::map<std::uint64_t, const Solution*>;

ByPath by_path(const SolveResult& result) {
  ByPath roots;
  for (const Solution& root : result.solutions) roots[root.path] = &root;
  return roots;
}

std::optional<Point> point_at(const ByPath& roots, std::uint64_t path) {
  const auto found = roots.find(path);
  if (found == roots.end()) return std::nullopt;
  return found->second->x;
}

/// The root among `roots` that is `root`, the one of the same path first; nullptr where there is
/// none.
const Solution* counterpart(const Solution& root, const ByPath& roots) {
  const auto own = roots.find(root.path);
  if (own != roots.end() && is_same(root, *own->second)) return own->second;
  const auto other = std::find_if(roots.begin(), roots.end(),
                                  [&](const auto& entry) { return is_same(root, *entry.second); });
  return other == roots.end() ? nullptr : other->second;
}

/// A path's end for comparison: nullopt where it is not a finite point.
struct End {
  bool is_decided = false;
  std::optional<Point> x;
};

End end_of(const Trace& trace) {
  if (trace.end.status == PathStatus::failed) return {};
  if (trace.end.status == PathStatus::at_infinity) return {true, std::nullopt};
  return {true, trace.x};
}

bool agree(const std::optional<Point>& a, const std::optional<Point>& b) {
  if (!a || !b) return !a && !b;
  return relative_distance(*b, *a) <= kLooseTolerance;
}

void settle(Disagreement& difference, const System& f, const Tracker& tracker,
            const Tracker& witness, const SolveOptions& options, const std::atomic<bool>& stop) {
  const End by_tracker = end_of(trace_path(f, tracker, options, difference.path, stop));
  const End by_witness = end_of(trace_path(f, witness, options, difference.path, stop));
  if (!by_tracker.is_decided || !by_witness.is_decided) return;
  if (!agree(by_tracker.x, by_witness.x)) return;
  const bool tracker_was_right = agree(difference.found, by_tracker.x);
  const bool witness_was_right = agree(difference.witnessed, by_tracker.x);
  if (tracker_was_right == witness_was_right) return;
  difference.jumped = tracker_was_right ? witness.kind() : tracker.kind();
}

}  // namespace

CrossCheck compare(const SolveResult& result, const SolveResult& witness) {
  CrossCheck check;
  check.witness = witness.tracker;
  const ByPath own = by_path(result);
  const ByPath others = by_path(witness);
  std::map<std::uint64_t, Disagreement> differences;
  const auto differ = [&](std::uint64_t path) {
    differences[path] = {path, point_at(own, path), point_at(others, path), std::nullopt};
  };
  for (const auto& [path, root] : own) {
    const Solution* other = counterpart(*root, others);
    if (other == nullptr) {
      ++check.unwitnessed;
      differ(path);
      continue;
    }
    ++check.common;
    if (!root->singular && !other->singular && other->path != path) differ(path);
  }
  for (const auto& [path, root] : others) {
    if (counterpart(*root, own) != nullptr) continue;
    ++check.missed;
    differ(path);
  }
  for (auto& [path, difference] : differences) check.disagreements.push_back(std::move(difference));
  return check;
}

void cross_check(const System& f, SolveResult& result, const Tracker& tracker,
                 const Tracker& witness, const SolveOptions& options,
                 const std::atomic<bool>& stop) {
  SolveOptions own = options;
  own.fallback = nullptr;
  own.start = asked_for(result.start.source).value_or(options.start);
  CrossCheck check = compare(result, solve(f, witness, own, stop));
  own.tolerance_level = kSettlingTolerance;
  // The paths of a system that had to be made square are not those that trace_path() follows.
  const std::size_t settled = is_square(f) ? std::min(check.disagreements.size(), kMostSettled) : 0;
  for (std::size_t k = 0; k < settled && !stop.load(); ++k) {
    settle(check.disagreements[k], f, tracker, witness, own, stop);
  }
  if (check.missed > 0) put_in_doubt(result, doubt_message(SolveDoubt::witness_found_more));
  result.cross_check = std::move(check);
}

}  // namespace moivre
