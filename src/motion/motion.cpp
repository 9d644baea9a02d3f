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
#include "motion_sentences.h"
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

/// number: of the guess, from 1.
void begin_track(MotionRun& run, const Eigen::VectorXd& guess, std::size_t number,
                 MotionResult& result) {
  const NewtonResult assembled = newton(run.phi, guess, run.options.from);
  const std::optional<double>& fit = run.mechanism.fit;
  const bool is_fitting =
      fit && assembled.q.allFinite() && misfit(run.phi, assembled.q, run.options.from) <= *fit;
  if (assembled.status != NewtonStatus::converged && !is_fitting) {
    result.failures.push_back(guess_failure(number, assembled.message));
    return;
  }
  for (const Track& track : run.tracks) {
    if (!is_same_pose(run.phi, track.anchor.q, assembled.q)) continue;
    result.left_out.push_back(repeated_guess_left_out(number));
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
  result.message = motion_message(run.stop          ? MotionVerdict::interrupted
                                  : result.complete ? MotionVerdict::followed
                                                    : MotionVerdict::undecided);
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
    result.message = motion_message(MotionVerdict::not_assembled);
  }
}

/// A line for each time at which closures are there that no branch leads through.
void tell_instants(const std::vector<BranchPose>& instants, MotionResult& result) {
  std::map<double, std::uint64_t> counts;
  for (const BranchPose& instant : instants) ++counts[instant.time];
  for (const auto& [time, count] : counts) {
    result.left_out.push_back(instants_left_out(count, time));
  }
}

bool has_limits(const Mechanism& mechanism) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(),
                     [](const Joint& joint) { return joint.limits.has_value(); });
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
    for (const double time : pairs.instants()) {
      result.left_out.push_back(touching_closures_left_out(time));
    }
    doubts = pairs.doubts();
    if (const auto sampled = pairs.sampled()) {
      result.left_out.push_back(short_branches_left_out(*sampled));
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
  for (const double time : crossings) {
    result.left_out.push_back(crossed_checkpoint_left_out(time));
  }
  conclude(run, result);
  tell_why_nothing_moves(checkpoints, result);
  if (options.checkpoints == 0) {
    result.left_out.push_back(later_checkpoints_left_out());
  } else if (has_limits(mechanism)) {
    result.left_out.push_back(hidden_branches_left_out());
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
    begin_track(run, guesses[k], k + 1, result);
    run.show_progress(static_cast<double>(k + 1) / static_cast<double>(guesses.size()));
  }
  enter_branches(run, result);
  tell_drawn(run, result);
  conclude(run, result);
  result.left_out.push_back(closures_left_out_by_guesses());
  result.time_s.total = watch.total();
  return result;
}

}  // namespace moivre
