// SPDX-License-Identifier: MIT
// What are all isolated roots of a polynomial system? Which paths were tracked, where did each end,
// and do the counts add up?
//
// F: polynomials in n variables, usually n of them. Presolve (linear equations eliminated, rows and
// variables scaled) -> start system -> all paths on all cores -> ends judged on the system as given
// -> jumps found and tracked again -> isolated roots.
//
// Completeness:
//   proved   as many roots are certified as a proved bound allows
//   shown    every path was decided, or left where exact algebra counts no more roots, and every
//            regular root is certified
//   open     neither
//
// Conservation, on every run:   tracked = finite + at_infinity + failed + not_needed
//                               finite  = sum of multiplicities + on_positive_dimensional + excess
//                                       + on_denominators + filtered
// A lost path counts as failed. `complete` is true when every path was decided. The result does not
// depend on the number of threads. A system with more equations than unknowns is squared up by
// random combinations; roots of these that fail an equation of F are `excess`. A system with fewer
// equations is refused, or cut by random linear ones (SolveOptions::slice).
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "moivre/bounds/root_bounds.h"
#include "moivre/endgame/end_parameters.h"
#include "moivre/numeric/complex.h"
#include "moivre/polynomial/coordinate_planes.h"
#include "moivre/polynomial/system.h"
#include "moivre/start/start_kind.h"
#include "moivre/tracker/tracker.h"

namespace moivre {

class Observations;
struct GivenStart;

struct Progress {
  std::uint64_t done = 0;
  std::uint64_t total = 0;
  std::uint64_t finite = 0;
  /// During the search for mixed cells, before any path: how many were found, and how far the
  /// search is, 0 to 1.
  std::uint64_t cells = 0;
  std::optional<double> search;
};

/// The level of precision that a path needed.
enum class PathPrecision : std::uint8_t {
  double_precision,  ///< double throughout
  mixed,             ///< residuals in double-double where rounding stopped Newton's method
  double_double,     ///< the whole path in double-double
  multiprecision     ///< the whole path in a hundred digits or more
};
std::string to_string(PathPrecision precision);

/// Which levels of precision a solve may use.
enum class Precision {
  automatic,         ///< for each path the one that it needs
  double_precision,  ///< no whole path in double-double
  double_double      ///< every path in double-double from the start
};

struct SolveResult;

struct SolveOptions {
  std::uint64_t seed = 1;
  StartKind start = StartKind::automatic;
  int threads = 0;          ///< 0: as many as the machine has
  int tolerance_level = 0;  ///< of the first tracking; each level tightens the tolerances tenfold
  int maximum_tolerance_level = 3;  ///< of a path in doubt, which is tracked once more
  bool eliminate = true;            ///< linear equations before tracking
  bool scale = true;                ///< rows and variables, by powers of two
  /// If the chosen start leaves something open, a polyhedral start follows its own paths, and its
  /// result is returned.
  bool second_start = true;
  bool slice = false;  ///< fewer equations than unknowns: cut by random linear ones, else refused
  Precision precision = Precision::automatic;
  bool certify = true;  ///< proofs are told; they are made in any case
  /// Paths are followed to their ends also where as many roots are known as there can be.
  bool every_path = false;
  EndgameOptions endgame;
  /// Bytes that there are; 0: not known. A run whose paths cannot be kept within them is refused
  /// before it begins.
  std::uint64_t memory = 0;
  /// Tracks again the paths that `tracker` left in doubt; in double-double too, where it has lanes
  /// for that and `tracker` has not. Not owned, may be nullptr.
  const Tracker* fallback = nullptr;
  /// Asked for the ends of paths before these are followed, and told those that were. Not owned,
  /// may be nullptr.
  Observations* observations = nullptr;
  /// Called after each path, from any thread, never twice at once; may be empty. What it throws
  /// ends the run, when the paths under way have ended, and is thrown to the caller.
  std::function<void(const Progress&)> progress;
};

/// What knows starts of systems that come one by one, as a cache of families does. Thread-safe.
class KnownStarts {
 public:
  virtual ~KnownStarts() = default;
  /// Of f, square and without homogeneous groups; nullopt where it knows none. The tracker, the
  /// options and `stop` are for what it may have to learn first.
  virtual std::optional<GivenStart> start_of(const System& f, const Tracker& tracker,
                                             const SolveOptions& options,
                                             const std::atomic<bool>& stop) = 0;
};

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const SolveOptions& options);

