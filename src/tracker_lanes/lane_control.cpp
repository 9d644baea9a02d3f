// SPDX-License-Identifier: MIT
// Accepting, rejecting and sizing the steps of one lane.
#include "lane_control.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moivre {
namespace {

// The prediction may be this much worse than the tolerance that steps aim at.
constexpr double kSlack = 8;
// Near t = 1, where paths may meet, steps aim at this tolerance at most.
constexpr double kEndRadius = 0.1;
constexpr double kEndTolerance = 1e-3;
// A segment that sets out there and takes more steps than this, circles some tens, is going
// nowhere.
constexpr std::int64_t kMaximumStepsNearEnd = 2000;
// Contraction of Newton above which a step is refused, and the one that steps aim at.
constexpr double kContraction = 0.1;
constexpr double kContractionAimedAt = 0.02;
// A tangent that was refined once errs by the square of Newton's contraction, and the predictor
// multiplies that by ten and more. Where a first correction of this share of the tolerance
// contracts no better than so, it is bad tangents that shorten the steps.
constexpr double kSharpBend = 0.1;
constexpr double kContractionInBends = 0.003;
// Steps aim at this fraction of what the control formula gives, and change by these factors at
// most.
constexpr double kSafety = 0.9;
constexpr double kLargestGrowth = 2;
constexpr double kLargestCut = 0.25;
constexpr double kLeastCut = 0.6;
// The first step of a segment, in s.
constexpr double kFirstStep = 1.0 / 64;
// A step below this multiple of the spacing of numbers at s does not move the path.
constexpr double kLeastStep = 4;
constexpr double kPolishContraction = 0.25;
constexpr double kFarthestStart = 0.1;
constexpr int kMaximumRounds = 4;
// Each tolerance level divides the tolerance by so much.
constexpr double kToleranceFactor = 10;
// The largest ratio that a step is sized by, so that no division overflows.
constexpr double kAmpleRoom = 1e6;

// From such room on a step grows as much as it may, whatever the order.
constexpr double kRoomForGrowth = 125;
constexpr double kUsefulFactor = kLargestGrowth / kSafety;
static_assert(kUsefulFactor * kUsefulFactor * kUsefulFactor * kUsefulFactor * kUsefulFactor *
                  kUsefulFactor <
              kRoomForGrowth);

/// a^{1/p}, p the predictor's order, or another number as large for what it is used for.
double root_of_order(LanePredictor predictor, double a) {
  if (a >= kRoomForGrowth) return kUsefulFactor;
  switch (predictor) {
    case LanePredictor::tangent:
      return std::sqrt(a);
    case LanePredictor::cubic:
      return std::sqrt(std::sqrt(a));
    case LanePredictor::quintic:
      return std::cbrt(std::sqrt(a));
  }
  return 0;
}

}  // namespace

void LaneControl::depart(PathSegment&& segment, const LaneOptions& options,
                         const LaneRules& rules) {
  segment_ = std::move(segment);
  rules_ = rules;
  left_ = 1;
  time_ = time(0, 1);
  const double tightening = std::pow(kToleranceFactor, -segment_->tolerance_level);
  reached_ = SegmentResult{};
  maximum_steps_ = options.maximum_steps;
  predictor_ = options.predictor;
  tolerance_ = options.tolerance * tightening;
  end_tolerance_ = std::min(options.tolerance, kEndTolerance) * tightening;
  h_ = kFirstStep;
  rounds_ = 0;
  complete_ = false;
  state_ = State::departing;
  if (is_near_end()) maximum_steps_ = std::min(maximum_steps_, kMaximumStepsNearEnd);
}

double LaneControl::next_landing() const {
  if (segment_->samples == 0) return 1;
  const double taken = static_cast<double>(reached_.samples.size());
  return (taken + 1) / segment_->samples;
}

bool LaneControl::has_landed() const {
  const double landing = next_landing();
  return landing == 1 ? has_arrived() : reached_.s == landing;
}

PathTime LaneControl::time(double s, double left) const {
  return rules_.least_step > 0 ? contour().at(s, left) : contour().at(s);
}

double LaneControl::least_step() const {
  if (rules_.least_step > 0 && reached_.s >= 0.5) return rules_.least_step;
  return kLeastStep * std::numeric_limits<double>::epsilon() * std::max(reached_.s, kFirstStep);
}

bool LaneControl::prepare() {
  complete_ = false;
  if (state_ == State::idle) return false;
  step_ = 0;
  next_s_ = reached_.s;
  next_left_ = left_;
  next_time_ = time_;
  if (state_ != State::under_way) return true;
  choose_step();
  next_time_ = time(next_s_, next_left_);
  return true;
}

void LaneControl::choose_step() {
  const double landing = next_landing();
  const double remaining = landing == 1 ? left_ : landing - reached_.s;
  if (h_ >= remaining) {
    step_ = remaining;
    next_s_ = landing;
    next_left_ = 1 - landing;
    return;
  }
  // No crumb is left over: two equal steps where one and a bit would do.
  step_ = std::min(h_, remaining / 2);
  if (rules_.least_step > 0 && reached_.s >= 0.5) {
    next_left_ = left_ - step_;
    next_s_ = 1 - next_left_;
    step_ = left_ - next_left_;
  } else {
    next_s_ = reached_.s + step_;
    next_left_ = 1 - next_s_;
    step_ = next_s_ - reached_.s;
  }
}

LaneControl::Move LaneControl::judge(const Outcome& outcome) {
  reached_.count.work.linearizations += 1;
  reached_.count.work.factorizations += 1;
  reached_.count.work.values += 1;
  switch (state_) {
    case State::departing:
      return judge_segment(outcome);
    case State::under_way:
      return judge_step(outcome);
    case State::polishing:
      return judge_polish(outcome);
    case State::idle:
    case State::ended:
      return Move::stay;
  }
  return Move::stay;
}

bool LaneControl::is_watched() const {
  if (segment_->watcher == nullptr) return false;
  const double radius = segment_->watch_radius;
  return std::norm(time_.rest) <= radius * radius;
}

double LaneControl::wanted_accuracy() const {
  return segment_->samples > 0 ? rules_.sample_tolerance : rules_.point_tolerance;
}

LaneControl::Move LaneControl::judge_segment(const Outcome& outcome) {
  ++rounds_;
  if (!(outcome.first <= kFarthestStart) || !std::isfinite(outcome.second)) {
    end(SegmentStatus::bad_start);
    return Move::stay;
  }
  if (outcome.second <= rules_.point_tolerance) {
    state_ = State::under_way;
    return Move::depart;
  }
  const bool contracts = outcome.second <= kPolishContraction * outcome.first;
  return contracts && rounds_ < kMaximumRounds ? Move::correct : Move::rescue;
}

LaneControl::Move LaneControl::reject(double factor) {
  ++reached_.count.rejected;
  h_ = step_ * std::clamp(factor, kLargestCut, kLeastCut);
  if (h_ < least_step()) end(SegmentStatus::step_too_small);
  return Move::stay;
}

bool LaneControl::is_near_end() const { return std::norm(time_.rest) < kEndRadius * kEndRadius; }

LaneControl::Move LaneControl::judge_step(const Outcome& outcome) {
  const double e = outcome.first;
  if (!std::isfinite(e) || !std::isfinite(outcome.second)) return reject(kLargestCut);
  const double contraction = outcome.second / e;
  const double tolerance = is_near_end() ? end_tolerance_ : tolerance_;
  double room = e * kAmpleRoom > tolerance ? tolerance / e : kAmpleRoom;
  if (outcome.second > rules_.rounding) room = std::min(room, kContractionAimedAt / contraction);
  factor_ = kSafety * root_of_order(predictor_, room);
  if (e > kSlack * tolerance) return reject(factor_);
  last_ = outcome;
  if (contraction <= kContraction || outcome.second <= rules_.stagnation) {
    return is_proving_end() ? Move::rescue : accept(outcome);
  }
  return outcome.residual <= rules_.rounding_residual ? Move::rescue : reject(factor_);
}

bool LaneControl::bends_sharply(const Outcome& outcome) const {
  return outcome.second > rules_.point_tolerance &&
         outcome.second > kContractionInBends * outcome.first &&
         outcome.first < kSharpBend * tolerance_;
}

