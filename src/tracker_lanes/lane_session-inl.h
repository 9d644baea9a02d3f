// SPDX-License-Identifier: MIT
// Which lane does what next? Every lane has a journey, a time and a step of its own; one call steps them all.
//
// A lane is departing (Newton from the departure's x), under way, polishing a sample, or idle. What it does is decided by
// its own numbers alone, so a journey does not depend on its lane, nor on what the others carry. A lane whose
// journey has ended hands in the arrival and takes the next departure before the next step.
#if defined(MOIVRE_LANE_SESSION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_SESSION_INL_H_
#undef MOIVRE_LANE_SESSION_INL_H_
#else
#define MOIVRE_LANE_SESSION_INL_H_
#endif

#include <array>
#include <optional>

#include "lane_control.h"
#include "lane_step-inl.h"
#include "moivre/tracker/tracker.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

class LaneSession : public TrackerSession {
 public:
  LaneSession(const LaneOptions& options, const Homotopy& homotopy)
      : options_(options),
        program_(make_lane_program<double>(homotopy)),
        scalar_(homotopy),
        path_(scalar_.coordinates(), options.predictor),
        step_(program_),
        point_(scalar_.coordinates()),
        tangent_(scalar_.coordinates()) {}

  void run(DepartureSource& source, const std::atomic<bool>& stop) noexcept override {
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
        if (cancelled) lanes_[lane].end(Journey::cancelled);
        if (lanes_[lane].has_ended()) {
          hand_in(lane, source);
          may_have_more = true;
        }
      }
    }
  }

 private:
  bool refill(DepartureSource& source) {
    for (std::size_t lane = 0; lane < W; ++lane) {
      if (!lanes_[lane].is_idle()) continue;
      std::optional<Departure> departure = source.next();
      if (!departure) return false;
      std::copy(departure->x.begin(), departure->x.end(), point_.begin());
      normalize(point_);
      path_.place(lane, point_);
      lanes_[lane].depart(std::move(*departure), options_);
    }
    return true;
  }

  void step() {
    for (std::size_t lane = 0; lane < W; ++lane) {
      const LaneControl& control = lanes_[lane];
      if (control.is_idle()) continue;
      h_.at[lane] = control.step();
      const double s = control.next_s();
      time_.set(lane, control.contour().at(s), control.contour().dt(s));
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

  // Corrects the lane's point by scalar Newton, whose residuals have more digits where they are needed.
  LaneControl::Move rescue(std::size_t lane) {
    LaneControl& control = lanes_[lane];
    for (std::size_t i = 0; i < point_.size(); ++i) point_[i] = step_.corrected.get(i, lane);
    normalize(point_);
    const WorkCount before = scalar_.work();
    const PathTime t = control.contour().at(control.next_s());
    const Correction correction = scalar_.correct(point_, t, control.rescue_options(), true);
    const LaneControl::Move move = control.judge_rescue(correction, scalar_.work() - before);
    if (move == LaneControl::Move::stay) return move;
    scalar_.tangent(control.contour().dt(control.next_s()), tangent_);
    step_.replace(lane, path_.patch(), point_, tangent_);
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

  // The point in the lane, of norm 1.
  void extract(std::size_t lane) {
    for (std::size_t i = 0; i < point_.size(); ++i) point_[i] = path_.x().get(i, lane);
    normalize(point_);
  }
  static void normalize(Point& x) {
    const double scale = 1 / euclidean_norm(x);
    for (Complex& xi : x) xi *= scale;
  }

  void report(std::size_t lane) {
    LaneControl& control = lanes_[lane];
    if (control.is_to_be_observed()) {
      extract(lane);
      control.observe(point_, scalar_);
    }
    control.close_step();
  }

  void hand_in(std::size_t lane, DepartureSource& source) {
    extract(lane);
    Arrival arrival = lanes_[lane].arrive(point_);
    const Departure departure = lanes_[lane].leave();
    source.arrived(departure, std::move(arrival));
  }

  LaneOptions options_;
  LaneProgram<double> program_;
  PathSystem scalar_;  // for watchers and rescues
  LanePath<V> path_;
  LaneStep<V> step_;
  LaneTime<V> time_;
  LaneReals h_;
  LaneReals back_;
  LaneReals stepped_;
  LaneReals replaced_;
  LaneReals departed_;
  std::array<LaneControl, W> lanes_;
  Point point_;
  Point tangent_;
};

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif
