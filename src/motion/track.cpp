// SPDX-License-Identifier: MIT
// Tracks: two branches from one anchor.
#include "track.h"

#include <algorithm>
#include <cmath>

#include "motion_sentences.h"

namespace moivre {
namespace {

// A quarter of the step: a branch that was lost at one length is seldom lost at the next.
constexpr double kTighter = 0.25;
// Of the steps on the way back: what one length jumps over another does not.
constexpr double kOther = 0.6;

/// The place of a time among samples that go one way in time.
template <class Samples>
auto place_of(double time, bool is_forwards, Samples& samples) {
  return std::partition_point(samples.begin(), samples.end(), [&](const BranchSample& sample) {
    return is_forwards ? sample.time < time : sample.time > time;
  });
}

/// Where a branch came to: its event, its last sample, or `anchor`.
double reached(const Branch& branch, double anchor) {
  if (branch.event) return branch.event->time;
  return branch.samples.empty() ? anchor : branch.samples.back().time;
}

/// An event at the anchor of a simple closure: the branch fails instead, since no branches cross
/// there.
void refuse_crossing_at(double time, Branch& branch) {
  if (!branch.event || branch.event->kind != EventKind::bifurcation || branch.event->time != time) {
    return;
  }
  branch.event.reset();
  branch.status = BranchStatus::failed;
  branch.message = not_followed_from_closure();
}

}  // namespace

double Track::begins() const { return reached(backwards, anchor.time); }

double Track::ends() const { return reached(forwards, anchor.time); }

const BranchSample* Track::at(double time) const {
  const bool is_forwards = time >= anchor.time;
  const auto& samples = way(is_forwards).samples;
  const auto at = place_of(time, is_forwards, samples);
  return at != samples.end() && at->time == time ? &*at : nullptr;
}

std::vector<const BranchEvent*> Track::events() const {
  std::vector<const BranchEvent*> all;
  for (const Branch* one : {&backwards, &forwards}) {
    if (one->event) all.push_back(&*one->event);
  }
  return all;
}

BranchOptions TrackFollower::options_of(const Track& track, double share) const {
  BranchOptions steps = options;
  const double tighter = std::pow(kTighter, track.retracked);
  steps.largest_turn_rad *= share * tighter;
  steps.largest_miss *= share * tighter;
  steps.longest_step *= share * tighter;
  // No length: how carefully a crossing is come to is the same there and back.
  steps.largest_approach *= tighter;
  return steps;
}

Branch TrackFollower::follow_back(const BranchPose& pose, const std::vector<double>& backs,
                                  const Track& track) const {
  BranchOptions steps = options_of(track, kOther);
  steps.velocity_times.emplace();
  return follow_branch(mechanism, pose.q, backs, steps, stop);
}

void TrackFollower::add_sample(Track& track, double time) const {
  if (time < track.begins() || time > track.ends()) return;
  const bool is_forwards = time >= track.anchor.time;
  std::vector<BranchSample>& samples = (is_forwards ? track.forwards : track.backwards).samples;
  const auto next = place_of(time, is_forwards, samples);
  if (next == samples.begin()) return;
  BranchOptions steps = options_of(track);
  steps.velocity_times.emplace();
  const BranchSample& before = *(next - 1);
  Branch way = follow_branch(mechanism, before.q, {before.time, time}, steps, stop);
  if (way.samples.size() == 2) samples.insert(next, std::move(way.samples.back()));
}

void TrackFollower::run(Track& track) const {
  const BranchOptions steps = options_of(track);
  for (const bool is_forwards : {true, false}) {
    std::vector<double> ahead;
    for (const double time : times) {
      if (is_forwards ? time > track.anchor.time : time < track.anchor.time) ahead.push_back(time);
    }
    if (!is_forwards) std::reverse(ahead.begin(), ahead.end());
    Branch& way = is_forwards ? track.forwards : track.backwards;
    way = {};
    way.status = BranchStatus::reached;
    way.message = followed_to_the_end();
    if (ahead.empty()) continue;
    ahead.insert(ahead.begin(), track.anchor.time);
    way = follow_branch(mechanism, track.anchor.q, ahead, steps, stop);
    if (track.is_simple) refuse_crossing_at(track.anchor.time, way);
  }
  // At the end of the times the way on has nothing to do but to hold the anchor.
  std::vector<BranchSample>& samples = track.forwards.samples;
  if (samples.empty()) samples.push_back(track.backwards.samples.front());
}

Track TrackFollower::follow(const BranchPose& anchor, bool is_simple) const {
  Track track;
  track.anchor = anchor;
  track.is_simple = is_simple;
  track.is_from_start = anchor.time == times.front();
  run(track);
  return track;
}

void TrackFollower::follow_again(Track& track) const {
  track.is_verified = false;
  ++track.retracked;
  run(track);
}

}  // namespace moivre
