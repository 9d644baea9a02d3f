// SPDX-License-Identifier: MIT
// At which times is a motion looked at? Samples for the caller, and checkpoints for the closures.
//
//   samples       from + k (to - from) / steps
//   checkpoints   from + k (to - from) / checkpoints; as it stands among the samples where it is
//                 one of them but for rounding
//   all           both, ascending
//
// Tracks have a pose at every one of `all`, so that any of them can be compared with closures.
// Seconds.
// Edges: without checkpoints after `from` there is one, `from` itself.
#pragma once

#include <vector>

#include "moivre/motion/motion.h"

namespace moivre {

/// Of a motion's duration: times nearer to each other than this may be one.
inline constexpr double kSameTime = 1e-7;

struct MotionTimes {
  std::vector<double> samples;
  std::vector<double> checkpoints;
  std::vector<double> all;

  bool is_sample(double time) const;
};

/// checkpoints: after `from`; 0 where no closures are solved.
MotionTimes motion_times(const MotionOptions& options, int checkpoints);

}  // namespace moivre
