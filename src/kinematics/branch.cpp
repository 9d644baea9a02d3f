// SPDX-License-Identifier: MIT
// How is a branch followed? Steps along the curve, samples in between, and the places where it
// ends.
#include "moivre/kinematics/branch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "curve.h"
#include "extreme_singular_values.h"
#include "meeting.h"
#include "moivre/kinematics/own_units.h"
#include "moivre/kinematics/state.h"
#include "moivre/mechanism/pose.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/positive.h"
#include "noise.h"
#include "segment.h"
#include "staircase_qr.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Steps in y, where an angle counts by radians and a length by the mechanism's.
constexpr double kFirstStep = 1e-2;
constexpr double kShortestStep = 1e-12;
// The longest step takes this share of all the time, too: a driver's law may have detail that the
// curve does not announce.
constexpr double kLongestTime = 1.0 / 8;
// The last step aims a little beyond the end, so that the end lies within it.
constexpr double kOvershoot = 1.02;
constexpr double kShrink = 0.5;
constexpr double kLeastGrowth = 0.3;
constexpr double kMostGrowth = 2;
// Aim below the limits: a step that just misses one is done twice.
constexpr double kAim = 0.6;
// At this sigma branches cross. Points there are known to 1e-16 / sigma, so that they still show
// sigma itself; branches that pass each other by less are not told from crossing ones.
constexpr double kCrossing = 1e-7;
// Rounding moves the points of a step by no more than this over sigma, and so turns their tangents
// by as much over sigma again.
constexpr double kRoundingOfPoints = 4e-16;
// Cosine of both singular vectors beyond which a change of sign is a zero of sigma, and not two
// singular values in turn.
constexpr double kSameVector = 0.5;
// A tangent with less of time in it than this stands across.
constexpr double kAcross = 1e-9;
// Curve time relative to 1: what is nearer to an event than this is the event.
constexpr double kEventWidth = 1e-12;
// Likewise where a sample beside a dead point cannot be told from the branch that it meets there.
constexpr double kDeadPointWidth = 1e-9;
// A sample's correction relative to the step, in y; beyond, the step was too long for the
// interpolation.
constexpr double kSampleMiss = 0.05;
// A correction this small leaves an error of its square.
constexpr double kSampleConverged = 1e-8;
constexpr int kSampleCorrections = 8;

/// q with the coordinates that are rounding noise relative to the others at 0, where that leaves
/// less of Phi: a row whose terms are noise has no scale of its own.
VectorXd least_residual(const Phi& phi, const VectorXd& q, double t) {
  const VectorXd clean = without_noise(phi, q);
  if (clean == q) return q;
  return scaled_residual(phi, clean, t) < scaled_residual(phi, q, t) ? clean : q;
}

/// What rows of length 1 leave together where each of them misses by Mechanism::fit.
double slack_of(const Mechanism& mechanism, const Phi& phi, const VectorXd& q) {
  return mechanism.fit.value_or(0) / size_of(phi, q) * std::sqrt(static_cast<double>(phi.size()));
}

void require_fitting(const Phi& phi, const VectorXd& q0, const std::vector<double>& times,
                     const std::optional<double>& fit) {
  if (q0.size() != phi.dimension() || !q0.allFinite()) {
    throw InvalidInput("a branch begins at " + std::to_string(phi.dimension()) +
                       " finite coordinates");
  }
  if (times.size() < 2) throw InvalidInput("a branch is followed through two times or more");
  if (!std::isfinite(times.front())) throw InvalidInput("the times of a branch are finite");
  for (std::size_t k = 1; k < times.size(); ++k) {
    const bool is_forwards = times.back() > times.front();
    if (!std::isfinite(times[k]) ||
        !(is_forwards ? times[k] > times[k - 1] : times[k] < times[k - 1])) {
      throw InvalidInput("the times of a branch go one way");
    }
  }
  const double residual = residual_by_size(phi, q0, times.front());
  const bool is_fitting = fit && misfit(phi, q0, times.front()) <= *fit;
  if (!(residual <= kAssembled) && !is_fitting) {
    throw InvalidInput("a branch begins at an assembled pose; this one leaves " +
                       std::to_string(residual) + " of what its size is worth");
  }
}

std::string rough(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", x);
  return text;
}

