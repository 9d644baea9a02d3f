// SPDX-License-Identifier: MIT
// Loop, cut, equations, all roots, joint values: one page of named steps.
#include "moivre/arms/arm_closures.h"

#include "equations.h"
#include "moivre/arms/rules.h"
#include "moivre/numeric/stopwatch.h"
#include "read_closures.h"

namespace moivre {
namespace {

/// Paths to all roots of the outside's equations; none where there is nothing outside.
SolveResult solve_outside(const System& system, const Tracker& tracker, SolveOptions options,
                          const std::atomic<bool>& stop) {
  if (system.variables.size() > 1) {
    options.eliminate = false;  // multilinear equations have nothing that pays
    if (options.start == StartKind::automatic) options.start = StartKind::multihomogeneous;
  }
  return solve(system, tracker, options, stop);
}

void take_account(const SolveResult& solved, ArmResult& result) {
  result.complete = solved.complete;
  result.start = solved.start;
  result.tracker = solved.tracker;
  result.tracker_options = solved.tracker_options;
  result.paths = solved.paths;
  result.failures = solved.failures;
  result.work = solved.work;
  result.time_s = solved.time;
}

}  // namespace

ArmResult find_arm_closures(const Arm& arm, const Eigen::Isometry3d& given, const Tracker& tracker,
                            const SolveOptions& options, const std::atomic<bool>& stop) {
  require_unbroken(arm);
  require_unbroken(validate(options));
  const Eigen::Isometry3d pose = workable_pose(given, "the pose");
  const Stopwatch watch;
  ArmResult result;
  result.seed = options.seed;
  result.pose = pose;
  const Loop loop = make_loop(arm, pose, options.seed);
  const Cut cut = choose_cut(loop);
  const System system = cut_equations(loop, cut, options.seed);
  std::vector<Solution> solutions;
  if (cut.outside.empty()) {
    result.complete = true;
    result.start.kind = "none";
    result.start.why = "the joints are read off";
    solutions.emplace_back();
  } else {
    SolveResult solved = solve_outside(system, tracker, options, stop);
    take_account(solved, result);
    solutions = std::move(solved.solutions);
    result.stages.push_back({names_of(arm, cut.outside), 1, result.paths});
  }
  read_closures(arm, loop, cut, solutions, result);
  result.time_s.total = watch.total();
  return result;
}

}  // namespace moivre
