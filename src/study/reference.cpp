// SPDX-License-Identifier: MIT
// The reference of a study: union of all careful runs, polished in multiprecision.
#include "reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "moivre/expression/counted.h"
#include "moivre/multiprecision/reference_roots.h"
#include "moivre/numeric/near_points.h"

namespace moivre {
namespace {

// Two runs' simple roots are one when they differ by no more than their accuracies, or by rounding.
constexpr double kSimpleTolerance = 1e-13;
constexpr double kAccuracyFactor = 4;
// Singular ends of two runs differ by the errors of both endgames.
constexpr double kSingularTolerance = 1e-6;
// A delivered root belongs to the reference's when it is this much nearer to it than to any other.
constexpr double kShareOfSeparation = 1.0 / 3;
// And no farther than this: a root that has no correct digits worth the name is a stranger.
constexpr double kFarthestMatch = 1e-4;

double tolerance_of(double accuracy, bool singular) {
  return singular ? std::max(kSingularTolerance, kAccuracyFactor * accuracy)
                  : kSimpleTolerance + kAccuracyFactor * accuracy;
}

double modulus(const ComplexDoubleDouble& z) {
  return std::hypot(to_double(z.re), to_double(z.im));
}

}  // namespace

double relative_difference(const Point& x, const Point& y) {
  return max_distance(x, y) / std::max(1.0, max_norm(y));
}

std::size_t ReferenceRoots::place_of(const Solution& solution) {
  const double tolerance = tolerance_of(solution.accuracy, solution.singular);
  for (std::size_t k = 0; k < roots_.size(); ++k) {
    KnownRoot& root = roots_[k];
    const double other = tolerance_of(root.accuracy, root.singular);
    if (relative_difference(solution.x, root.x) > tolerance + other) continue;
    root.multiplicity = std::max(root.multiplicity, solution.multiplicity);
    return k;
  }
  roots_.push_back({solution.x,
                    {},
                    solution.multiplicity,
                    solution.singular,
                    solution.accuracy,
                    std::numeric_limits<double>::infinity()});
  return roots_.size() - 1;
}

void ReferenceRoots::enter(const SolveResult& result, std::size_t seed) {
  Run& run = runs_.emplace_back();
  run.seed = seed;
  run.complete = result.complete;
  for (const Solution& solution : result.solutions) {
    const std::size_t root = place_of(solution);
    if (run.has.size() <= root) run.has.resize(root + 1);
    run.has[root] = true;
    if (!solution.singular) run.found[solution.path] = root;
  }
}

void ReferenceRoots::separate() {
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = relative_difference(roots_[i].x, roots_[j].x);
      roots_[i].separation = std::min(roots_[i].separation, distance);
      roots_[j].separation = std::min(roots_[j].separation, distance);
    }
  }
}

void ReferenceRoots::settle_owners() {
  for (const Run& run : runs_) owners_.resize(std::max(owners_.size(), run.seed + 1));
  std::vector<std::set<std::uint64_t>> disputed(owners_.size());
  for (const Run& run : runs_) {
    for (const auto& [path, root] : run.found) {
      const auto [entry, is_new] = owners_[run.seed].emplace(path, root);
      if (!is_new && entry->second != root) disputed[run.seed].insert(path);
    }
  }
  for (std::size_t seed = 0; seed < owners_.size(); ++seed) {
    for (const std::uint64_t path : disputed[seed]) owners_[seed].erase(path);
  }
}

void ReferenceRoots::judge(ReferenceRuns asked) {
  const bool is_whole = runs_.size() == asked.trackers * asked.seeds;
  bool all_agree = true;
  for (Run& run : runs_) {
    run.has.resize(roots_.size());
    all_agree = all_agree && run.complete &&
                std::all_of(run.has.begin(), run.has.end(), [](bool found) { return found; });
  }
  const std::string count = std::to_string(facts_.with_multiplicity);
  if (facts_.known) {
    facts_.complete = facts_.with_multiplicity == *facts_.known;
    facts_.completeness = facts_.complete ? "the count of " + count + " roots is known, and met"
                                          : "not complete: " + count + " of " +
                                                counted(*facts_.known, "root") + " were found";
  } else if (!is_whole) {
    facts_.completeness = "not shown to be complete: the runs for it were interrupted";
  } else if (asked.trackers > 1) {
    facts_.complete = all_agree;
    facts_.completeness = all_agree
                              ? "both trackers agree on " + count + " roots with every seed"
                              : "not shown to be complete: the trackers or the seeds differ, " +
                                    count + " roots in all";
  } else {
    facts_.completeness = "not shown to be complete: no count is known, and there is one tracker";
  }
}

void ReferenceRoots::close(const System& f, const std::optional<std::uint64_t>& known,
                           ReferenceRuns asked) {
  std::vector<Point> approximations;
  std::vector<std::size_t> simple;
  const bool is_square = f.polynomials.size() == f.variables.size();
  for (std::size_t k = 0; k < roots_.size(); ++k) {
    if (roots_[k].singular || !is_square) continue;
    simple.push_back(k);
    approximations.push_back(roots_[k].x);
  }
  std::vector<ReferenceRoot> polished = reference_roots(f, approximations, facts_.digits);
  for (std::size_t k = 0; k < simple.size(); ++k) {
    if (!polished[k].converged) continue;
    ++facts_.exact;
    roots_[simple[k]].nearest = std::move(polished[k].nearest);
  }
  facts_.roots = roots_.size();
  for (const KnownRoot& root : roots_) facts_.with_multiplicity += root.multiplicity;
  facts_.known = known;
  separate();
  settle_owners();
  judge(asked);
}

std::size_t ReferenceRoots::nearest(const Point& x) const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < roots_.size(); ++k) {
    const double distance = relative_difference(x, roots_[k].x);
    if (distance < least) {
      least = distance;
      best = k;
    }
  }
  return best;
}

std::optional<std::size_t> ReferenceRoots::match(const Point& x, double accuracy) const {
  if (roots_.empty()) return std::nullopt;
  const std::size_t root = nearest(x);
  const double reach =
      roots_[root].singular
          ? std::max(kFarthestMatch, kAccuracyFactor * (accuracy + roots_[root].accuracy))
          : std::min(kFarthestMatch, kShareOfSeparation * roots_[root].separation);
  if (!(relative_difference(x, roots_[root].x) <= reach)) return std::nullopt;
  return root;
}

double ReferenceRoots::error(std::size_t root, const Point& x) const {
  const std::vector<ComplexDoubleDouble>& exact = roots_[root].nearest;
  double largest = 0;
  double size = 1;
  for (std::size_t i = 0; i < x.size(); ++i) {
    largest = std::max(largest, modulus(ComplexDoubleDouble(x[i]) - exact[i]));
    size = std::max(size, modulus(exact[i]));
  }
  return largest / size;
}

}  // namespace moivre
