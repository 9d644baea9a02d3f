// SPDX-License-Identifier: MIT
// From tracks to branches, events, rows of checkpoints, and what failed.
#include "motion_record.h"

#include <algorithm>
#include <numeric>

#include "moivre/mechanism/closure_id.h"
#include "motion_sentences.h"

namespace moivre {
namespace {

/// Whether branches lie before a dead point where they are known to lie behind it, or the other
/// way.
bool is_other_side(const MotionEvent& event, bool is_ending) {
  if (event.at.kind != EventKind::dead_point) return false;
  return is_ending ? event.ending.empty() : event.beginning.empty();
}

/// Index of the event in result.events, where it is entered if it is new.
std::size_t event_index(const MotionRun& run, const BranchEvent& event, bool is_ending,
                        MotionResult& result) {
  for (std::size_t k = 0; k < result.events.size(); ++k) {
    BranchEvent& known = result.events[k].at;
    if (!is_same_event(run, known, event) || is_other_side(result.events[k], is_ending)) continue;
    if (event.uncertainty < known.uncertainty) {
      known = event;
      result.events[k].drivers = driver_values(run.mechanism, event.time);
    }
    return k;
  }
  result.events.push_back({event, driver_values(run.mechanism, event.time), {}, {}});
  return result.events.size() - 1;
}

/// At the output times, by time; the anchor, which both ways begin with, once.
std::vector<BranchSample> samples_of(const MotionRun& run, const Track& track) {
  std::vector<BranchSample> samples;
  const auto take = [&](const BranchSample& sample) {
    if (run.times.is_sample(sample.time)) samples.push_back(sample);
  };
  for (std::size_t k = track.backwards.samples.size(); k-- > 1;) take(track.backwards.samples[k]);
  for (const BranchSample& sample : track.forwards.samples) take(sample);
  return samples;
}

void enter_events(const MotionRun& run, const Track& track, MotionBranch& branch,
                  MotionResult& result) {
  if (track.backwards.event) {
    branch.begin_event = event_index(run, *track.backwards.event, false, result);
    result.events[*branch.begin_event].beginning.push_back(branch.id);
  }
  if (track.forwards.event) {
    branch.end_event = event_index(run, *track.forwards.event, true, result);
    result.events[*branch.end_event].ending.push_back(branch.id);
  }
}

/// Where the one way of a track came to.
const Eigen::VectorXd& end_of(const Branch& way, const Track& track) {
  if (way.event) return way.event->q;
  return way.samples.empty() ? track.anchor.q : way.samples.back().q;
}

void enter_branch(const MotionRun& run, const Track& track, MotionResult& result) {
  MotionBranch branch;
  branch.id = closure_id(result.branches.size());
  branch.begins = track.begins();
  branch.ends = track.ends();
  branch.begin_pose = end_of(track.backwards, track);
  branch.end_pose = end_of(track.forwards, track);
  branch.ways = {track.backwards.pieces, track.forwards.pieces};
  branch.steps = track.steps();
  branch.retracked = track.retracked;
  branch.samples = samples_of(run, track);
  enter_events(run, track, branch, result);
  const auto is_decided = [](const Branch& way) {
    return way.status == BranchStatus::reached || way.status == BranchStatus::ended;
  };
  branch.complete = is_decided(track.forwards) && is_decided(track.backwards);
  branch.message = track.forwards.message;
  std::string told;  // what keeps it from leaving its anchor does so both ways
  for (const Branch* way : {&track.backwards, &track.forwards}) {
    if (way->status != BranchStatus::failed) continue;
    const double time = way == &track.forwards ? branch.ends : branch.begins;
    std::string failure = branch_failure(branch.id, time, way->message);
    if (failure != told) result.failures.push_back(failure);
    told = std::move(failure);
  }
  result.steps += track.steps();
  result.rejected += track.rejected();
  result.branches.push_back(std::move(branch));
}

/// Enters closures that no branch is at; returns the number of the others.
std::size_t enter_lone_closures(const MotionRun& run, const SolvedCheckpoint& solved,
                                Checkpoint& row, MotionResult& result) {
  std::size_t matched = 0;
  for (std::size_t j = 0; j < solved.track_of.size(); ++j) {
    const auto& owner = solved.track_of[j];
    const Closure& closure = solved.closures.closures[j];
    row.branches.push_back(owner ? result.branches[*owner].id : "");
    matched += owner ? 1 : 0;
    if (owner || is_event_of_a_track(run, solved.time, closure.q)) continue;
    if (is_known_instant(run, solved.time, closure.q)) continue;
    row.agrees = false;
    if (run.stop) continue;
    result.failures.push_back(closure_on_no_branch(closure.id, solved.time));
  }
  return matched;
}

/// Enters branches that are at no closure of their own; returns the number of all branches that are
/// there.
std::size_t enter_lone_branches(const MotionRun& run, const SolvedCheckpoint& solved,
                                Checkpoint& row, MotionResult& result) {
  const auto& found = solved.track_of;
  std::size_t present = 0;
  for (std::size_t k = 0; k < run.tracks.size(); ++k) {
    if (run.tracks[k].at(solved.time) == nullptr) continue;
    ++present;
    const bool is_found = std::find(found.begin(), found.end(), k) != found.end();
    if (is_found || solved.closures.moves) continue;
    row.agrees = false;
    if (run.stop) continue;
    result.failures.push_back(branch_without_closure(result.branches[k].id, solved.time));
  }
  return present;
}

}  // namespace

MotionResult empty_result(const MotionOptions& options, const MotionTimes& times) {
  MotionResult result;
  result.from = options.from;
  result.to = options.to;
  result.times = times.samples;
  result.seed = options.solve.seed;
  return result;
}

void drop_moments(MotionRun& run) {
  const auto is_moment = [](const Track& track) { return track.begins() == track.ends(); };
  std::vector<BranchEvent> met;  // copied: tracks move while others are dropped
  for (const Track& track : run.tracks) {
    if (is_moment(track)) continue;
    for (const BranchEvent* event : track.events()) met.push_back(*event);
  }
  std::erase_if(run.tracks, [&](const Track& track) {
    if (!is_moment(track) || track.events().empty()) return false;
    const BranchEvent& event = *track.events().back();
    return std::any_of(met.begin(), met.end(),
                       [&](const BranchEvent& other) { return is_same_event(run, other, event); });
  });
}

void order_tracks(MotionRun& run) {
  std::vector<double> times;
  for (const Track& track : run.tracks) times.push_back(track.begins());
  std::sort(times.begin(), times.end());
  // Of times that differ by rounding the first alone.
  const auto is_same = [&](double a, double b) { return is_same_time(run, a, b); };
  times.erase(std::unique(times.begin(), times.end(), is_same), times.end());
  const auto time_of = [&](const Track& track) {
    return *(std::upper_bound(times.begin(), times.end(), track.begins()) - 1);
  };
  std::stable_sort(run.tracks.begin(), run.tracks.end(), [&](const Track& a, const Track& b) {
    if (a.is_from_start != b.is_from_start) return a.is_from_start;
    return !a.is_from_start && time_of(a) < time_of(b);
  });
}

void keep_events(const std::vector<std::size_t>& kept, MotionResult& result) {
  std::vector<MotionEvent> events;
  std::vector<std::size_t> place(result.events.size());
  for (const std::size_t k : kept) {
    place[k] = events.size();
    events.push_back(std::move(result.events[k]));
  }
  result.events = std::move(events);
  for (MotionBranch& branch : result.branches) {
    if (branch.begin_event) branch.begin_event = place[*branch.begin_event];
    if (branch.end_event) branch.end_event = place[*branch.end_event];
  }
}

void order_events(MotionResult& result) {
  std::vector<std::size_t> order(result.events.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return result.events[a].at.time < result.events[b].at.time;
  });
  keep_events(order, result);
}

