// SPDX-License-Identifier: MIT
// A motion before any track is followed, and which events are one.
#include "motion_run.h"

#include <algorithm>
#include <cmath>

#include "moivre/closures/same_pose.h"
#include "moivre/kinematics/own_units.h"

namespace moivre {
namespace {

double duration(const MotionRun& run) { return std::abs(run.options.to - run.options.from); }

bool is_near(const MotionRun& run, const BranchEvent& event, double time, double doubt) {
  return std::abs(event.time - time) <= std::max(kSameTime * duration(run), doubt);
}

/// Whether the event is at that time and pose. `uncertainty`: of `time`, beside the event's own.
bool is_at(const MotionRun& run, const BranchEvent& event, double time, const Eigen::VectorXd& q,
           double uncertainty) {
  const double doubt = event.uncertainty + uncertainty;
  const double place = std::sqrt(doubt / duration(run));
  return is_near(run, event, time, doubt) &&
         distance(run.phi, event.q, q) <= std::max(kSamePlace, place);
}

/// Velocities are for the samples; where closures may be compared poses do.
BranchOptions with_velocities_at(const std::vector<double>& times, BranchOptions options) {
  options.velocity_times = times;
  return options;
}

}  // namespace

MotionRun::MotionRun(const Mechanism& the_mechanism, const MotionOptions& the_options,
                     MotionTimes the_times, const std::atomic<bool>& the_stop)
    : mechanism(the_mechanism),
      options(the_options),
      stop(the_stop),
      phi(mechanism),
      times(std::move(the_times)),
      follower{mechanism, times.all, with_velocities_at(times.samples, options.branch),
               options.follow, stop} {}

void MotionRun::add_time(double time) {
  const auto at = std::lower_bound(times.all.begin(), times.all.end(), time);
  if (at != times.all.end() && *at == time) return;
  times.all.insert(at, time);
  for (Track& track : tracks) follower.add_sample(track, time);
}

bool is_same_event(const MotionRun& run, const BranchEvent& a, const BranchEvent& b) {
  return a.kind == b.kind && is_at(run, a, b.time, b.q, b.uncertainty);
}

bool is_same_time(const MotionRun& run, double a, double b) {
  return std::abs(a - b) <= kSameTime * duration(run);
}

bool is_event_time(const MotionRun& run, const BranchEvent& event, double time) {
  return is_near(run, event, time, event.uncertainty);
}

bool is_event_of_a_track(const MotionRun& run, double time, const Eigen::VectorXd& q) {
  return std::any_of(run.tracks.begin(), run.tracks.end(), [&](const Track& track) {
    const auto events = track.events();
    return std::any_of(events.begin(), events.end(),
                       [&](const BranchEvent* event) { return is_at(run, *event, time, q, 0); });
  });
}

bool lacks_partner(const MotionRun& run, const Track& track, bool is_forwards) {
  const Branch& way = track.way(is_forwards);
  if (!way.event || !way.beyond) return false;
  if (!(way.beyond->time > run.options.from && way.beyond->time < run.options.to)) return false;
  return std::none_of(run.tracks.begin(), run.tracks.end(), [&](const Track& other) {
    const auto& its_end = other.way(is_forwards).event;
    return &other != &track && its_end && is_same_event(run, *its_end, *way.event);
  });
}

bool is_instant(MotionRun& run, double time, const Closure& closure) {
  if (is_known_instant(run, time, closure.q)) return true;
  const Phi& phi = run.phi;
  // What closes by least squares alone has no curve of exact poses through it anywhere.
  if (phi.size() <= phi.dimension() || closure.is_fitted || closure.singular) return false;
  if (rank_of(phi, phi.extended_jacobian(closure.q, time)) <= phi.dimension()) return false;
  run.instants.push_back({time, closure.q});
  return true;
}

bool is_known_instant(const MotionRun& run, double time, const Eigen::VectorXd& q) {
  return std::any_of(run.instants.begin(), run.instants.end(), [&](const BranchPose& instant) {
    return instant.time == time && is_same_pose(run.phi, instant.q, q);
  });
}

}  // namespace moivre
