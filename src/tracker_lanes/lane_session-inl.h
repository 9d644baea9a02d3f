// SPDX-License-Identifier: MIT
// Which lane does what next? Every lane has a segment, a time and a step of its own; one call steps
// them all.
//
// A lane is departing (Newton from the segment's x), under way, polishing a sample, or idle. What
// it does is decided by its own numbers alone, so a segment does not depend on its lane, nor on
// what the others carry. A lane whose segment has ended hands in the result and takes the next
// segment before the next step.
#if defined(MOIVRE_LANE_SESSION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_SESSION_INL_H_
#undef MOIVRE_LANE_SESSION_INL_H_
#else
#define MOIVRE_LANE_SESSION_INL_H_
#endif

#include <array>
#include <optional>

#include "lane_control.h"
#include "lane_newton.h"
#include "lane_step-inl.h"
#include "moivre/tracker/session.h"
#include "moivre/tracker/tracker.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

template <class R>
class LaneSession : public TrackerSession {
 public:
  LaneSession(const LaneOptions& options, const Homotopy& homotopy)
      : options_(options),
        program_(make_program<Real>(homotopy)),
        newton_(homotopy),
        path_(newton_.coordinates(), options.predictor),
        step_(homotopy, program_),
        point_(newton_.coordinates()),
        tangent_(newton_.coordinates()) {}

  void run(SegmentSource& source, const std::atomic<bool>& stop) override {
    bool may_have_more = true;
    for (;;) {
      if (may_have_more) may_have_more = refill(source);
      bool busy = false;
      for (std::size_t lane = 0; lane < W; ++lane) busy |= lanes_[lane].prepare();
      if (!busy) return;
      step();
      for (std::size_t lane = 0; lane < W; ++lane) {
        if (lanes_[lane].is_idle()) continue;
        judge(lane);
      }
      advance();
      const bool cancelled = stop.load(std::memory_order_relaxed);
      for (std::size_t lane = 0; lane < W; ++lane) {
        if (lanes_[lane].is_idle()) continue;
        report(lane);
        if (cancelled) lanes_[lane].end(SegmentStatus::cancelled);
        if (lanes_[lane].has_ended()) {
          hand_in(lane, source);
          may_have_more = true;
        }
      }
    }
  }

 private:
  using Real = typename LaneScalar<R>::Real;
  using Number = typename LaneScalar<R>::Number;

  bool refill(SegmentSource& source) {
    for (std::size_t lane = 0; lane < W; ++lane) {
      if (!lanes_[lane].is_idle()) continue;
      std::optional<PathSegment> segment = source.next();
      if (!segment) return false;
      std::copy(segment->x.begin(), segment->x.end(), point_.begin());
      newton_.normalize(point_);
      path_.place(lane, point_);
      step_.set_frame(lane, segment->frame);
      lanes_[lane].depart(std::move(*segment), options_, LaneNewton<Number>::kRules);
    }
    return true;
  }

  void step() {
    for (std::size_t lane = 0; lane < W; ++lane) {
      const LaneControl& control = lanes_[lane];
      if (control.is_idle()) continue;
      h_.at[lane] = control.step();
      time_.set(lane, newton_.time(control.next_time()), control.next_dt());
    }
    step_.take(path_, h_, time_);
  }

  void judge(std::size_t lane) {
    LaneControl::Move move =
        lanes_[lane].judge({step_.first.at[lane], step_.second.at[lane], step_.residual.at[lane]});
    if (move == LaneControl::Move::rescue) move = rescue(lane);
    stepped_.at[lane] = move == LaneControl::Move::step;
    replaced_.at[lane] = move != LaneControl::Move::stay;
    departed_.at[lane] = move == LaneControl::Move::depart;
    back_.at[lane] = lanes_[lane].past_step();
  }

  // Corrects the lane's point by scalar Newton.
  LaneControl::Move rescue(std::size_t lane) {
    LaneControl& control = lanes_[lane];
    for (std::size_t i = 0; i < point_.size(); ++i) point_[i] = step_.corrected.get(i, lane);
    newton_.normalize(point_);
    newton_.set_frame(control.frame());
    const LaneControl::Move move = control.judge_rescue(newton_.rescue(point_, tangent_, control));
    if (move != LaneControl::Move::stay) step_.replace(lane, path_.patch(), point_, tangent_);
    return move;
  }

  void advance() {
    const V none = zeros();
    const Mask departed = departed_.value() > none;
    path_.advance(stepped_.value() > none, replaced_.value() > none, h_.value(), step_.corrected,
                  step_.tangent);
    if (!is_nowhere(departed)) path_.forget(departed, back_.value());
    path_.renew_patches();
    stepped_ = replaced_ = departed_ = LaneReals{};
  }

  // The point in the lane, of norm 1, rounded to double.
  const Point& extract(std::size_t lane) {
    for (std::size_t i = 0; i < point_.size(); ++i) point_[i] = path_.x().get(i, lane);
    newton_.normalize(point_);
    return newton_.rounded(point_);
  }

  void report(std::size_t lane) {
    LaneControl& control = lanes_[lane];
    if (control.is_to_be_observed()) {
      newton_.set_frame(control.frame());
      control.observe(extract(lane), newton_.watched());
    }
    control.close_step();
  }

  void hand_in(std::size_t lane, SegmentSource& source) {
    SegmentResult reached = lanes_[lane].arrive(extract(lane));
    const PathSegment segment = lanes_[lane].leave();
    source.arrived(segment, std::move(reached));
  }

  LaneOptions options_;
  HomotopyProgram<Real> program_;
  LaneNewton<Number> newton_;  // for watchers and rescues
  LanePath<R> path_;
  LaneStep<R> step_;
  LaneTime<R> time_;
  LaneReals h_;
  LaneReals back_;
  LaneReals stepped_;
  LaneReals replaced_;
  LaneReals departed_;
  std::array<LaneControl, W> lanes_;
  std::vector<Number> point_;
  std::vector<Number> tangent_;
};

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif
