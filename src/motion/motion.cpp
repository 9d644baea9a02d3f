// SPDX-License-Identifier: MIT
// The motion: closures at checkpoints, tracks through them, both reconciled and put into the
// result.
#include "moivre/motion/motion.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "moivre/closures/drawn_closure.h"
#include "moivre/closures/idle_joints.h"
#include "moivre/closures/same_pose.h"
#include "moivre/closures/sub_chains.h"
#include "moivre/kinematics/newton.h"
#include "moivre/motion/circuits.h"
#include "moivre/numeric/stopwatch.h"
#include "motion_product.h"
#include "motion_record.h"
#include "pair_search.h"
#include "reconcile.h"
#include "solved_checkpoint.h"

namespace moivre {
namespace {

/// A track from every closure at `from`.
void begin_tracks(MotionRun& run, const std::vector<SolvedCheckpoint>& checkpoints) {
  if (checkpoints.empty()) return;
  const SolvedCheckpoint& first = checkpoints.front();
  const auto& closures = first.closures.closures;
  const auto count = static_cast<double>(closures.size());
  for (std::size_t k = 0; k < closures.size(); ++k) {
    if (run.stop) return;
    if (is_instant(run, first.time, closures[k])) continue;
    run.tracks.push_back(
        run.follower.follow({first.time, closures[k].q}, stands_alone(run.phi, first, k)));
    run.show_progress(0.5 + 0.5 * static_cast<double>(run.tracks.size()) / count);
  }
}

void begin_track(MotionRun& run, const Eigen::VectorXd& guess, const std::string& name,
                 MotionResult& result) {
  const NewtonResult assembled = newton(run.phi, guess, run.options.from);
  const std::optional<double>& fit = run.mechanism.fit;
  const bool is_fitting =
      fit && assembled.q.allFinite() && misfit(run.phi, assembled.q, run.options.from) <= *fit;
  if (assembled.status != NewtonStatus::converged && !is_fitting) {
    result.failures.push_back(name + ": Newton-Raphson " + assembled.message);
    return;
  }
  for (const Track& track : run.tracks) {
    if (!is_same_pose(run.phi, track.anchor.q, assembled.q)) continue;
    result.left_out.push_back({name, "it assembles where an earlier guess does"});
    return;
  }
  run.tracks.push_back(run.follower.follow({run.options.from, run.phi.canonical(assembled.q)}));
}

void count_work(const std::vector<SolvedCheckpoint>& checkpoints, MotionResult& result) {
  for (const SolvedCheckpoint& solved : checkpoints) {
    result.paths += solved.closures.paths;
    result.time_s.threads = std::max(result.time_s.threads, solved.closures.time_s.threads);
  }
}

void conclude(const MotionRun& run, MotionResult& result) {
  const bool is_whole = std::all_of(result.branches.begin(), result.branches.end(),
                                    [](const MotionBranch& branch) { return branch.complete; });
  result.complete = is_whole && result.failures.empty() && !run.stop;
  result.message = run.stop          ? "interrupted: what is finished is reported"
                   : result.complete ? "every branch was followed to an event or to the end"
                                     : "not everything was decided: see failures";
}

/// Names the branch that begins in the drawn pose.
void tell_drawn(const MotionRun& run, MotionResult& result) {
  const auto drawn = drawn_closure(run.mechanism, run.phi, result.from);
  if (!drawn) return;
  for (const std::size_t k : first_branches(result)) {
    const MotionBranch& branch = result.branches[k];
    if (!is_same_pose(run.phi, run.phi.canonical(branch.begin_pose), *drawn)) continue;
    result.drawn = branch.id;
    return;
  }
}

/// The message of a motion whose branches say nothing of how it went.
void tell_why_nothing_moves(const std::vector<SolvedCheckpoint>& checkpoints,
                            MotionResult& result) {
  if (!result.complete) return;
  if (!checkpoints.empty() && checkpoints.front().closures.moves) {
    result.message = checkpoints.front().closures.message;
  } else if (result.branches.empty()) {
    result.message = "cannot be assembled at any checkpoint";
  }
}

/// The same of each of these times.
void tell_times(const std::vector<double>& times, const std::string& what, const std::string& why,
                MotionResult& result) {
  for (const double time : times) result.left_out.push_back({what + at_time(time), why});
}

/// A line for each time at which closures are there that no branch leads through.
void tell_instants(const std::vector<BranchPose>& instants, MotionResult& result) {
  std::map<double, std::uint64_t> counts;
  for (const BranchPose& instant : instants) ++counts[instant.time];
  for (const auto& [time, count] : counts) {
    result.left_out.push_back(
        {std::to_string(count) + (count == 1 ? " closure " : " closures ") + at_time(time),
         "the constraints are compatible for an instant only: no branch passes through"});
  }
}

bool has_limits(const Mechanism& mechanism) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(),
                     [](const Joint& joint) { return joint.limits.has_value(); });
}

