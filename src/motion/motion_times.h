// SPDX-License-Identifier: MIT
// At which times is a motion looked at? Samples for the caller, checkpoints for the closures, and finer ones between these.
//
//   samples       from + k (to - from) / steps
//   fine times    from + k (to - from) / (checkpoints kFiner); every kFiner-th is a checkpoint, the others may become one
//   all           both, ascending; a time that is in both but for rounding once, as it stands among the samples
//
// Tracks have a pose at every one of `all`, so that any of them can be compared with closures. Seconds.
// Edges: without checkpoints after `from` there is one fine time, `from` itself.
#pragma once

#include <string>
#include <vector>

#include "moivre/motion/motion.h"

namespace moivre {

/// Between two checkpoints, where closures are complex and a branch could begin and end, closures are solved so often.
inline constexpr int kFiner = 16;

struct MotionTimes {
  double from = 0;
  double to = 0;
  int fine_steps = 0;  ///< fine times are 0 .. fine_steps
  std::vector<double> samples;
  std::vector<double> all;

  /// The fine time number k as it stands in `all`.
  double fine(int k) const;
  bool is_sample(double time) const;
};

/// As a message says it.
std::string at_time(double time);

/// checkpoints: after `from`; 0 where no closures are solved.
MotionTimes motion_times(const MotionOptions& options, int checkpoints);

}  // namespace moivre
