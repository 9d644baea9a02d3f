// SPDX-License-Identifier: MIT
// The curve of a pair by predictor and corrector, the zeros of s and its maxima.
#include "pair_curve.h"

#include <algorithm>
#include <cmath>

#include "moivre/numeric/zero_between.h"

namespace moivre {
namespace {

using Eigen::Index;

// Steps in y; the longest one beside |y|.
constexpr double kFirstPairStep = 1e-2;
constexpr double kProbe = 1e-4;
constexpr double kLongestPairStep = 0.25;
constexpr double kShortestPairStep = 1e-11;
constexpr int kMostPairSteps = 20000;
// Of the duration: a driver's law may have detail that the curve does not announce.
constexpr double kLongestPairTime = 1.0 / 16;
// Of the tangent in one step, a cosine; of the prediction beside the step.
constexpr double kLeastCosine = 0.97;
constexpr double kMostMiss = 0.05;
// Of s: by how much its prediction may miss.
constexpr double kMostMissOfS = 0.1;
// Of the slopes of s at both ends, likewise.
constexpr double kMostMissOfSlope = 0.2;
// s is known to this, |y| being near 1.
constexpr double kNoiseOfS = 2e-15;
// A maximum nearer to zero than this is looked at with exact coefficients.
constexpr double kNearZero = 1e-9;
// Roots that went so far go on to infinity.
constexpr double kFarAway = 1e6;

/// From `a`, by x = a.tangent.(y - a.y), to the end at x = length.
struct PairStep {
  PairPoint a;
  PairPoint b;
  double length = 0;
};

/// The cubic through both ends of a step with their tangents.
PairVector hermite(const PairStep& step, double x) {
  const double h = step.length;
  const double r = x / h;
  const PairVector end = step.b.tangent / step.a.tangent.dot(step.b.tangent);
  const double up = r * r * (3 - 2 * r);
  return (1 - up) * step.a.y + up * step.b.y + (h * r * (1 - r) * (1 - r)) * step.a.tangent -
         (h * r * r * (1 - r)) * end;
}

class PairFollower {
 public:
  PairFollower(const PairEquations& equations, const std::vector<double>& times,
               const PassingPair& passing, const std::atomic<bool>& stop)
      : equations_(equations), times_(times), passing_(passing), stop_(stop) {}

  PairCurve run(const Point& x, double time, bool forwards) {
    curve_.last = time;
    curve_.is_lost = true;
    if (!has_begun(x, time, forwards)) return curve_;
    for (int k = 0; k < kMostPairSteps && !stop_; ++k) {
      const double rate_now = rate(at_);
      const double border = rate_now > 0 ? 1 : 0;
      const double to_go = std::abs(rate_now) > 0 ? (border - tau(at_)) / rate_now : kFarAway;
      curve_.is_lost = to_go > 0;
      if (to_go <= 0) return curve_;  // at a border, and on the way out
      h_ = std::min({h_, kLongestPairStep * at_.y.norm(), kLongestPairTime / std::abs(rate_now)});
      if (at_.y.norm() > kFarAway) return gone_to_infinity(k > 0);
      if (h_ < kShortestPairStep) return curve_;
      const bool is_last = h_ >= 0.9 * to_go;
      const auto step = is_last ? last_step(border) : tried(h_);
      if (!step) {
        h_ = (is_last ? std::min(h_, to_go) : h_) / 2;
        continue;
      }
      if (!advance(*step) || is_last) return curve_;
      curve_.is_lost = true;
      h_ *= 1.7;
    }
    return curve_;
  }

 private:
  double s(const PairPoint& point) const { return point.y[equations_.at_s()].real(); }
  double slope(const PairPoint& point) const { return point.tangent[equations_.at_s()].real(); }
  double tau(const PairPoint& point) const { return point.y[equations_.at_tau()].real(); }
  double rate(const PairPoint& point) const { return point.tangent[equations_.at_tau()].real(); }
  double time(const PairPoint& point) const { return equations_.time(tau(point)); }

