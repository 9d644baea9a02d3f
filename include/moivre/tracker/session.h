// SPDX-License-Identifier: MIT
// How is one path followed? A session follows path segments along contours, and says of each how
// far it came.
//
//   PathSegment     a path segment to be followed: a point and a contour from it
//   SegmentResult   its result: the last point that was reached, and the status (SegmentStatus)
//
// A source hands out segments. The tracker follows each as far as it can and gives the result
// back to the source. The source may then have further segments, such as an endgame's circles. A
// tracker with many lanes follows many segments at once, one with a single lane one after the
// other. A tracker decides nothing about roots: endgame/ judges the end of a path, and solver/
// keeps the counts.
//
// x: N homogeneous coordinates, s: contour parameter in [0, 1], t = contour(s).
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "moivre/homotopy/homotopy.h"
#include "moivre/tracker/contour.h"
#include "moivre/tracker/path_system.h"
#include "moivre/tracker/tracker.h"

namespace moivre {

/// One accepted step, as a watcher sees it. The spans are valid during the call only.
struct StepRecord {
  double s = 0;
  PathTime t{0.0};
  std::span<const Complex> x;
  double step = 0;        ///< in s
  int order = 0;          ///< of the predictor or integrator
  double drift = 0;       ///< max_i |H_i| before the Newton correction
  double correction = 0;  ///< |dx_1|_w of the first Newton correction; 0 without correction
};

/// Sees every accepted step of one segment, and may end it. Called by the thread that tracks.
class Watcher {
 public:
  virtual ~Watcher() = default;
  enum class Verdict { go_on, stop };
  virtual Verdict watch(const StepRecord& step, PathSystem& path) = 0;
};

struct PathSegment {
  std::uint64_t path = 0;
  Contour contour = Contour::segment(0, 1);
  Point x;  ///< N coordinates, on the path at contour(0) or near it
  /// 0: as the options say; each level more tracks with tighter tolerances.
  int tolerance_level = 0;
  int samples = 0;             ///< points wanted at s = 1/samples, 2/samples, ..., 1; 0: none
  Watcher* watcher = nullptr;  ///< not owned; nullptr: nobody watches
  /// The watcher sees the steps that end with |1 - t| no larger than this.
  double watch_radius = std::numeric_limits<double>::infinity();
  FramePointer frame = nullptr;  ///< the path's, where the homotopy is framed; x is in it
};

enum class SegmentStatus {
  arrived,         ///< s = 1 was reached, x is on the path there
  stopped,         ///< the watcher ended it
  bad_start,       ///< Newton does not converge from the segment's x
  step_limit,      ///< the budget of steps or evaluations is used up
  step_too_small,  ///< the step fell below the spacing of numbers
  off_path,        ///< the integrator reached s = 1, but Newton does not converge there
  cancelled        ///< the stop token was set
};

struct SegmentResult {
  SegmentStatus status = SegmentStatus::cancelled;
  Point x;       ///< last point on the path
  double s = 0;  ///< where on the contour
  PathTime t{0.0};
  StepCount count;
  std::vector<Point> samples;  ///< in the order of s; all of them if s = 1 was reached
  /// At t = 1, from trackers with more digits than double: condition of J, where Newton's method
  /// converged quadratically to a point that is known beyond double. nullopt: not tested.
  std::optional<double> regular_condition;
  double accuracy = 0;  ///< then: |dx| / |x| that x had before it was rounded to double
};

/// Hands out segments. `next` may be called by the thread of one session only.
class SegmentSource {
 public:
  virtual ~SegmentSource() = default;
  /// The next segment, or nullopt when there is none *now*. The session ends when it has no
  /// segment under way either.
  virtual std::optional<PathSegment> next() = 0;
  /// Takes the result of a segment. It may make further segments for `next`.
  virtual void arrived(const PathSegment& segment, SegmentResult&& reached) = 0;
};

/// The tracking of one thread. Owns all memory that a segment needs; allocates nothing per step.
class TrackerSession {
 public:
  virtual ~TrackerSession() = default;
  /// Until the source has no more segments. A set `stop` ends segments under way with
  /// SegmentStatus::cancelled. Throws what the source throws, and std::bad_alloc; segments under
  /// way are lost then, and the session is of no more use.
  virtual void run(SegmentSource& source, const std::atomic<bool>& stop) = 0;
};

/// session.run(). What the source throws is thrown here, when the segments under way have ended; no
/// others begin.
void run_session(TrackerSession& session, SegmentSource& source, const std::atomic<bool>& stop);

/// Follows one segment.
SegmentResult follow(TrackerSession& session, PathSegment segment, const std::atomic<bool>& stop);

}  // namespace moivre
