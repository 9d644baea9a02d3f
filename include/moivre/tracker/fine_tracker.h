// SPDX-License-Identifier: MIT
// How is a path followed that double cannot decide? Entirely in a scalar S of more digits: point,
// H, J, factors, step.
//
//   w         -log(1 - s) where the contour ends at t = 1, elsewhere s: (1 - s)^{1/m}, as at a
//             singular end, is smooth in it
//   predict   the polynomial in w through the last six points and tangents
//             (tracker/hermite_predictor.h); the tangent alone at first
//   correct   Newton's method, a fresh J each time, until it corrects far less than at first
//   step      h <- h min(tolerance / |dx_1|, Theta / (|dx_2| / |dx_1|))^{1 / order}: the first
//             correction is the predictor's error;
//             relative to the next sheet's distance, about |dx_1|^2 / |dx_2|, it is how fast
//             Newton's method contracts
//   land      to w = infinity, by the polynomial in s, as soon as a step of w is as long as what is
//             left of s and the polynomial's last term is small relative to the next sheet's
//             distance
//
// For the few paths that need it: in double-double a step takes some thirty times as long as in
// double, in a hundred digits some thousand times. s and 1 - s are both stored, so that steps near
// either end may be as small as doubles are. A path reaches t = 1 only at a regular end: Newton's
// method must contract far better than at a multiple root until rounding stops it, and the
// condition must not be too large for S. At a singular end the result is step_too_small. Each level
// of PathSegment::tolerance_level divides the tolerance by 10. Owns its memory; allocates nothing a
// step but what S does.
// Not supported: tolerances below 1e-11 on circles, whose points are known as doubles while the
// polynomial looks for more; an end whose condition needs 1 - t below the smallest double.
// Source: [Deuflhard04] for the step, [Timme21] for the norm.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "moivre/numeric/log_ratio.h"
#include "moivre/tracker/fine_path_system.h"
#include "moivre/tracker/hermite_predictor.h"
#include "moivre/tracker/session.h"
#include "moivre/tracker/tracker.h"

namespace moivre {

struct FineTrackerOptions {
  double tolerance = 1e-5;             ///< |dx_1|_w that steps aim at
  std::int64_t maximum_steps = 20000;  ///< of one segment
};

namespace detail {

/// A place on the contour, from both ends.
struct Place {
  double s = 0;
  double left = 1;

  bool is_end() const { return left == 0; }
  PathTime on(const Contour& contour) const { return contour.at(s, left); }
  double distance_to(const Place& other) const { return s < 0.5 ? other.s - s : left - other.left; }
};

/// Steps h of w.
struct Clock {
  bool is_logarithmic = false;

  Place ahead(const Place& from, double h) const {
    const double distance = is_logarithmic ? -from.left * std::expm1(-h) : h;
    if (distance >= from.left) return {1, 0};
    if (from.s < 0.5) return {from.s + distance, 1 - (from.s + distance)};
    const double left = is_logarithmic ? from.left * std::exp(-h) : from.left - h;
    return {1 - left, left};
  }
  double step(const Place& from, const Place& to) const {
    return is_logarithmic ? std::log(from.left / to.left) : from.distance_to(to);
  }
  /// ds/dw.
  double pace(const Place& at) const { return is_logarithmic ? at.left : 1; }
};

}  // namespace detail

/// Follows one segment after the other.
template <class S>
class FineSession : public TrackerSession {
 public:
  FineSession(const FineTrackerOptions& options, const Homotopy& homotopy)
      : options_(options),
        path_(homotopy),
        watched_(homotopy),
        trial_(path_.coordinates()),
        rounded_(path_.coordinates()) {
    for (Known& known : known_) {
      known.x.resize(path_.coordinates());
      known.dx.resize(path_.coordinates());
    }
  }

  void run(SegmentSource& source, const std::atomic<bool>& stop) override {
    while (std::optional<PathSegment> segment = source.next()) {
      SegmentResult reached = travel(*segment, stop);
      source.arrived(*segment, std::move(reached));
    }
  }

 private:
  using Real = typename Scalar<S>::Real;
  using FinePoint = std::vector<S>;
  using Place = detail::Place;
  using Clock = detail::Clock;
  using Predictor = HermitePredictor<S>;

  /// A point that the path has passed.
  struct Known {
    Place place;
    Real w;  ///< of `place`; a logarithm in all digits takes long
    FinePoint x;
    FinePoint dx;  ///< by s
  };

