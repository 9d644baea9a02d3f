// SPDX-License-Identifier: MIT
// What do the tests of solve() share? Problems of the index by name, solving with CVODE, and the
// law every result keeps.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

#include "moivre/certify/certifier.h"
#include "moivre/polynomial/read.h"
#include "moivre/solver/solve.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "problem_index.h"

namespace moivre::test {

inline const std::string kProblemFolder = MOIVRE_SOURCE_DIR "/problems/polynomials";

inline const std::vector<problems::Problem>& problem_index() {
  static const std::vector<problems::Problem> index = problems::read_index(kProblemFolder);
  return index;
}

inline const problems::Problem& problem(std::string_view name) {
  for (const problems::Problem& p : problem_index()) {
    if (p.name == name) return p;
  }
  throw std::invalid_argument("no problem " + std::string(name));
}

/// Not every path is decided for every seed: a root of multiplicity 10 at x = 1 is close to a start
/// root for some. Such a run is to say so. And of ipp2 some of 272 ends at infinity have a face
/// with a singular root that double does not show.
inline bool is_beyond_reach(const problems::Problem& p) {
  return p.name == "tenfold" || p.name == "ipp2" ||
         (p.name == "wilkinson-20" && !proves_beyond_double());
}

inline System read(const std::string& text) { return read_system({"test", text}); }

inline System system_of(const problems::Problem& p) {
  return read_system(read_source(kProblemFolder + "/" + p.file));
}

inline SolveOptions with_seed(std::uint64_t seed, int threads = 1) {
  SolveOptions options;
  options.seed = seed;
  options.threads = threads;
  return options;
}

inline SolveResult solve_with_cvode(const System& f, const SolveOptions& options = with_seed(1)) {
  return solve(f, *make_cvode_tracker(), options);
}

inline std::uint64_t sum_of_multiplicities(const SolveResult& result) {
  std::uint64_t sum = 0;
  for (const Solution& s : result.solutions) sum += s.multiplicity;
  return sum;
}

/// tracked = finite + at_infinity + failed + not_needed, finite = sum of multiplicities + ends on
/// sets, sum(winding) = multiplicity.
inline void expect_conservation(const SolveResult& result) {
  const PathCounts& paths = result.paths;
  EXPECT_EQ(paths.tracked, paths.finite + paths.at_infinity + paths.failed + paths.not_needed);
  EXPECT_EQ(paths.finite,
            sum_of_multiplicities(result) + paths.on_positive_dimensional + result.excess);
  EXPECT_EQ(paths.failed, result.failures.size());
  EXPECT_EQ(paths.by_count, static_cast<std::uint64_t>(std::count_if(
                                result.ledger.begin(), result.ledger.end(),
                                [](const PathRecord& path) { return path.by_count; })));
  EXPECT_LE(paths.retracked, result.start.paths);
  EXPECT_LE(paths.mixed, paths.finite);
  EXPECT_LE(paths.mixed + paths.double_double + paths.multiprecision, paths.tracked);
  if (result.complete) {
    EXPECT_EQ(paths.tracked, result.start.paths);
    EXPECT_EQ(paths.failed, 0U);
  }
  for (const Solution& s : result.solutions) {
    if (!s.winding.empty()) {
      EXPECT_EQ(std::accumulate(s.winding.begin(), s.winding.end(), 0),
                static_cast<int>(s.multiplicity));
    }
    EXPECT_EQ(s.singular, s.multiplicity > 1);
  }
}

/// Number of solutions of each multiplicity.
inline std::map<std::uint64_t, std::uint64_t> multiplicities(const SolveResult& result) {
  std::map<std::uint64_t, std::uint64_t> counts;
  for (const Solution& s : result.solutions) ++counts[s.multiplicity];
  return counts;
}

inline std::uint64_t real_count(const SolveResult& result) {
  return static_cast<std::uint64_t>(std::count_if(result.solutions.begin(), result.solutions.end(),
                                                  [](const Solution& s) { return s.real; }));
}

/// The counts that the index proves or verified; paths to infinity where no linear equation was
/// used up.
inline void expect_counts_of_index(const SolveResult& result, const problems::Problem& p) {
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.solutions.size(), p.roots.distinct);
  EXPECT_EQ(real_count(result), p.roots.real);
  std::map<std::uint64_t, std::uint64_t> expected;
  for (const auto& count : p.roots.multiplicities) expected[count.multiplicity] += count.points;
  EXPECT_EQ(multiplicities(result), expected);
  if (p.at_infinity && result.start.paths > 0) {
    EXPECT_EQ(result.paths.at_infinity + result.paths.not_needed,
              result.start.paths - p.roots.with_multiplicity);
  }
}

inline double distance(const Point& x, const Point& y) {
  double largest = 0;
  double size = 1;
  for (std::size_t i = 0; i < x.size(); ++i) {
    largest = std::max(largest, std::abs(x[i] - y[i]));
    size = std::max(size, std::abs(y[i]));
  }
  return largest / size;
}

/// Solutions within `within` of x, relative to max(1, |x|).
inline std::size_t solutions_near(const SolveResult& result, const Point& x, double within) {
  return static_cast<std::size_t>(
      std::count_if(result.solutions.begin(), result.solutions.end(),
                    [&](const Solution& s) { return distance(s.x, x) <= within; }));
}

}  // namespace moivre::test