  /// The curve's point near a guess, x along the tangent from at_.
  std::optional<PairPoint> point_ahead(const PairVector& guess, double x) const {
    const double offset = at_.tangent.dot(at_.y).real() + x;
    return equations_.corrected(guess, base_, at_.tangent, offset, at_.tangent);
  }
  /// The curve's point near a guess at this tau, its tangent the way of `before`.
  std::optional<PairPoint> point_at(const PairVector& guess, double tau,
                                    const PairVector& before) const {
    return equations_.corrected(guess, base_, across(), tau, before);
  }
  PairVector across() const { return PairVector::Unit(base_.size(), equations_.at_tau()); }
  /// The curve's point at x of a step that begins at at_.
  std::optional<PairPoint> between(const PairStep& step, double x) const {
    return point_ahead(hermite(step, x), x);
  }

  /// A step of length h; nullopt where it is too long for the curve.
  std::optional<PairStep> tried(double h) const {
    const PairVector predicted = at_.y + h * at_.tangent + (h * h / 2) * bend_;
    return step_to(point_ahead(predicted, h), predicted);
  }

  /// To tau = border, which is near.
  std::optional<PairStep> last_step(double border) const {
    const PairVector predicted = at_.y + (border - tau(at_)) / rate(at_) * at_.tangent;
    return step_to(point_at(predicted, border, at_.tangent), predicted);
  }

  std::optional<PairStep> step_to(const std::optional<PairPoint>& b,
                                  const PairVector& predicted) const {
    if (!b) return std::nullopt;
    PairStep step{at_, *b, at_.tangent.dot(b->y - at_.y).real()};
    return is_known_within(step, predicted) ? std::optional(std::move(step)) : std::nullopt;
  }

  /// Whether the step's end is where it was predicted, s and its slope above all: then s has no
  /// maximum that its slopes hide.
  bool is_known_within(const PairStep& step, const PairVector& predicted) const {
    const PairVector miss = step.b.y - predicted;
    const Index at = equations_.at_s();
    const double most_of_s = std::max(std::abs(s(step.a)), std::abs(s(step.b)));
    const double slope_miss = slope(step.b) - slope(step.a) - step.length * bend_[at].real();
    const double most_of_slope = std::abs(slope(step.a)) + std::abs(slope(step.b));
    return step.a.tangent.dot(step.b.tangent).real() >= kLeastCosine &&
           miss.norm() <= kMostMiss * step.length &&
           std::abs(miss[at]) <= kMostMissOfS * most_of_s + kNoiseOfS &&
           std::abs(slope_miss) <= kMostMissOfSlope * most_of_slope + kNoiseOfS / step.length;
  }

  /// On its other side the roots come back. Where they begin that far away nothing is real beside
  /// them.
  PairCurve gone_to_infinity(bool has_moved) {
    if (has_moved) curve_.borders.push_back(time(at_));
    curve_.is_lost = false;
    return curve_;
  }

  struct Meeting {
    double time = 0;
    Point x;  ///< both roots
  };

  /// Where s changes its sign between two places of a step.
  Meeting zero_of_s(const PairStep& step, double from, double to) const {
    const auto y_at = [&](double x) {
      const auto point = between(step, x);
      return point ? point->y : hermite(step, x);
    };
    const auto s_at = [&](double x) {
      const double s_there = y_at(x)[equations_.at_s()].real();
      return std::abs(s_there) <= kNoiseOfS / 10 ? 0 : s_there;
    };
    return meeting_at(y_at(zero_between(s_at, from, to, s_at(from), s_at(to))));
  }

  Meeting meeting_at(PairVector y) const {
    y[equations_.at_s()] = 0;
    return {equations_.time(y[equations_.at_tau()].real()), equations_.roots(y).front()};
  }

  void take_life(const Meeting& one, const Meeting& other, double at,
                 const std::array<Point, 2>& roots) {
    const bool is_ascending = one.time < other.time;
    const Meeting& first = is_ascending ? one : other;
    const Meeting& last = is_ascending ? other : one;
    curve_.borders.insert(curve_.borders.end(), {first.time, last.time});
    curve_.short_lives.push_back({{first.time, last.time}, at, roots, {first.x, last.x}});
  }

