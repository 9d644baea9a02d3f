// SPDX-License-Identifier: MIT
// Where is a branch at each of the times, followed both ways from the pose at which it was found?
//
// Times in seconds, ascending; q: n coordinates as in Phi. Followed again, a track takes steps a
// quarter as long each time.
// Edges: an anchor at either end of the times is followed one way only, the other holds the anchor
// alone.
#pragma once

#include <vector>

#include "moivre/motion/motion.h"

namespace moivre {

/// One branch of the motion, as far as it is known.
struct Track {
  BranchPose anchor;       ///< a closure of a checkpoint, or a pose behind a dead point
  Branch forwards;         ///< from the anchor on
  Branch backwards;        ///< from the anchor back; not run where the anchor is at the beginning
  bool is_simple = false;  ///< the anchor is a simple closure: no branches cross there
  bool is_from_start = false;
  int retracked = 0;
  bool is_verified = false;  ///< followed back from its last checkpoints

  /// From its anchor on, or back.
  const Branch& way(bool is_forwards) const { return is_forwards ? forwards : backwards; }
  /// At which it ends: the one behind it, then the one ahead, those that there are. They are the
  /// track's own.
  std::vector<const BranchEvent*> events() const;
  double begins() const;
  double ends() const;
  int steps() const { return forwards.steps + backwards.steps; }
  int rejected() const { return forwards.rejected + backwards.rejected; }
  /// The sample at exactly this time; nullptr where the branch is not there.
  const BranchSample* at(double time) const;
};

/// How a track is followed: through all `times` (ascending), and shorter steps each time again. The
/// way back is for poses.
struct TrackFollower {
  const Mechanism& mechanism;
  const std::vector<double>& times;
  BranchOptions options;
  FollowBranch follow_branch;
  const std::atomic<bool>& stop;

  /// A way that ends at the anchor of a simple closure, as if branches crossed there, has failed:
  /// it cannot be followed.
  Track follow(const BranchPose& anchor, bool is_simple = false) const;
  void follow_again(Track& track) const;
  /// Adds the pose at a time between samples, where the branch is there.
  void add_sample(Track& track, double time) const;
  /// From a pose back through `backs` times, with steps that are not those of the way there.
  Branch follow_back(const BranchPose& pose, const std::vector<double>& backs,
                     const Track& track) const;

 private:
  /// Steps of the track, `share` of their own length.
  BranchOptions options_of(const Track& track, double share = 1) const;
  void run(Track& track) const;
};

}  // namespace moivre
