// SPDX-License-Identifier: MIT
// What does a result claim? Facts about its system, counts of paths, and each root with its
// properties.
//
// Two forms, recognized by content: the JSON of `moivre solve` (docs/json.md), and PHCpack's
// solution list, as `phc -b` writes it.
// The last list of a file counts; earlier ones belong to start systems or are not refined yet.
// Nothing is judged here. Faults of form are refused: a truncated file, a missing key, a text
// instead of a number, a point of another dimension. Every fault is named by its place in the JSON,
// as in `solutions[3].x[1]`, or by its line.
// What a result leaves out, or gives as null, is not claimed: nullopt. Not supported: the JSON of
// other commands.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "moivre/expression/source.h"
#include "moivre/numeric/complex.h"

namespace moivre {

enum class ClaimForm { solve_json, solution_list };

struct RootClaim {
  std::optional<std::uint64_t> path;
  Point x;
  std::optional<bool> real;
  std::optional<bool> singular;
  std::uint64_t multiplicity = 1;
  bool cluster = false;  ///< so many roots nearby, or one as often
  std::optional<std::vector<std::uint64_t>> winding;
  std::optional<double> residual;
  std::optional<double> accuracy;  ///< bound on |x - x*|_inf / max(1, |x|_inf)
  std::optional<double> condition;
  std::optional<bool> certified;
  std::vector<ComplexDecimal> x_digits;
};

struct SystemClaim {
  std::vector<std::string> variables;
  std::vector<std::uint64_t> degrees;
  std::optional<std::uint64_t> total_degree;
};

struct ReducedClaim {
  std::uint64_t variables = 0;
  std::vector<std::uint64_t> degrees;
  std::uint64_t isotropic_pairs = 0;
};

struct StartClaim {
  std::string kind;
  std::uint64_t paths = 0;
  std::optional<std::uint64_t> total_degree, multihomogeneous, mixed_volume;  ///< `start.counts`
};

struct PathClaim {
  std::uint64_t tracked = 0, finite = 0, at_infinity = 0, failed = 0, on_positive_dimensional = 0;
  std::uint64_t not_needed = 0, by_count = 0;
  std::optional<std::uint64_t> retracked, handed_over;
};

/// The bound that is said to be met.
struct BoundClaim {
  std::string kind;
  std::uint64_t value = 0;
  std::optional<std::string> certainty;  ///< on what the value rests; older results do not say
};

/// A coordinate plane on which every equation is said to be zero.
struct PlaneClaim {
  std::vector<std::string> zero;  ///< names of unknowns
  std::uint64_t dimension = 0;
};

/// Numbers of roots stated besides the list: top-level `counts`.
struct CountClaim {
  std::optional<std::uint64_t> complex, real;
};

struct Claims {
  ClaimForm form = ClaimForm::solve_json;
  std::vector<RootClaim> roots;
  std::uint64_t seed = 0;
  bool complete = false;  ///< every path was decided: the list has all isolated roots
  std::optional<SystemClaim> system;
  std::optional<ReducedClaim> reduced;
  std::optional<StartClaim> start;
  std::optional<PathClaim> paths;
  std::optional<std::uint64_t> failures;  ///< how many are listed
  std::uint64_t excess = 0;
  std::uint64_t left_out =
      0;  ///< roots where a denominator is zero, and roots that were not asked for
  std::optional<int> digits;
  std::optional<std::string> completeness;
  std::optional<BoundClaim> bound;  ///< the one that proves completeness
  CountClaim counts;
  std::vector<PlaneClaim> planes;
  std::optional<std::uint64_t> listed;  ///< how many roots a solution list announces
};

/// variables: of the system that the result is of; a solution list gives its coordinates by name.
/// Throws ParseError where the text is broken, std::invalid_argument with every fault where it is
/// no result.
Claims read_claims(const Source& source, const std::vector<std::string>& variables);

}  // namespace moivre