  /// s rises at the beginning of the step and falls at its end: how high does it come?
  void locate_maximum(const PairStep& step) {
    constexpr int kMostRounds = 50;
    constexpr double kPlace = 1e-7;
    double low = 0;
    double high = step.length;
    std::optional<PairPoint> top;
    double x = 0;
    for (int k = 0; k < kMostRounds && high - low > kPlace * step.length; ++k) {
      // The maximum of a parabola by its slopes, and halves where that creeps.
      const auto lower = between(step, low);
      const auto upper = between(step, high);
      if (!lower || !upper) break;
      const double share = slope(*lower) / (slope(*lower) - slope(*upper));
      x = low + (k % 3 == 2 ? 0.5 : std::clamp(share, 0.001, 0.999)) * (high - low);
      top = between(step, x);
      if (!top) break;
      (slope(*top) > 0 ? low : high) = x;
      if (std::abs(slope(*top)) * (high - low) <= kNoiseOfS / 10) break;
    }
    if (!top || s(*top) < -kNearZero) return;
    if (rate(*top) * rate(step.a) < 0) return curve_.fold_backs.push_back(time(*top));
    if (s(*top) <= kNearZero) return take_brief(*top);
    take_life(zero_of_s(step, 0, x), zero_of_s(step, x, step.length), time(*top),
              equations_.roots(top->y));
  }

  /// A maximum so near to zero that double does not tell its sign: the parabola through three
  /// points known better.
  void take_brief(const PairPoint& top) {
    // In tau, from round to round: the cubic term that the parabola lacks falls with its third
    // power.
    constexpr std::array<double, 3> kReaches{1e-6, 1e-8, 1e-10};
    // Zeros that are nearer to each other are one time.
    constexpr double kOneTime = 1e-12;
    double centre = tau(top);
    double half_life = 0;
    const auto at = [&](double there) -> PairVector {
      PairVector y = top.y + (there - tau(top)) / rate(top) * top.tangent;
      y[equations_.at_tau()] = there;
      return equations_.normalized(y);
    };
    bool is_real = false;
    for (const double least_reach : kReaches) {
      const double reach = std::max(least_reach, half_life);
      const auto s0 = equations_.sharp_s(at(centre));
      const auto s1 = equations_.sharp_s(at(centre - reach));
      const auto s2 = equations_.sharp_s(at(centre + reach));
      const double bend = s0 && s1 && s2 ? (*s1 - *s0 + (*s2 - *s0)) / (2 * reach * reach) : 0;
      if (!(bend < 0)) return curve_.undecided.push_back(equations_.time(centre));
      const double slope_there = (*s2 - *s1) / (2 * reach);
      const double height = *s0 - slope_there * slope_there / (4 * bend);
      centre -= slope_there / (2 * bend);
      half_life = std::sqrt(std::abs(height / bend));
      is_real = height > 0;
    }
    if (2 * half_life <= kOneTime) return curve_.undecided.push_back(equations_.time(centre));
    if (!is_real) return;
    PairVector middle = at(centre);
    const auto s_there = equations_.sharp_s(middle);
    if (!s_there) return curve_.undecided.push_back(equations_.time(centre));
    middle[equations_.at_s()] = *s_there;
    take_life(meeting_at(at(centre - half_life)), meeting_at(at(centre + half_life)),
              equations_.time(centre), equations_.roots(middle));
  }

  /// Whether the time goes back at a place of the step where s > 0, as in a fold-back that is
  /// shorter than the step.
  bool goes_back_while_real(const PairStep& step) const {
    constexpr int kPlaces = 32;
    for (int k = 1; k < kPlaces; ++k) {
      const auto point = between(step, step.length * k / kPlaces);
      if (point && s(*point) > 0 && rate(*point) * rate(step.a) < 0) return true;
    }
    return false;
  }

