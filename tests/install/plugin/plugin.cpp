// SPDX-License-Identifier: MIT
// A stranger's plugin: how many certified roots has a system? Wilkinson's polynomial of degree 15
// needs more digits than double's.
#include <moivre/polynomial/read.h>
#include <moivre/solver/solve.h>
#include <moivre/tracker_lanes/lane_tracker.h>
#include <moivre/version.h>

#if MOIVRE_VERSION < 100
#error "moivre/version.h has no version"
#endif

extern "C" int certified_roots() {
  std::string product = "(x - 1)";
  for (int k = 2; k <= 15; ++k) product += "*(x - " + std::to_string(k) + ")";
  const moivre::System system = moivre::read_system({"wilkinson", product + ";"});
  const auto tracker = moivre::make_lane_tracker();
  const moivre::SolveResult result = moivre::solve(system, *tracker);
  int certified = 0;
  for (const moivre::Solution& root : result.solutions) certified += root.certified.value_or(false);
  return certified;
}
