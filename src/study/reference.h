// SPDX-License-Identifier: MIT
// Which roots are there, to 50 digits, and which path leads to which? From careful runs of two
// trackers over all seeds.
//
// A path's owner is settled where its runs agree: a simple root has one path, and where two
// trackers see another root at its end, nobody is believed.
#pragma once

#include <map>

#include "moivre/numeric/double_double.h"
#include "moivre/study/study.h"

namespace moivre {

struct KnownRoot {
  Point x;                                   ///< as delivered
  std::vector<ComplexDoubleDouble> nearest;  ///< empty where it is not known to all digits
  std::uint64_t multiplicity = 1;
  bool singular = false;
  double accuracy = 0;
  double separation =
      0;  ///< relative distance of the nearest other root; infinite for a single one
};

/// The careful runs that were asked for; an interrupted study has fewer.
struct ReferenceRuns {
  std::size_t trackers = 0;
  std::size_t seeds = 0;
};

class ReferenceRoots {
 public:
  /// Takes in what one careful run found with seed number `seed` (0, 1, ...).
  void enter(const SolveResult& run, std::size_t seed);
  /// No more runs come: polishes, and judges the completeness by those that were asked for.
  void close(const System& f, const std::optional<std::uint64_t>& known, ReferenceRuns asked);

  const StudyReference& facts() const { return facts_; }
  const std::vector<KnownRoot>& roots() const { return roots_; }
  /// Path -> root, simple roots only, where all runs with that seed agree.
  const std::map<std::uint64_t, std::size_t>& owners(std::size_t seed) const {
    return owners_.at(seed);
  }
  /// The root nearest to x.
  std::size_t nearest(const Point& x) const;
  /// The root that x is, known to `accuracy`; nullopt when it is none.
  std::optional<std::size_t> match(const Point& x, double accuracy) const;
  /// |x - x*|_inf / max(1, |x*|_inf) in double-double. Requires that x* is known to all digits.
  double error(std::size_t root, const Point& x) const;

 private:
  struct Run {
    std::size_t seed;
    bool complete;
    std::map<std::uint64_t, std::size_t> found;  ///< path -> root
    std::vector<bool> has;
  };
  std::size_t place_of(const Solution& solution);
  void separate();
  void settle_owners();
  void judge(ReferenceRuns asked);

  std::vector<KnownRoot> roots_;
  std::vector<Run> runs_;
  std::vector<std::map<std::uint64_t, std::size_t>> owners_;
  StudyReference facts_;
};

/// |x - y|_inf / max(1, |y|_inf).
double relative_difference(const Point& x, const Point& y);

}  // namespace moivre
