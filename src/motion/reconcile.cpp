// SPDX-License-Identifier: MIT
// Conflicts at checkpoints, closures without tracks, partners at dead points, and the way back.
#include "reconcile.h"

#include <algorithm>

#include "moivre/closures/same_pose.h"

namespace moivre {
namespace {

// Each round follows with a quarter of the step.
constexpr int kMaximumRetracks = 4;
// New tracks bring new partners and new conflicts; each round settles all it sees.
constexpr int kRounds = 20;

bool is_same_all_along(const MotionRun& run, const std::vector<SolvedCheckpoint>& checkpoints,
                       const Track& a, const Track& b) {
  return std::all_of(checkpoints.begin(), checkpoints.end(), [&](const SolvedCheckpoint& solved) {
    const BranchSample* of_a = a.at(solved.time);
    const BranchSample* of_b = b.at(solved.time);
    if (of_a == nullptr || of_b == nullptr) return of_a == of_b;
    return is_same_pose(run.phi, of_a->q, of_b->q);
  });
}

/// Two tracks at one closure: the younger goes where it is a copy, else both are followed again
/// with shorter steps.
/// False when nothing more can be done.
bool part(MotionRun& run, const std::vector<SolvedCheckpoint>& checkpoints, std::size_t first,
          std::size_t second) {
  Track& older = run.tracks[first];
  Track& younger = run.tracks[second];
  if (!younger.is_from_start && is_same_all_along(run, checkpoints, older, younger)) {
    run.tracks.erase(run.tracks.begin() + static_cast<std::ptrdiff_t>(second));
    return true;
  }
  if (younger.retracked >= kMaximumRetracks) return false;
  run.follower.follow_again(older);
  run.follower.follow_again(younger);
  return true;
}

/// True when a track was changed or added, so that the checkpoints want another look.
bool settle(MotionRun& run, const std::vector<SolvedCheckpoint>& checkpoints,
            SolvedCheckpoint& solved) {
  const auto conflict = match(run, solved);
  if (conflict && part(run, checkpoints, conflict->first, conflict->second)) return true;
  for (std::size_t j = 0; j < solved.track_of.size() && !run.stop; ++j) {
    const Closure& closure = solved.closures.closures[j];
    if (solved.track_of[j] || is_event_of_a_track(run, solved.time, closure.q)) continue;
    if (is_instant(run, solved.time, closure)) continue;
    run.tracks.push_back(
        run.follower.follow({solved.time, closure.q}, stands_alone(run.phi, solved, j)));
    return true;
  }
  return false;
}

bool is_sought(const MotionRun& run, const BranchEvent& event) {
  return std::any_of(run.sought.begin(), run.sought.end(),
                     [&](const BranchEvent& other) { return is_same_event(run, event, other); });
}

/// A branch that meets another at its dead point may live between two checkpoints only. True when
/// one was sought, which is done once for each dead point: what sets out beyond it and ends
/// elsewhere may come back to it when it is followed again, but never by being sought again.
bool add_partner(MotionRun& run) {
  for (std::size_t k = 0; k < run.tracks.size() && !run.stop; ++k) {
    for (const bool is_forwards : {true, false}) {
      if (!lacks_partner(run, run.tracks[k], is_forwards)) continue;
      const Branch& way = run.tracks[k].way(is_forwards);
      if (is_sought(run, *way.event)) continue;
      run.sought.push_back(*way.event);
      const BranchPose beyond = *way.beyond;
      run.tracks.push_back(run.follower.follow(beyond));
      return true;
    }
  }
  return false;
}

/// The checkpoints that a track passes, determined, one way from its anchor: where to turn back,
/// and the times of the way.
struct WayBack {
  const SolvedCheckpoint* last = nullptr;  ///< the farthest from the anchor; nullptr: there is none
  std::vector<double> times;               ///< from there to the anchor
};

WayBack way_back(const std::vector<SolvedCheckpoint>& checkpoints, const Track& track,
                 bool is_forwards) {
  WayBack back;
  back.times.push_back(track.anchor.time);
  for (const SolvedCheckpoint& solved : checkpoints) {
    const bool is_on_the_way =
        is_forwards ? solved.time > track.anchor.time : solved.time < track.anchor.time;
    const BranchSample* sample = track.at(solved.time);
    if (!is_on_the_way || sample == nullptr || !sample->is_determined) continue;
    if (back.last == nullptr || is_forwards) back.last = &solved;
    back.times.insert(is_forwards ? back.times.begin() : back.times.end() - 1, solved.time);
  }
  return back;
}

/// Whether the way back, from the closure that was solved at the track's last checkpoint, is the
/// way there.
bool leads_back(const MotionRun& run, const std::vector<SolvedCheckpoint>& checkpoints,
                const Track& track, bool is_forwards) {
  const WayBack way = way_back(checkpoints, track, is_forwards);
  if (way.last == nullptr) return true;
  const auto start = nearest_closure(run.phi, *way.last, track.at(way.last->time)->q);
  if (!start) return true;
  const Eigen::VectorXd& q = way.last->closures.closures[*start].q;
  const Branch back = run.follower.follow_back({way.last->time, q}, way.times, track);
  if (back.samples.size() != way.times.size()) return run.stop;
  return std::all_of(back.samples.begin(), back.samples.end(), [&](const BranchSample& sample) {
    const BranchSample* there = track.at(sample.time);
    return there != nullptr && is_same_pose(run.phi, sample.q, there->q);
  });
}

/// Follows tracks back; those that do not lead back are followed again. True when there were such.
bool verify(MotionRun& run, const std::vector<SolvedCheckpoint>& checkpoints) {
  bool is_changed = false;
  for (Track& track : run.tracks) {
    if (track.is_verified || track.retracked > kMaximumRetracks || run.stop) continue;
    if (leads_back(run, checkpoints, track, true) && leads_back(run, checkpoints, track, false)) {
      track.is_verified = true;
      continue;
    }
    run.follower.follow_again(track);
    is_changed = true;
  }
  return is_changed;
}

}  // namespace

void reconcile(MotionRun& run, std::vector<SolvedCheckpoint>& checkpoints) {
  for (int round = 0; round < kRounds * static_cast<int>(1 + run.tracks.size()) && !run.stop;
       ++round) {
    bool is_settled = true;
    for (SolvedCheckpoint& solved : checkpoints)
      is_settled = is_settled && !settle(run, checkpoints, solved);
    if (is_settled) is_settled = !add_partner(run);
    if (is_settled) is_settled = !verify(run, checkpoints);
    if (is_settled) return;
  }
}

}  // namespace moivre
