// SPDX-License-Identifier: MIT
// Are the roots of a power flow the same in isotropic unknowns, which have a quarter of the paths,
// and the real ones real?
#include <gtest/gtest.h>

#include <algorithm>

#include "moivre/polynomial/read.h"
#include "moivre/solver/cross_check.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre::test {
namespace {

/// Voltages e + i f of five nodes that draw given powers, each joined to each and to a source of 1
/// + 0i.
System power_flow() {
  constexpr int kNodes = 5;
  std::string text = std::to_string(2 * kNodes) + "\n";
  const auto conductance = [](int k, int m) { return std::to_string(1 + (k * m + k + m) % 3); };
  const auto susceptance = [](int k, int m) { return std::to_string(4 + (2 * k * m + k + m) % 5); };
  for (int k = 1; k <= kNodes; ++k) {
    // The current into node k: the sum of (G + i B) (v_k - v_m), its parts.
    std::string re, im;
    const std::string e = "e" + std::to_string(k), f = "f" + std::to_string(k);
    for (int m = 0; m <= kNodes; ++m) {
      if (m == k) continue;
      const std::string em = m == 0 ? "1" : "e" + std::to_string(m);
      const std::string fm = m == 0 ? "0" : "f" + std::to_string(m);
      const int a = std::min(k, m), b = std::max(k, m);
      const std::string g = conductance(a, b), s = susceptance(a, b);
      re += " + " + g + "*(" + e + " - " + em + ") + " + s + "*(" + f + " - " + fm + ")";
      im += " + " + g + "*(" + f + " - " + fm + ") - " + s + "*(" + e + " - " + em + ")";
    }
    text += e + "*(0" + re + ") + " + f + "*(0" + im + ") + 0.1*" + std::to_string(k) + ";\n";
    text += f + "*(0" + re + ") - " + e + "*(0" + im + ") + 0.05;\n";
  }
  return read_system({"power flow", text});
}

std::uint64_t real_roots(const SolveResult& result) {
  return static_cast<std::uint64_t>(std::count_if(result.solutions.begin(), result.solutions.end(),
                                                  [](const Solution& s) { return s.real; }));
}

TEST(IsotropicUnknowns, HaveTheRootsOfThePowerFlowOnAQuarterOfThePaths) {
  const System f = power_flow();
  const auto lanes = make_lane_tracker();
  SolveOptions by_degrees = with_seed(1);
  by_degrees.start = StartKind::total_degree;
  const SolveResult whole = solve(f, *lanes, by_degrees);
  EXPECT_EQ(whole.reduced.isotropic_pairs, 0U);
  EXPECT_EQ(whole.paths.tracked, 1024U);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const SolveResult result = solve(f, *lanes, with_seed(seed));
    EXPECT_EQ(result.reduced.isotropic_pairs, 5U);
    EXPECT_EQ(result.paths.tracked, 252U);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.completeness, RootCompleteness::proved);
    EXPECT_EQ(result.solutions.size(), whole.solutions.size());
    EXPECT_EQ(compare(result, whole).missed, 0U);
    EXPECT_EQ(real_roots(result), real_roots(whole));
    EXPECT_GT(real_roots(result), 0U);
  }
}

TEST(IsotropicUnknowns, HaveTheSameRootsWithTheReferenceTracker) {
  const SolveResult result = solve_with_cvode(power_flow());
  EXPECT_EQ(result.paths.tracked, 252U);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
}

}  // namespace
}  // namespace moivre::test
