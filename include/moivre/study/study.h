// SPDX-License-Identifier: MIT
// What does accuracy cost? One system solved with many trackers and tolerances, over several seeds.
// Errors are against roots known to 50 digits.
//
//   error(x) = |x - x*|_inf / max(1, |x*|_inf), the largest over the simple roots and all seeds, in
//   three places:
//     end_error    where the tracker's last step left the path (solver/drift.h)
//     error        of the roots that solve() delivers, residuals in double-double
//     plain_error  of the same roots, after Newton's method with residuals in plain double
//
//   own        solve() without tracking doubtful paths again, neither with tighter tolerances nor
//              in double-double. So the lost roots are those of the tracker
//   repaired   solve() as it is
//   jumped     paths whose end is nearest to another path's root. Runs of both trackers with tight
//              tolerances tell which root belongs to which path
//
// CPU time is that of the whole solve() on one thread, reading excluded; a short solve is repeated.
// Counts are those of the worst seed, work is the median. Singular roots count as found or lost,
// but have no error: no digits of theirs are proved.
// Edges: roots on sets of positive dimension are left out. Not supported: systems that are not
// square.
#pragma once

#include <memory>

#include "moivre/solver/solve.h"

namespace moivre {

/// A tracker with its options: one point of a curve in the diagram.
struct StudySetting {
  std::string curve;  ///< "cvode adams newton": what the tolerance varies along
  double tolerance = 0;
  std::shared_ptr<const Tracker> tracker;
};

struct Spread {
  double least = 0;
  double median = 0;
  double most = 0;
};

/// The spread of at least one value; the lower of the two middle ones is the median of an even
/// number.
Spread spread_of(std::vector<double> values);

/// What solve() made of one setting.
struct StudyOutcome {
  Spread cpu_s;
  std::uint64_t lost = 0;       ///< roots of the reference that are missing
  std::uint64_t strangers = 0;  ///< roots delivered that are not in the reference
  std::uint64_t failed = 0;     ///< paths
  std::uint64_t retracked = 0;  ///< paths
  std::optional<double> error;  ///< nullopt: no simple root was found
  std::optional<double> plain_error;
  StepCount work;
};

/// What the tracker did on the paths to simple roots, without help from the solver.
struct StudyWalk {
  std::uint64_t paths = 0;  ///< followed, of each seed
  std::uint64_t jumped = 0;
  std::uint64_t stuck = 0;  ///< did not reach t = 1
  double drift_before = 0;  ///< largest |H| before Newton's correction of a step
  double drift_after = 0;   ///< and after it
  std::optional<double> end_error;
};

struct StudyRow {
  std::string curve;
  double tolerance = 0;
  std::string tracker;
  OptionsInForce tracker_options;
  StudyOutcome own;
  StudyOutcome repaired;
  std::optional<StudyWalk> walk;  ///< nullopt where there are no paths to simple roots
};

/// The reference roots for all rows.
struct StudyReference {
  std::uint64_t roots = 0;  ///< distinct and isolated
  std::uint64_t with_multiplicity = 0;
  std::uint64_t exact = 0;  ///< of the distinct ones: known to `digits`
  int digits = 50;
  std::optional<std::uint64_t> known;  ///< count with multiplicity, where it is known
  bool complete = false;
  std::string completeness;  ///< a sentence that says why, or why not
};

struct StudyProgress {
  std::uint64_t done = 0;
  std::uint64_t total = 0;
  std::string now;  ///< the setting under way
};

struct StudyOptions {
  std::uint64_t seed = 1;  ///< the first of them
  int seeds = 3;
  std::optional<std::uint64_t> known_roots{};  ///< with multiplicity
  std::uint64_t walked_paths = 256;            ///< at most so many of each seed, evenly spread
  std::function<void(const StudyProgress&)> progress{};  ///< may be empty
};

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const StudyOptions& options);

/// A measurement of another kind, as a table. Columns named ..._error are drawn over cpu_s, the
/// first column beside each point.
struct StudyTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

struct StudyResult {
  bool complete = false;  ///< all settings were run; the reference may be incomplete all the same
  std::string message = "study_system() was not run";
  std::uint64_t seed = 0;
  int seeds = 0;
  SystemFacts system;
  SystemFacts reduced;
  std::uint64_t paths = 0;
  StudyReference reference;
  std::vector<StudyRow> rows;  ///< in the order of the settings; those that were finished
  std::vector<StudyTable> tables;
  std::vector<std::string>
      remarks;       ///< comparisons that were not possible, and why; a sentence each
  double cpu_s = 0;  ///< of all of it
};

/// What is solved: a system by solve(), or something that ends in roots of a system, such as
/// closures.
struct StudySubject {
  System system;           ///< whose roots the solutions are; polished where it is square
  bool has_paths = false;  ///< the solutions' path numbers are those of solve(system)
  std::function<SolveResult(const Tracker&, const SolveOptions&, const std::atomic<bool>&)> solve;
};

/// `reference_tracker` and `witness` are trackers with tight tolerances that are compared with each
/// other; `witness` may be nullptr. Throws std::invalid_argument when the options or the system are
/// not as said; a set `stop` ends with the rows that are finished.
StudyResult study_subject(const StudySubject& subject, const std::vector<StudySetting>& settings,
                          const Tracker& reference_tracker, const Tracker* witness,
                          const StudyOptions& options = {},
                          const std::atomic<bool>& stop = std::atomic<bool>{false});

/// The same of solve(f).
StudyResult study_system(const System& f, const std::vector<StudySetting>& settings,
                         const Tracker& reference_tracker, const Tracker* witness,
                         const StudyOptions& options = {},
                         const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