  static constexpr double kFirstStep = 1e-3;
  static constexpr double kSafety = 0.8;
  static constexpr double kLargestGrowth = 2;
  static constexpr double kLeastGrowth = 0.2;
  static constexpr double kRefusedStep = 0.25;
  static constexpr double kToleranceFactor = 10;
  // A step of w that is as long as all that is left of s, at the pace at which it begins: landing
  // is tried first.
  static constexpr double kLandingStep = 1;
  // To 1e-13 of 1 - s: what the last points tell reaches no further.
  static constexpr double kLargestStep = 30;
  // A step is refused when its first correction is so many times the tolerance.
  static constexpr double kLargestOvershoot = 30;
  // Theta, and how near an end has to be predicted relative to the distance to the next sheet.
  static constexpr double kContraction = 0.01;
  static constexpr double kSureLanding = 0.1;
  // A point of the way is known when Newton's method, which is to contract quadratically, corrects
  // it by this share of the first correction.
  static constexpr double kFarBelow = 1e-4;
  // A first correction below this fraction of the tolerance lengthens the step no further.
  static constexpr double kLeastCorrection = 1e-12;

  SegmentResult travel(const PathSegment& segment, const std::atomic<bool>& stop);
  SegmentStatus go(const PathSegment& segment, const std::atomic<bool>& stop,
                   SegmentResult& reached);
  bool depart(const PathSegment& segment);
  const Known& here() const { return known_.front(); }
  const Place& place() const { return here().place; }
  /// w or, to the end, s.
  Real position(const Place& place, bool is_in_w) const;
  double predict(const Place& next, const Real& at);
  double order() const { return static_cast<double>(2 * count_); }
  double growth(const Settling& settling, double tolerance) const;
  bool step(const PathSegment& segment, const Place& next, Settling& settling);
  bool is_watched(const PathSegment& segment, const Settling& settling, double taken);
  const Point& rounded();