/// A finite isolated root.
struct Solution {
  std::uint64_t path = 0;  ///< smallest number of the paths that end here
  Point x;                 ///< in the system's variables and order
  /// Of a proved root that is known beyond double: x + finer[0] + finer[1] + ... is nearer.
  std::vector<Point> finer = {};
  /// All imaginary parts are 0 (and set to 0): proved where the root is certified and F real, else
  /// within the accuracy.
  bool real = false;
  bool singular = false;
  std::uint64_t multiplicity = 1;
  /// So many roots lie within `radius` of x in each coordinate, or one root counts as often: exact
  /// algebra has not told which.
  bool cluster = false;
  double radius = 0;  ///< of a cluster
  /// Of the cycles that end here; their sum is the multiplicity. Empty where the multiplicity comes
  /// from exact algebra.
  std::vector<int> winding{1};
  double residual = 0;   ///< max_i |F_i(x)| / sum |terms of F_i|
  double accuracy = 0;   ///< bound on |x - x*|_inf / max(1, |x|_inf)
  double condition = 0;  ///< infinity-norm condition number of the row-scaled Jacobian
  /// A root of the exact system is proved to lie within `accuracy`, none of the other certified
  /// ones: a simple one, or, where equations are powers, a simple one of their bases
  /// (polynomial/powers.h), whose multiplicity is then proved too. nullopt: not asked for, or not
  /// possible because F has more equations than unknowns.
  std::optional<bool> certified;
  PathPrecision precision = PathPrecision::double_precision;  ///< that its paths needed
  /// Conditions that its digits do not tell from equalities there (solver/filter.h).
  std::vector<std::string> on_boundary = {};
  std::vector<ComplexDecimal>
      x_digits;  ///< x in SolveResult::digits digits; empty where there are none
};

struct PathCounts {
  std::uint64_t tracked = 0;
  std::uint64_t finite = 0;
  std::uint64_t at_infinity = 0;
  std::uint64_t failed = 0;
  std::uint64_t not_needed =
      0;  ///< not followed to an end: as many roots are known as there can be
  std::uint64_t on_positive_dimensional = 0;
  std::uint64_t retracked = 0;
  std::uint64_t handed_over = 0;     ///< of these, to SolveOptions::fallback
  std::uint64_t mixed = 0;           ///< to finite ends, that needed residuals in double-double
  std::uint64_t double_double = 0;   ///< that needed double-double throughout
  std::uint64_t multiprecision = 0;  ///< that needed more digits
  /// Of the finite ones: their ends were not seen, a count says that so many lead to a root.
  std::uint64_t by_count = 0;

  PathCounts& operator+=(const PathCounts& other);
  PathCounts& operator*=(std::uint64_t sheets);
  friend bool operator==(const PathCounts&, const PathCounts&) = default;
};

struct FailedPath {
  std::uint64_t path = 0;
  Failure failure = Failure::step_limit;
  Complex t;              ///< how far it came
  std::size_t stage = 0;  ///< of the plan, on which it was lost
};

/// What became of a path.
enum class PathVerdict : std::uint8_t {
  open,         ///< not followed to its end
  finite,       ///< ends at an isolated root, or on a set of positive dimension
  at_infinity,  ///< ends there
  as_rounded,   ///< at infinity as far as the digits of the system's coefficients tell
  not_needed,   ///< not followed to an end: as many roots are known as there can be
  failed
};
/// "finite", "at infinity", "at infinity as rounded", "not needed", "failed", "open".
std::string to_string(PathVerdict verdict);

/// The account of one path: 16 bytes, whatever became of it.
struct PathRecord {
  static constexpr std::uint32_t kNoSolution = 0xffffffff;

  std::uint32_t steps = 0;               ///< accepted and rejected, each time that it was followed
  std::uint32_t solution = kNoSolution;  ///< its place in SolveResult::solutions
  std::uint8_t followed = 0;             ///< how often, 255 for more
  std::uint8_t stage = 0;                ///< of the plan, on which it ended
  PathVerdict verdict = PathVerdict::open;
  PathPrecision precision = PathPrecision::double_precision;
  bool handed_over = false;  ///< to SolveOptions::fallback
  bool by_count = false;     ///< PathCounts::by_count
};