class Follower {
 public:
  Follower(const Mechanism& mechanism, const VectorXd& q0, const std::vector<double>& times,
           const BranchOptions& options, const std::atomic<bool>& stop)
      : mechanism_(mechanism),
        phi_(mechanism),
        times_(times),
        options_(options),
        stop_(stop),
        curve_(phi_, {sizes_of(phi_, q0), times.front(), times.back() - times.front()},
               slack_of(mechanism, phi_, q0), !is_typed(mechanism)),
        order_(staircase_order(phi_.reads(), phi_.dimension())) {
    require_unbroken(validate(options));
    require_fitting(phi_, q0, times, mechanism.fit);
  }

  Branch run(const VectorXd& q0);

 private:
  bool is_begun(const VectorXd& q0);
  void step();
  bool still_fits(const VectorXd& y);
  double step_length() const;
  struct Bend {
    double miss = 0;      ///< of the prediction, relative to the step
    double turn_rad = 0;  ///< of the tangent
  };
  Bend bend_of(const CurvePoint& b, const VectorXd& predicted, double h) const;
  bool is_smooth(const CurvePoint& b, const VectorXd& predicted, double h);
  bool advance(const CurvePoint& b, double h);
  std::optional<CurvePoint> end_within(const Segment& segment, std::optional<BranchEvent>& event);
  bool take_samples(const Segment& segment, double until);
  std::optional<BranchSample> sample(const Segment& segment, double time) const;
  /// By Phi_q in own units.
  VectorXd solved(const StaircaseQr& qr, const VectorXd& b) const {
    return phi_.own_units().cwiseProduct(qr.solve(b.cwiseQuotient(phi_.own_row_units())));
  }
  VectorXd correction(const VectorXd& q, double t, bool is_careful) const;
  BranchSample state_at(const VectorXd& assembled, double time) const;
  bool is_velocity_wanted(double time) const {
    const auto& wanted = options_.velocity_times;
    return !wanted || std::binary_search(wanted->begin(), wanted->end(), time);
  }
  void choose_length(const CurvePoint& b, double h);
  void watch_approach(const CurvePoint& b);
  void cross();
  void shorten_rotations();
  BranchEvent event_at(EventKind kind, const VectorXd& y) const;
  void reject();
  void keep_piece(const Segment& segment);
  void end(BranchStatus status, std::string message);
  void end_at(BranchEvent event);

  const Mechanism& mechanism_;
  const Phi phi_;
  const std::vector<double>& times_;
  const BranchOptions& options_;
  const std::atomic<bool>& stop_;
  const Curve curve_;
  const StaircaseOrder order_;  ///< of Phi_q
  CurvePoint at_;
  std::vector<CurvePoint> approach_;  ///< the last points, sigma falling
  double h_ = kFirstStep;
  bool is_done_ = false;
  Branch result_;
};

void Follower::end(BranchStatus status, std::string message) {
  result_.status = status;
  result_.message = std::move(message);
  is_done_ = true;
}

void Follower::end_at(BranchEvent event) {
  end(BranchStatus::ended,
      to_string(event.kind) + (event.joint.empty() ? "" : " of " + event.joint));
  result_.event = std::move(event);
}

BranchEvent Follower::event_at(EventKind kind, const VectorXd& y) const {
  BranchEvent event;
  event.kind = kind;
  event.time = curve_.t_of(y);
  const bool is_late =
      curve_.scale().T > 0 ? event.time > times_.back() : event.time < times_.back();
  if (is_late) event.time = times_.back();  // found there, but for rounding
  event.q = curve_.q_of(y);
  event.uncertainty = kEventWidth * std::abs(curve_.scale().T);
  return event;
}

BranchSample Follower::state_at(const VectorXd& assembled, double time) const {
  BranchSample sample;
  sample.time = time;
  sample.q = least_residual(phi_, assembled, time);
  sample.residual = residual_by_size(phi_, sample.q, time);
  const MatrixXd J = phi_.jacobian(sample.q, time);
  const bool is_wanted = is_velocity_wanted(time);
  if (J.rows() == J.cols()) {
    const MatrixXd scaled = in_own_units(phi_, J);
    const StaircaseQr qr(scaled, order_);
    sample.is_determined = stays_surely_regular(scaled, qr);
    if (sample.is_determined && is_wanted) {
      sample.velocity = solved(qr, phi_.velocity_rhs(sample.q, time));
      sample.acceleration = solved(qr, phi_.acceleration_rhs(sample.q, sample.velocity, time));
    }
    if (sample.is_determined) return sample;
  }
  if (!is_wanted) {
    sample.is_determined = rank_of(phi_, J) == phi_.dimension();
    return sample;
  }
  MotionState state = motion_state(phi_, sample.q, time);
  sample.velocity = std::move(state.velocity);
  sample.acceleration = std::move(state.acceleration);
  sample.is_determined = state.is_determined;
  return sample;
}

/// The first sample, and whether the branch can leave it.
bool Follower::is_begun(const VectorXd& q0) {
  const VectorXd y = curve_.point(q0, times_.front());
  result_.samples.push_back(state_at(q0, times_.front()));
  if (phi_.size() < phi_.dimension()) {
    end(BranchStatus::failed,
        "fewer constraints than coordinates: the pose moves though the drivers stand; give "
        "drivers");
    return false;
  }
  at_ = curve_.begin(y);
  if (!(at_.sigma > kCrossing)) {
    end_at(event_at(EventKind::bifurcation, y));
  } else if (std::abs(at_.time_rate()) < kAcross) {
    end_at(event_at(EventKind::dead_point, y));
  } else if (const Joint* joint = broken_limit(mechanism_, q0)) {
    BranchEvent event = event_at(EventKind::joint_limit, y);
    event.joint = joint->name;
    end_at(std::move(event));
  }
  h_ = std::min(kFirstStep, at_.sigma / 2);
  approach_ = {at_};
  return !is_done_;
}

double Follower::step_length() const {
  // To where rate s + bend s^2 / 2 is what is left of the time; where that is the top of the
  // parabola, a dead point, on beyond it.
  const double rate = at_.time_rate();
  const double left = 1 - at_.time();
  const double slope_there = std::sqrt(std::max(0.0, rate * rate + 2 * at_.time_bend() * left));
  const double to_go = kOvershoot * 2 * left / (rate + slope_there);
  const double longest = options_.longest_step * std::min(1.0, kLongestTime / rate);
  return std::min({h_, longest, std::max(to_go, kShortestStep)});
}

/// How much the curve bends, without what rounding adds: no shorter step makes that less.
Follower::Bend Follower::bend_of(const CurvePoint& b, const VectorXd& predicted, double h) const {
  const double sigma = std::min(at_.sigma, b.sigma);
  const double rounding = kRoundingOfPoints / sigma;
  const double turn = std::acos(std::clamp(at_.tangent.dot(b.tangent), -1.0, 1.0));
  return {std::max(0.0, (b.y - predicted).norm() - rounding) / h,
          std::max(0.0, turn - rounding / sigma)};
}

bool Follower::is_smooth(const CurvePoint& b, const VectorXd& predicted, double h) {
  const Bend bend = bend_of(b, predicted, h);
  const double left = at_.u.dot(b.u);
  const double right = at_.v.dot(b.v);
  const bool crosses = left * right < 0 && std::min(std::abs(left), std::abs(right)) > kSameVector;
  return bend.miss <= options_.largest_miss && bend.turn_rad <= options_.largest_turn_rad &&
         !crosses;
}

void Follower::reject() {
  ++result_.rejected;
  if (h_ < kShortestStep) {
    end(BranchStatus::failed, "the branch cannot be followed further: the step became too small");
  }
}

/// With Mechanism::fit the branch goes no further than closures are taken.
bool Follower::still_fits(const VectorXd& y) {
  if (!mechanism_.fit || phi_.size() <= phi_.dimension()) return true;
  const double miss = misfit(phi_, curve_.q_of(y), curve_.t_of(y));
  if (miss <= *mechanism_.fit) return true;
  end(BranchStatus::failed, "it closes no longer within fit: it misses by " + rough(miss));
  return false;
}

void Follower::step() {
  h_ = step_length();
  const double h = h_;
  const VectorXd predicted = at_.y + h * at_.tangent + (h * h / 2) * at_.curvature;
  const auto y = curve_.corrected(predicted, at_.tangent, at_.tangent.dot(at_.y) + h);
  if (y && !still_fits(*y)) return;
  if (y) {
    const CurvePoint b = curve_.next(*y, at_);
    if (b.tangent.allFinite() && is_smooth(b, predicted, h) && advance(b, h)) {
      ++result_.steps;
      return;
    }
  }
  h_ = kShrink * h;
  reject();
}

/// The next step from how well this one went, and no further than a share of the way to where sigma
/// points to zero.
void Follower::choose_length(const CurvePoint& b, double h) {
  const VectorXd predicted = at_.y + h * at_.tangent + (h * h / 2) * at_.curvature;
  const auto [miss, turn] = bend_of(b, predicted, h);
  const double by_miss = miss > 0 ? std::sqrt(kAim * options_.largest_miss / miss) : kMostGrowth;
  const double by_turn = turn > 0 ? kAim * options_.largest_turn_rad / turn : kMostGrowth;
  h_ = h * std::clamp(std::min(by_miss, by_turn), kLeastGrowth, kMostGrowth);
  if (b.sigma < at_.sigma) {
    h_ = std::min(h_, options_.largest_approach * b.sigma * h / (at_.sigma - b.sigma));
  }
}

void Follower::keep_piece(const Segment& segment) {
  const CurvePoint& a = segment.a;
  const CurvePoint& b = segment.b;
  const Slopes at_b = slopes_at_end(segment);
  const auto in_q = [&](const VectorXd& y) -> VectorXd {
    return y.head(phi_.dimension()).cwiseProduct(curve_.scale().w);
  };
  const double until = b.time() > 1 ? place_of_time(segment, 1) : segment.length;
  result_.pieces.push_back({segment.length,
                            until,
                            {curve_.q_of(a.y), curve_.q_of(b.y)},
                            {in_q(a.tangent), in_q(at_b.slope)},
                            {in_q(a.curvature), in_q(at_b.bend)}});
}

/// False when the step was too long for what lies within it; nothing has happened then.
bool Follower::advance(const CurvePoint& b, double h) {
  const Segment segment{at_, b, h};
  std::optional<BranchEvent> event;
  const std::optional<CurvePoint> last = end_within(segment, event);
  if (!last) return false;
  const std::size_t sampled = result_.samples.size();
  const double until = event ? last->time() - kEventWidth : last->time();
  const Segment whole{at_, *last, at_.tangent.dot(last->y - at_.y)};
  // A time that all but is the dead point's has no pose of its own: the branch and the one that
  // meets it there are not told apart.
  const bool turns_back = event && event->kind == EventKind::dead_point;
  if (!take_samples(whole, until) &&
      !(turns_back && take_samples(whole, until - kDeadPointWidth))) {
    result_.samples.resize(sampled);
    return false;
  }
  keep_piece(whole);
  if (result_.samples.size() == times_.size()) {
    end(BranchStatus::reached, "followed to the end");
  } else if (event && last->time() <= 1 + (turns_back ? kDeadPointWidth : kEventWidth)) {
    if (event->kind == EventKind::dead_point) {
      const double time = curve_.t_of(b.y);
      result_.beyond = BranchPose{time, least_residual(phi_, curve_.q_of(b.y), time)};
    }
    end_at(std::move(*event));
  } else {
    choose_length(b, h);
    at_ = b;
    watch_approach(b);
    shorten_rotations();
  }
  return true;
}

/// Where the branch ends within the segment, with the event; else b. nullopt where that cannot be
/// located.
std::optional<CurvePoint> Follower::end_within(const Segment& segment,
                                               std::optional<BranchEvent>& event) {
  std::optional<CurvePoint> last = segment.b;
  if (segment.b.time_rate() <= 0) {
    last = sign_change(curve_, segment, [](const CurvePoint& p) { return p.time_rate(); });
    if (!last) return last;
    event = event_at(EventKind::dead_point, last->y);
  }
  if (const Joint* joint = broken_limit(mechanism_, curve_.q_of(last->y))) {
    const Segment up_to_last{segment.a, *last, segment.a.tangent.dot(last->y - segment.a.y)};
    last = sign_change(curve_, up_to_last, [&](const CurvePoint& p) {
      return is_within_limits(mechanism_, *joint, curve_.q_of(p.y)) ? 1.0 : -1.0;
    });
    if (!last) return last;
    event = event_at(EventKind::joint_limit, last->y);
    event->joint = joint->name;
  }
  return last;
}

bool Follower::take_samples(const Segment& segment, double until) {
  while (result_.samples.size() < times_.size()) {
    const double t = times_[result_.samples.size()];
    const double time = (t - curve_.scale().t0) / curve_.scale().T;
    if (time > until) return true;
    const std::optional<BranchSample> taken = sample(segment, t);
    if (!taken) return false;
    result_.samples.push_back(*taken);
  }
  return true;
}

/// A Newton step. QR in its stairs first, where Phi_q is square: rank costs more than the step, and
/// what a singular Phi_q gives is far off.
VectorXd Follower::correction(const VectorXd& q, double t, bool is_careful) const {
  const MatrixXd J = phi_.jacobian(q, t);
  if (is_careful || J.rows() != J.cols()) {
    return factorization_of(phi_, J).solve(-phi_.value(q, t));
  }
  return solved(StaircaseQr(in_own_units(phi_, J), order_), -phi_.value(q, t));
}

/// The pose at its own time, corrected from the interpolation; nullopt where the correction leads
/// too far away.
std::optional<BranchSample> Follower::sample(const Segment& segment, double t) const {
  const double time = (t - curve_.scale().t0) / curve_.scale().T;
  const VectorXd guess = curve_.q_of(interpolated(segment, place_of_time(segment, time)));
  for (const bool is_careful : {false, true}) {
    VectorXd q = guess;
    for (int k = 0; k < kSampleCorrections; ++k) {
      const VectorXd step = correction(q, t, is_careful);
      q += step;
      const VectorXd moved = (q - guess).cwiseQuotient(curve_.scale().w);
      if (!(moved.norm() <= kSampleMiss * segment.length)) break;
      if (step.cwiseQuotient(curve_.scale().w).norm() <= kSampleConverged) return state_at(q, t);
    }
  }
  return std::nullopt;
}

void Follower::watch_approach(const CurvePoint& b) {
  const double last = approach_.back().sigma;
  if (b.sigma > last + kRoundingOfPoints / last) approach_.clear();
  while (!approach_.empty() && approach_.back().sigma <= b.sigma) approach_.pop_back();
  approach_.push_back(b);
  if (b.sigma <= kCrossing) cross();
}

/// Branches cross ahead, at most a shortest step away: where, the way there tells.
void Follower::cross() {
  const Meeting meeting = meeting_of(approach_, curve_);
  const double reach = std::pow(kCrossing, 0.5 / meeting.order);
  const bool is_there = std::isfinite(meeting.doubt) && (meeting.y - at_.y).norm() <= reach;
  BranchEvent event = event_at(EventKind::bifurcation, is_there ? meeting.y : at_.y);
  if (!is_there) {
    event.uncertainty = std::sqrt(kCrossing) * std::abs(curve_.scale().T);
  } else {
    event.uncertainty += meeting.doubt * std::abs(curve_.scale().T);
  }
  result_.pieces.push_back({0, 0, {curve_.q_of(at_.y), event.q}, {}, {}});
  end_at(std::move(event));
}

void Follower::shorten_rotations() {
  if (is_done_) return;
  const VectorXd q = curve_.q_of(at_.y);
  if (!phi_.has_long_rotation(q)) return;
  at_ = curve_.begin(curve_.point(phi_.canonical(q), curve_.t_of(at_.y)));
  approach_ = {at_};
}

Branch Follower::run(const VectorXd& q0) {
  if (!is_begun(q0)) return std::move(result_);
  while (!is_done_) {
    if (stop_) {
      end(BranchStatus::interrupted, "interrupted");
    } else if (result_.steps + result_.rejected >= options_.maximum_steps) {
      end(BranchStatus::failed, "not followed further: the limit of steps was reached");
    } else {
      step();
    }
  }
  return std::move(result_);
}

}  // namespace

std::string to_string(EventKind kind) {
  switch (kind) {
    case EventKind::dead_point:
      return "dead point";
    case EventKind::bifurcation:
      return "bifurcation";
    case EventKind::joint_limit:
      return "joint limit";
  }
  return "";
}

std::vector<std::string> validate(const BranchOptions& options) {
  std::vector<std::string> broken = not_positive({{"largest_turn_rad", options.largest_turn_rad},
                                                  {"largest_miss", options.largest_miss},
                                                  {"longest_step", options.longest_step},
                                                  {"largest_approach", options.largest_approach}});
  if (options.maximum_steps < 1) broken.emplace_back("maximum_steps must be 1 or more");
  if (!options.velocity_times) return broken;
  const std::vector<double>& times = *options.velocity_times;
  const bool are_finite =
      std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); });
  if (!are_finite || !std::is_sorted(times.begin(), times.end())) {
    broken.emplace_back("velocity_times must be finite and ascend");
  }
  return broken;
}

Branch follow_branch(const Mechanism& mechanism, const VectorXd& q0,
                     const std::vector<double>& times, const BranchOptions& options,
                     const std::atomic<bool>& stop) {
  return Follower(mechanism, q0, times, options, stop).run(q0);
}

}  // namespace moivre