void enter_branches(const MotionRun& run, MotionResult& result) {
  for (const Track& track : run.tracks) enter_branch(run, track, result);
  order_events(result);
}

void enter_checkpoint(const MotionRun& run, const SolvedCheckpoint& solved, MotionResult& result) {
  Checkpoint row;
  row.time = solved.time;
  row.drivers = driver_values(run.mechanism, solved.time);
  row.counts = solved.closures.counts;
  row.paths = solved.closures.paths;
  row.agrees = solved.closures.complete;
  row.message = solved.closures.message;
  const std::size_t matched = enter_lone_closures(run, solved, row, result);
  const std::size_t present = enter_lone_branches(run, solved, row, result);
  if (row.agrees) {
    row.message = one_to_one(matched, present);
  } else if (run.stop) {
    row.message = kNotCompared;
  } else if (!solved.closures.complete) {
    result.failures.push_back(closures_failure(solved.time, solved.closures.message));
  }
  result.checkpoints.push_back(std::move(row));
}

void enter_unverified(const MotionRun& run, MotionResult& result) {
  for (std::size_t k = 0; k < run.tracks.size() && !run.stop; ++k) {
    if (run.tracks[k].is_verified) continue;
    result.failures.push_back(branch_takes_another_way(result.branches[k].id));
  }
}

void enter_unmet(const MotionRun& run, MotionResult& result) {
  for (std::size_t k = 0; k < run.tracks.size() && !run.stop; ++k) {
    for (const bool is_forwards : {false, true}) {
      if (!lacks_partner(run, run.tracks[k], is_forwards)) continue;
      const double time = run.tracks[k].way(is_forwards).event->time;
      result.failures.push_back(branch_unmet_at_dead_point(result.branches[k].id, time));
    }
  }
}

}  // namespace moivre
