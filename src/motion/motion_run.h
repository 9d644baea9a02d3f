// SPDX-License-Identifier: MIT
// What is known of a motion while it is being found? The mechanism, the times, and the tracks that
// were followed so far.
//
// Tracks have a pose at all times, and velocities at those of the samples alone.
// Events are the same where they are of one kind, at one time and at one pose, as far as both are
// known: beside a dead point a pose moves with the root of the time.
#pragma once

#include "motion_times.h"
#include "track.h"

namespace moivre {

struct MotionRun {
  /// The mechanism, the options and `the_stop` must outlive it.
  MotionRun(const Mechanism& the_mechanism, const MotionOptions& the_options, MotionTimes the_times,
            const std::atomic<bool>& the_stop);
  MotionRun(const MotionRun&) = delete;  // the follower refers to the times
  MotionRun& operator=(const MotionRun&) = delete;

  const Mechanism& mechanism;
  const MotionOptions& options;
  const std::atomic<bool>& stop;
  const Phi phi;
  MotionTimes times;
  const TrackFollower follower;
  std::vector<Track> tracks;
  std::vector<BranchPose> instants;  ///< closures through which no branch leads
  std::vector<BranchEvent> sought;   ///< dead points from which a second branch was followed

  /// From now on tracks have a pose at that time, too.
  void add_time(double time);

  void show_progress(double share) const {
    if (options.progress) options.progress(share);
  }
};

bool is_same_event(const MotionRun& run, const BranchEvent& a, const BranchEvent& b);

/// Whether they are one time, but for rounding.
bool is_same_time(const MotionRun& run, double a, double b);

/// Whether the event is at that time, as far as it is known.
bool is_event_time(const MotionRun& run, const BranchEvent& event, double time);

/// Whether a track ends, either way, at that time in the pose q.
bool is_event_of_a_track(const MotionRun& run, double time, const Eigen::VectorXd& q);

/// Whether a track ends at a dead point between the times where no other track ends, the same way.
/// `track` is one of the run's.
bool lacks_partner(const MotionRun& run, const Track& track, bool is_forwards);

/// Whether the closure is there for an instant: more constraints than coordinates, and none of them
/// can hold a moment later, [Phi_q Phi_t] having full rank. Notes it in the run.
bool is_instant(MotionRun& run, double time, const Closure& closure);

/// Whether it was noted.
bool is_known_instant(const MotionRun& run, double time, const Eigen::VectorXd& q);

}  // namespace moivre
