// SPDX-License-Identifier: MIT
// How far does a lane step, and is the step accepted? The segment of one lane, without its
// arithmetic.
//
//   e = |dx_1|_w: how far the prediction was off the path;  theta = |dx_2|_w / |dx_1|_w: Newton's
//   contraction accepted: e <= kSlack tolerance and theta <= kContraction: the prediction lies
//   where Newton converges at once next step: h <- h min(tolerance / e, kContractionAimedAt /
//   theta)^{1/p}, within bounds: both e and theta grow like the predictor's error, of order p.
//
// theta is proportional to the distance from the path over the distance to the nearest other path
// or singularity (the Newton-Kantorovich quantity), so where paths come close it shortens the steps
// before e does.
// A sample and the end are polished by steps of length 0, in double-double also what a watcher sees
// near t = 1. Where rounding stops Newton in a lane, the point is handed to scalar Newton with
// residuals in double-double (tracker/path_system.h) and goes on from there. In double-double the
// scalar Newton says whether a point at t = 1 is a regular end; where it is none the step is
// rejected, so that no path arrives at a singular end (tracker/fine_path_system.h).
// Source: [Timme21] for contraction as the measure.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "moivre/tracker/session.h"
#include "moivre/tracker/tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {

/// What the lanes' scalar allows.
struct LaneRules {
  double point_tolerance =
      0;  ///< of Newton at the start and the end of a segment, and where a watcher looks
  double sample_tolerance = 0;  ///< the same at samples, which go into Cauchy's integral
  double stagnation = 0;        ///< a correction that no longer contracts passes below this
  double rounding = 0;  ///< a second correction below this does not tell how Newton contracts
  double rounding_residual =
      0;  ///< |H| below this is made of rounding errors: equations have coefficients near 1
  double least_step =
      0;  ///< near s = 1, where 1 - s is known to more digits than s; 0: no more than s is
  bool proves_ends = false;  ///< a point at t = 1 is to be a regular end
  bool polishes_watched =
      false;  ///< near t = 1 a watcher gets points that double could not improve
};
inline constexpr LaneRules kDoubleRules{1e-9, 1e-14, 1e-6, 1e-6, 1e-12, 0, false, false};
inline constexpr LaneRules kDoubleDoubleRules{1e-9, 1e-14, 1e-9, 1e-18, 1e-27, 1e-26, true, true};

/// What scalar Newton made of a lane's point.
struct Rescue {
  bool converged = false;
  WorkCount work;
  std::optional<double> regular_condition;  ///< of a regular end
  double accuracy = 0;                      ///< then: |dx| / |x|
};

class LaneControl {
 public:
  /// What the arithmetic measured on the last step.
  struct Outcome {
    double first;     ///< |dx_1|_w
    double second;    ///< |dx_2|_w
    double residual;  ///< max_i |H_i| at the prediction
  };
  /// What becomes of the corrected point: not taken, taken in place, taken as the first of a path,
  /// taken as the next;
  /// or it is to be corrected more finely first, see judge_rescue().
  enum class Move { stay, correct, depart, step, rescue };

  void depart(PathSegment&& segment, const LaneOptions& options, const LaneRules& rules);
  bool is_idle() const { return state_ == State::idle; }
  bool has_ended() const { return state_ == State::ended; }

  /// Chooses the next step. False when the lane is idle.
  bool prepare();
  double step() const { return step_; }
  const PathFrame* frame() const { return segment_->frame.get(); }
  const PathTime& next_time() const { return next_time_; }
  Complex next_dt() const { return contour().dt(next_time_); }

  Move judge(const Outcome& outcome);
  /// After Move::rescue: how finely the point at next_time() is wanted, whether it is to be a
  /// regular end, and what becomes of it then.
  double rescue_tolerance() const;
  bool is_proving_end() const;
  /// The lane has done what it can in its own digits.
  bool is_polishing() const { return state_ == State::polishing; }
  Move judge_rescue(const Rescue& rescue);
  /// The step with which a past is made up for a path that departs.
  double past_step() const { return h_; }

  /// A step has been accepted and polished, and somebody wants its point.
  bool is_to_be_observed() const;
  void observe(std::span<const Complex> x, PathSystem& path);
  /// Ends the segment where its end was reached.
  void close_step();
  void end(SegmentStatus status);

  /// The result of an ended segment at x.
  SegmentResult arrive(std::span<const Complex> x);
  /// Gives the segment back; the lane is idle.
  PathSegment leave();

 private:
  enum class State { idle, departing, under_way, polishing, ended };

  Move judge_segment(const Outcome& outcome);
  Move judge_step(const Outcome& outcome);
  Move judge_polish(const Outcome& outcome);
  Move accept(const Outcome& outcome);
  Move reject(double factor);
  void choose_step();
  bool bends_sharply(const Outcome& outcome) const;
  bool is_watched() const;
  double wanted_accuracy() const;
  bool is_near_end() const;
  double next_landing() const;
  bool has_landed() const;
  bool has_arrived() const { return left_ == 0; }
  double least_step() const;
  const Contour& contour() const { return segment_->contour; }
  PathTime time(double s, double left) const;

  State state_ = State::idle;
  std::optional<PathSegment> segment_;
  LaneRules rules_;
  SegmentResult reached_;
  double left_ = 1;  // 1 - reached_.s
  PathTime time_{0.0};
  std::int64_t maximum_steps_ = 0;
  LanePredictor predictor_ = LanePredictor::quintic;
  double tolerance_ = 0;
  double end_tolerance_ = 0;  // near t = 1
  double h_ = 0;              // the step the control would like
  double step_ = 0;           // the step being taken, cut short where it would pass a landing
  double next_s_ = 0;
  double next_left_ = 0;
  PathTime next_time_{0.0};
  double last_step_ = 0;
  double factor_ = 1;  // by which the control would change the step
  Outcome last_{};
  int rounds_ = 0;  // of Newton, departing or polishing
  bool complete_ = false;
};

}  // namespace moivre