LeftOut left_unseen(const MotionOptions& options) {
  if (options.checkpoints > 0) {
    return {
        "branches that begin and end between two checkpoints, and meet no others except at a joint "
        "limit",
        "they may be missed: between two checkpoints, what joint limits hide is looked at only 16 "
        "times"};
  }
  return {"checkpoints",
          "none were asked for: branches that begin later are not found, and exchanged branches "
          "not noticed"};
}

}  // namespace

MotionResult find_motion_of_whole(const Mechanism& mechanism, const Tracker& tracker,
                                  const MotionOptions& options, const std::atomic<bool>& stop) {
  const Stopwatch watch;
  MotionRun run(mechanism, options, motion_times(options, options.checkpoints), stop);
  MotionResult result = empty_result(options, run.times);
  result.tracker = tracker.kind();
  result.tracker_options = tracker.options_in_force();
  std::vector<SolvedCheckpoint> checkpoints = solve_checkpoints(run, tracker);
  result.time_s.track = watch.total();
  begin_tracks(run, checkpoints);
  reconcile(run, checkpoints);
  std::vector<std::string> doubts;
  std::vector<double> crossings = drop_crossings(run, checkpoints);
  if (options.checkpoints > 0 && !mechanism.drivers.empty() && !checkpoints.empty()) {
    PairSearch pairs(run, tracker);
    if (look_closer(run, tracker, checkpoints)) reconcile(run, checkpoints);
    search_pairs(run, tracker, checkpoints, pairs);
    const std::vector<double> found = drop_crossings(run, checkpoints);
    crossings.insert(crossings.end(), found.begin(), found.end());
    tell_times(pairs.instants(), "closures ",
               "complex closures meet there and separate again: a pose for an instant", result);
    doubts = pairs.doubts();
    if (const auto sampled = pairs.sampled()) {
      result.left_out.push_back({"a short branch, if there is one", *sampled});
    }
  }
  drop_moments(run);
  order_tracks(run);
  for (SolvedCheckpoint& solved : checkpoints) match(run, solved);
  enter_branches(run, result);
  tell_drawn(run, result);
  for (const SolvedCheckpoint& solved : checkpoints) enter_checkpoint(run, solved, result);
  enter_unverified(run, result);
  enter_unmet(run, result);
  std::move(doubts.begin(), doubts.end(), std::back_inserter(result.failures));
  count_work(checkpoints, result);
  tell_instants(run.instants, result);
  tell_times(
      crossings, "the checkpoint ",
      "branches cross there and closures are not all isolated or apart: they were compared on "
      "both sides of it",
      result);
  conclude(run, result);
  tell_why_nothing_moves(checkpoints, result);
  if (options.checkpoints == 0 || has_limits(mechanism)) {
    result.left_out.push_back(left_unseen(options));
  }
  result.time_s.total = watch.total();
  return result;
}

MotionResult find_motion(const Mechanism& mechanism, const Tracker& tracker,
                         const MotionOptions& options, const std::atomic<bool>& stop) {
  require_workable(mechanism, options);
  const Stopwatch watch;
  const HeldMechanism held = hold_idle(mechanism);
  const std::vector<IndependentChain> chains = independent_chains(held.mechanism);
  MotionResult result = chains.empty()
                            ? find_motion_of_whole(held.mechanism, tracker, options, stop)
                            : find_motion_apart(held.mechanism, chains, tracker, options, stop);
  result.idle = held.idle;
  result.time_s.total = watch.total();
  return result;
}

MotionResult follow_guesses(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& guesses,
                            const MotionOptions& options, const std::atomic<bool>& stop) {
  require_workable(mechanism, options);
  const Stopwatch watch;
  const HeldMechanism held = hold_idle(mechanism);
  MotionRun run(held.mechanism, options, motion_times(options, 0), stop);
  MotionResult result = empty_result(options, run.times);
  result.idle = held.idle;
  for (std::size_t k = 0; k < guesses.size() && !stop; ++k) {
    begin_track(run, guesses[k], "guess " + std::to_string(k + 1), result);
    run.show_progress(static_cast<double>(k + 1) / static_cast<double>(guesses.size()));
  }
  enter_branches(run, result);
  tell_drawn(run, result);
  conclude(run, result);
  result.left_out.push_back(
      {"closures and checkpoints", "the motion starts from guesses: no polynomials were solved"});
  result.time_s.total = watch.total();
  return result;
}

}  // namespace moivre