/// A step that this system did not need, or that was replaced by another.
struct LeftOut {
  std::string what;
  std::string why;
};

struct SystemFacts {
  std::vector<std::string> variables;
  std::vector<std::uint64_t> degrees;
  std::optional<std::uint64_t> total_degree{};  ///< nullopt beyond 64 bits
  std::uint64_t isotropic_pairs = 0;            ///< of unknowns that stand as x + iy and x - iy
};

struct StartFacts {
  StartSource source = StartSource::total_degree;
  std::uint64_t paths = 0;
  std::string why;
  StartCounts counts;
};

/// What is known about the number of isolated roots.
enum class RootCompleteness {
  proved,  ///< as many are certified as a proved bound allows: there is no other
  /// Every path was decided, or left where exact algebra counts no more roots; regular roots are
  /// certified.
  shown,
  open
};
std::string to_string(RootCompleteness completeness);

/// A proved bound on the number of isolated roots that is met by as many certified ones.
struct MetBound {
  BoundKind kind = BoundKind::elimination;
  std::uint64_t value = 0;

  /// It bounds the points at which roots lie, not their multiplicities.
  bool is_of_points() const { return kind == BoundKind::strata; }
};

/// Wall seconds.
struct SolveTime {
  int threads = 1;
  double parse = 0;  ///< filled by the caller that parsed
  double start = 0;  ///< presolve, start system, tape
  double track = 0;
  double track_cpu = 0;  ///< CPU seconds of all threads while tracking
  double refine = 0;     ///< refinement, jumps, accounting
  double total = 0;
};

/// A path that two trackers followed to different ends.
struct Disagreement {
  std::uint64_t path = 0;
  std::optional<Point> found;      ///< the root at its end; nullopt where it ends at none
  std::optional<Point> witnessed;  ///< the same by the witness
  std::optional<std::string>
      jumped;  ///< the tracker that left the path; nullopt where this is not known
};

/// The comparison with a second tracker on the same paths.
struct CrossCheck {
  std::string witness;
  std::uint64_t common = 0;                 ///< roots that both found
  std::uint64_t missed = 0;                 ///< roots that only the witness found
  std::uint64_t unwitnessed = 0;            ///< roots that the witness did not find
  std::vector<Disagreement> disagreements;  ///< by path number
};

struct SolveResult {
  bool complete = false;
  std::string message = "solve() was not run";
  std::uint64_t seed = 0;
  SystemFacts system;
  SystemFacts reduced;  ///< what was tracked
  StartFacts start;
  std::string tracker;
  OptionsInForce tracker_options;
  PathCounts paths;
  std::vector<Solution> solutions;  ///< by path number
  /// nullopt: certificates were not asked for, or F has more equations than unknowns.
  std::optional<RootCompleteness> completeness;
  std::optional<MetBound> bound;  ///< that proves the completeness
  /// Points of sets of positive dimension, where paths end; `multiplicity`: so many paths. By path
  /// number.
  std::vector<Solution> on_sets;
  /// On which every equation is zero, whether a path ends there or not.
  std::vector<CoordinatePlane> planes;
  std::uint64_t excess =
      0;  ///< roots that squaring up added, with multiplicity: they fail an equation of F
  std::uint64_t on_denominators =
      0;  ///< roots of the cleared equations, with multiplicity, where a denominator of F is zero
  std::uint64_t filtered =
      0;  ///< roots that were not asked for (solver/filter.h), with multiplicity
  std::vector<FailedPath> failures;
  std::vector<PathRecord> ledger;  ///< by path number; empty where no path was followed
  std::vector<LeftOut> left_out;
  std::optional<int>
      digits;  ///< how many the roots were given beyond double, where any were asked for
  std::optional<CrossCheck> cross_check;  ///< where one was made (solver/cross_check.h)
  StepCount work;
  SolveTime time;
};

/// Throws before any tracking: InvalidInput, with every broken rule, when the system breaks one
/// (polynomial/system.h), an option is out of range, the paths do not fit into `memory`, or there
/// are fewer equations than unknowns without `slice`; std::overflow_error when the number of paths
/// exceeds 64 bits. A set `stop` ends the run with the paths that are finished. Of a text with
/// numbers that no fraction is (System::nudged) two systems are solved: what is not in both of them
/// is in doubt.
SolveResult solve(const System& f, const Tracker& tracker, const SolveOptions& options = {},
                  const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