  FineTrackerOptions options_;
  FinePathSystem<S> path_;
  PathSystem watched_;  // for watchers, who look in double
  Clock clock_;
  LogRatio<S> log_ratio_;
  Predictor predictor_;
  std::array<HermiteNode<S>, Predictor::kMostNodes> nodes_;
  std::array<Known, Predictor::kMostNodes> known_;  // the newest first
  std::size_t count_ = 0;                           // of them
  double apart_ = 0;  // of the newest from the next sheet, relative to |x|
  FinePoint trial_;
  Point rounded_;
};

template <class S>
const Point& FineSession<S>::rounded() {
  round_into<S>(here().x, rounded_);
  return rounded_;
}

template <class S>
bool FineSession<S>::depart(const PathSegment& segment) {
  clock_ = {segment.contour.ends_at_one()};
  Known& start = known_.front();
  start.place = Place();
  start.w = position(start.place, true);
  count_ = 1;
  apart_ = 0;
  path_.set_frame(segment.frame.get());
  watched_.set_frame(segment.frame.get());
  std::transform(segment.x.begin(), segment.x.end(), start.x.begin(),
                 [](const Complex& xi) { return S(xi); });
  const Real scale(1 / max_norm(segment.x));
  for (S& xi : start.x) xi = product(scale, xi);
  path_.set_patch(start.x);
  const PathTime t = start.place.on(segment.contour);
  if (!path_.settle(start.x, t, FinePathSystem<S>::on_path()).converged) return false;
  path_.tangent(segment.contour.dt(0), start.dx);
  return true;
}

template <class S>
typename Scalar<S>::Real FineSession<S>::position(const Place& place, bool is_in_w) const {
  if (clock_.is_logarithmic && is_in_w) return log_ratio_(1, place.left);
  return place.s < 0.5 ? Real(place.s) : Real(1.0) - Real(place.left);
}

// trial <- the polynomial through the known points, at the position of `next`; the size of its last
// term relative to |x|.
template <class S>
double FineSession<S>::predict(const Place& next, const Real& at) {
  const bool is_in_w = clock_.is_logarithmic && !next.is_end();
  for (std::size_t i = 0; i < count_; ++i) {
    const Known& known = known_[i];
    nodes_[i].w = is_in_w ? known.w : position(known.place, false);
    nodes_[i].slope = Real(is_in_w ? clock_.pace(known.place) : 1.0);
    nodes_[i].x = &known.x;
    nodes_[i].dx = &known.dx;
  }
  return predictor_.predict({nodes_.data(), count_}, at, trial_) / max_norm(rounded());
}

/// Takes the step to `next` when Newton's method finds the path there.
template <class S>
bool FineSession<S>::step(const PathSegment& segment, const Place& next, Settling& settling) {
  const double reach =
      kLargestOvershoot * options_.tolerance / std::pow(kToleranceFactor, segment.tolerance_level);
  const PathTime t = next.on(segment.contour);
  const bool is_end = t.rest == 0.0;
  const Real at = position(next, !next.is_end());
  const double last_term = predict(next, at);
  if (is_end && last_term > kSureLanding * apart_) return false;
  SettlingRules rules = is_end ? FinePathSystem<S>::at_end() : FinePathSystem<S>::on_path();
  rules.reach = reach;
  if (!is_end) rules.share = kFarBelow;
  settling = path_.settle(trial_, t, rules);
  if (!settling.converged || (is_end && !path_.is_regular_end())) return false;
  std::rotate(known_.begin(), known_.end() - 1, known_.end());
  count_ = std::min(count_ + 1, known_.size());
  Known& now = known_.front();
  std::swap(now.x, trial_);
  path_.tangent(segment.contour.dt(next.s), now.dx);
  now.place = next;
  now.w = at;
  apart_ = settling.first * settling.first / settling.second;
  path_.set_patch(now.x);
  for (std::size_t i = 0; i < count_; ++i) path_.bring_to_patch(known_[i].x, known_[i].dx);
  return true;
}

template <class S>
bool FineSession<S>::is_watched(const PathSegment& segment, const Settling& settling,
                                double taken) {
  if (segment.watcher == nullptr) return false;
  const PathTime t = place().on(segment.contour);
  if (std::abs(t.rest) > segment.watch_radius) return false;
  const Point& x = rounded();
  const StepRecord record{place().s,     t, x, taken, static_cast<int>(order()), settling.drift,
                          settling.first};
  return segment.watcher->watch(record, watched_) == Watcher::Verdict::stop;
}

/// Of a step, by both of what the first corrections tell: the prediction's error, and how near that
/// is to the next sheet.
template <class S>
double FineSession<S>::growth(const Settling& settling, double tolerance) const {
  const double error = std::max(settling.first / tolerance, kLeastCorrection);
  const double contraction = settling.second / (kContraction * settling.first);
  const double growth = kSafety * std::pow(std::max(error, contraction), -1 / order());
  return std::clamp(growth, kLeastGrowth, kLargestGrowth);
}

template <class S>
SegmentStatus FineSession<S>::go(const PathSegment& segment, const std::atomic<bool>& stop,
                                 SegmentResult& reached) {
  const double tolerance = options_.tolerance / std::pow(kToleranceFactor, segment.tolerance_level);
  double h = kFirstStep;
  int sample = 0;
  while (place().left > 0) {
    if (stop.load(std::memory_order_relaxed)) return SegmentStatus::cancelled;
    const StepCount& count = reached.count;
    if (count.accepted + count.rejected >= static_cast<std::uint64_t>(options_.maximum_steps)) {
      return SegmentStatus::step_limit;
    }
    Settling settling;
    if (clock_.is_logarithmic && h >= kLandingStep) {
      if (step(segment, {1, 0}, settling)) {
        ++reached.count.accepted;
        return is_watched(segment, settling, known_[1].place.left) ? SegmentStatus::stopped
                                                                   : SegmentStatus::arrived;
      }
      ++reached.count.rejected;
    }
    Place next = clock_.ahead(place(), h);
    const double stop_at =
        segment.samples > 0 ? static_cast<double>(sample + 1) / segment.samples : 1;
    const bool is_sample = segment.samples > 0 && next.s >= stop_at;
    if (is_sample) next = stop_at == 1 ? Place{1, 0} : Place{stop_at, 1 - stop_at};
    const double taken = place().distance_to(next);
    if (!(taken > FinePathSystem<S>::least_step())) return SegmentStatus::step_too_small;
    const double tried = clock_.step(place(), next);
    if (!step(segment, next, settling)) {
      ++reached.count.rejected;
      h = kRefusedStep * tried;
      continue;
    }
    ++reached.count.accepted;
    if (is_sample) {
      reached.samples.push_back(rounded());
      ++sample;
    }
    h = std::max(is_sample ? h : 0, tried * growth(settling, tolerance));
    h = std::min(h, kLargestStep);
    if (is_watched(segment, settling, taken)) return SegmentStatus::stopped;
  }
  return SegmentStatus::arrived;
}

template <class S>
SegmentResult FineSession<S>::travel(const PathSegment& segment, const std::atomic<bool>& stop) {
  SegmentResult reached;
  const WorkCount before = path_.work();
  reached.status = depart(segment) ? go(segment, stop, reached) : SegmentStatus::bad_start;
  reached.x = rounded();
  reached.s = place().s;
  reached.t = place().on(segment.contour);
  reached.count.work = path_.work() - before;
  if (reached.status == SegmentStatus::arrived && reached.t.rest == 0.0) {
    reached.regular_condition = path_.condition();
    reached.accuracy = FinePathSystem<S>::end_accuracy();
  }
  return reached;
}

/// One path after the other in S.
template <class S>
class FineTracker : public Tracker {
 public:
  FineTracker(std::string kind, const FineTrackerOptions& options)
      : kind_(std::move(kind)), options_(options) {}

  std::string kind() const override { return kind_; }
  OptionsInForce options_in_force() const override {
    return {{"tolerance", options_.tolerance}, {"maximum_steps", options_.maximum_steps}};
  }
  std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const override {
    return std::make_unique<FineSession<S>>(options_, homotopy);
  }

 private:
  std::string kind_;
  FineTrackerOptions options_;
};

}  // namespace moivre