LaneControl::Move LaneControl::accept(const Outcome& outcome) {
  ++reached_.count.accepted;
  last_step_ = step_;
  last_ = outcome;
  reached_.s = next_s_;
  left_ = next_left_;
  time_ = next_time_;
  // A step that was cut short to land says nothing against the longer one.
  const double uncut = step_ < h_ ? h_ * std::min(factor_, 1.0) : 0.0;
  h_ = std::max(step_ * std::clamp(factor_, kLargestCut, kLargestGrowth), uncut);
  const double error = outcome.second * std::min(outcome.second / outcome.first, 1.0);
  const bool is_seen = rules_.polishes_watched && is_watched() && is_near_end();
  const bool is_wanted =
      has_landed() ? error > wanted_accuracy() : is_seen && error > rules_.point_tolerance;
  if (is_wanted || bends_sharply(outcome)) {
    rounds_ = 0;
    state_ = State::polishing;
  } else {
    complete_ = true;
  }
  return Move::step;
}

LaneControl::Move LaneControl::judge_polish(const Outcome& outcome) {
  ++rounds_;
  if (!std::isfinite(outcome.first) || !std::isfinite(outcome.second)) {
    end(SegmentStatus::off_path);
    return Move::stay;
  }
  const bool contracts = outcome.second <= kPolishContraction * outcome.first;
  if (outcome.second > wanted_accuracy() && contracts && rounds_ < kMaximumRounds) {
    return Move::correct;
  }
  if (outcome.second > rules_.point_tolerance) return Move::rescue;
  state_ = State::under_way;
  complete_ = true;
  return Move::correct;
}

double LaneControl::rescue_tolerance() const { return wanted_accuracy(); }

bool LaneControl::is_proving_end() const {
  return rules_.proves_ends && next_left_ == 0 && next_time_.rest == 0.0;
}

LaneControl::Move LaneControl::judge_rescue(const Rescue& rescue) {
  reached_.count.work += rescue.work;
  const State before = state_;
  if (!rescue.converged) {
    if (before == State::under_way) return reject(is_proving_end() ? kLargestCut : factor_);
    end(before == State::departing ? SegmentStatus::bad_start : SegmentStatus::off_path);
    return Move::stay;
  }
  reached_.regular_condition = rescue.regular_condition;
  reached_.accuracy = rescue.accuracy;
  if (before == State::under_way) return accept({last_.first, 0, last_.residual});
  state_ = State::under_way;
  if (before == State::departing) return Move::depart;
  complete_ = true;
  return Move::correct;
}

bool LaneControl::is_to_be_observed() const {
  return complete_ && (is_watched() || (segment_->samples > 0 && has_landed()));
}

void LaneControl::observe(std::span<const Complex> x, PathSystem& path) {
  const bool at_end = has_arrived();
  if (segment_->samples > 0 && has_landed()) reached_.samples.emplace_back(x.begin(), x.end());
  if (!is_watched()) return;
  StepRecord record;
  record.s = reached_.s;
  record.t = time_;
  record.x = x;
  record.step = last_step_;
  record.order = order_of(predictor_);
  record.drift = last_.residual;
  record.correction = last_.first;
  const auto verdict = segment_->watcher->watch(record, path);
  if (verdict == Watcher::Verdict::stop && !at_end) end(SegmentStatus::stopped);
}

void LaneControl::close_step() {
  if (complete_ && has_arrived()) end(SegmentStatus::arrived);
  const std::uint64_t steps = reached_.count.accepted + reached_.count.rejected;
  if (static_cast<std::int64_t>(steps) >= maximum_steps_) end(SegmentStatus::step_limit);
}

void LaneControl::end(SegmentStatus status) {
  if (state_ == State::ended) return;
  reached_.status = status;
  state_ = State::ended;
}

SegmentResult LaneControl::arrive(std::span<const Complex> x) {
  reached_.x.assign(x.begin(), x.end());
  reached_.t = time_;
  return std::move(reached_);
}

PathSegment LaneControl::leave() {
  state_ = State::idle;
  PathSegment segment = std::move(*segment_);
  segment_.reset();
  return segment;
}

}  // namespace moivre