  /// What s and the time do within the step.
  void watch(const PairStep& step) {
    const double begin = s(step.a);
    const double end = s(step.b);
    if (begin < 0 && end < 0 && slope(step.a) > 0 && slope(step.b) < 0) locate_maximum(step);
    if ((begin < 0) != (end < 0)) {
      const bool turns_within = goes_back_while_real(step);
      const Meeting meeting = zero_of_s(step, 0, step.length);
      curve_.borders.push_back(meeting.time);
      if (begin < 0) {
        met_ = meeting;
        life_ = equations_.roots(step.b.y);
        life_at_ = time(step.b);
        has_turned_ = turns_within;
      } else if (met_) {
        if (has_turned_ || turns_within) {
          curve_.fold_backs.push_back(life_at_);
        } else {
          take_life(*met_, meeting, life_at_, life_);
        }
        met_.reset();
      }
    }
    if (rate(step.a) * rate(step.b) < 0) {
      has_turned_ = true;
      double turn = tau(step.a);
      constexpr int kPlaces = 64;
      for (int k = 1; k <= kPlaces; ++k) {
        const double there = hermite(step, step.length * k / kPlaces)[equations_.at_tau()].real();
        turn = rate(step.a) > 0 ? std::max(turn, there) : std::min(turn, there);
      }
      curve_.borders.push_back(equations_.time(turn));
    }
  }

  /// False where the caller has seen enough.
  bool pass(const PairStep& step) const {
    const double low = std::min(tau(step.a), tau(step.b));
    const double high = std::max(tau(step.a), tau(step.b));
    for (std::size_t k = 0; k < times_.size(); ++k) {
      const double there = equations_.tau(times_[k]);
      const bool is_on_the_way = low < there && there < high;
      if ((!is_on_the_way && there != tau(step.b)) || s(step.a) >= 0 || s(step.b) >= 0) continue;
      const double share = (there - tau(step.a)) / (tau(step.b) - tau(step.a));
      const auto point = point_at(hermite(step, share * step.length), there, at_.tangent);
      const bool is_complex = point && s(*point) < 0;  // in a short life within the step it is not
      if (is_complex && !passing_(k, equations_.roots(point->y).front())) return false;
    }
    return true;
  }

  bool has_begun(const Point& x, double time, bool forwards) {
    base_ = equations_.point(x, equations_.tau(time));
    const auto point = point_at(base_, equations_.tau(time), (forwards ? 1 : -1) * across());
    if (!point) return false;
    at_ = *point;
    bend_ = PairVector::Zero(base_.size());
    // Where a driver stands s is level, and its slope is foretold by the bend alone.
    const auto probe = point_ahead(at_.y + kProbe * at_.tangent, kProbe);
    if (probe) bend_ = (probe->tangent - at_.tangent) / kProbe;
    return s(at_) < 0;
  }

  /// Goes to the end of a step; false where the curve ends there.
  bool advance(const PairStep& step) {
    watch(step);
    const bool goes_on = pass(step);
    curve_.last = time(step.b);
    curve_.is_lost = false;
    if (!goes_on) return false;
    bend_ = (step.b.tangent - step.a.tangent) / step.length;
    at_ = step.b;
    // u0.u = 1 says little once u has turned away from u0.
    constexpr double kTurnedAway = 1.2;
    const PairVector y = equations_.normalized(at_.y);
    if (std::abs(s(at_)) * kTurnedAway < std::abs(y[equations_.at_s()])) {
      const auto point = equations_.corrected(y, y, at_.tangent, at_.tangent.dot(y).real(),
                                              equations_.without_u_and_s(at_.tangent));
      curve_.is_lost = !point;
      if (!point) return false;
      at_ = *point;
      base_ = y;
    }
    const bool stays_real =
        met_ && std::abs(time(at_) - met_->time) > kBriefest * equations_.duration();
    return !stays_real;
  }

  const PairEquations& equations_;
  const std::vector<double>& times_;
  const PassingPair& passing_;
  const std::atomic<bool>& stop_;
  PairPoint at_;
  PairVector base_;  ///< whose u is u0
  PairVector bend_;  ///< y'', by the step before
  double h_ = kFirstPairStep;
  std::optional<Meeting> met_;  ///< since it the roots are real
  std::array<Point, 2> life_;   ///< they, soon after
  double life_at_ = 0;
  /// Since they met: they are two of three roots, of which the third one is between two dead
  /// points.
  bool has_turned_ = false;
  PairCurve curve_;
};

}  // namespace

PairCurve follow_pair(const PairEquations& equations, const Point& x, double time, bool forwards,
                      const std::vector<double>& times, const PassingPair& passing,
                      const std::atomic<bool>& stop) {
  return PairFollower(equations, times, passing, stop).run(x, time, forwards);
}

}  // namespace moivre
