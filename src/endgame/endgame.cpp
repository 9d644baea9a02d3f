// SPDX-License-Identifier: MIT
// The endgame as a machine of three phases: the whole way, approach, circle.
#include "moivre/endgame/endgame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "face.h"

namespace moivre {
namespace {

// Sights begin here: most regular paths jump to t = 1 from farther out, and a sight costs as much as several steps.
constexpr double kSightRadius = 0.02;
// Sights are kept at radii at least this factor apart; a steady valuation is one that this many agree on.
constexpr double kSightSpacing = 2;
constexpr std::size_t kSteadySights = 6;
constexpr double kSteadyTolerance = 0.01;
// A coordinate that vanishes as fast as 1 - t or faster is soon all rounding: its valuation says nothing.
constexpr double kVanishing = 1;
// The slowest growth that counts: winding numbers up to 20 at infinity.
constexpr double kLeastValuation = 0.05;
// Where a path diverges to a singular point at infinity the condition has reached this, and grown; from
// the second value on there is no telling the point from a finite one in double.
constexpr double kDivergedCondition = 1e4;
constexpr double kSingularCondition = 1e9;
// A finite root may grow like one at infinity for a while (cyclic-7: by r^{-1/7} down to r = 1e-7). Below
// that condition a path has to have gone far, and been steady for long.
constexpr double kDivergedSize = 1e3;
constexpr std::size_t kLongSights = 12;
constexpr double kConditionGrowth = 10;
// A large but finite root has a steady valuation near a whole number until 1 - t is smaller than its
// inverse size; such valuations have to lead further before they are believed.
constexpr double kWhole = 0.1;
constexpr double kWholeSize = 1e8;
// From this condition on growth that does not fade tells infinity. Before a finite singular end of winding number m it
// fades like r^{1/m}; before a regular one, of conditions up to 1e14 (rps10), some of it fades sooner than the rest.
constexpr double kHopelessCondition = 1e12;
constexpr double kDriftTolerance = 0.05;  // relative, of the valuations of what grows
// Beyond rounding at such conditions a drift has to be fading.
constexpr double kSettledTolerance = 1e-3;
// So near the end a growing path of this size is asked whether it has left for infinity.
constexpr double kBeyondRadius = 1e-3;
constexpr double kBeyondSize = 1e9;
// |x_0| / |x|_inf that rounding leaves of 0, and the relative correction from which x_0 is made of rounding errors.
constexpr double kRoundedZero = 1e-13;
constexpr double kUnknownCorrection = 1e-2;
// Of an end that double-double has found.
constexpr double kFineAccuracy = 1e-24;
// A path that still creeps at this radius ends singular: to a regular end it would have jumped.
constexpr double kCreepingRadius = 1e-4;
// So many steps inside it tell creeping from a step that chanced to end there; the first one does where
// the condition has grown on the way.
constexpr int kCreepingSteps = 3;
// One that grows or is large, and shows no steady valuations until here, descends towards t = 1 in
// log(1 - t), this far.
constexpr double kDivergingRadius = 1e-10;
constexpr double kDescent = 1e-30;
// Steps inside the watch radius after which circles are tried whatever the radius.
constexpr int kPatience = 300;
// One that grows is given more: at infinity circles are harder than the way.
constexpr int kDivergingPatience = 1000;
constexpr double kLeastRadius = 1e-14;
constexpr double kShrink = 4;
// Negative powers count when they exceed this fraction of the spread of the samples; their number.
constexpr double kPrincipalPart = 1e-8;
constexpr int kPrincipalTerms = 8;
// Relative error of a sample, a multiple of its condition.
constexpr double kNoise = 1e-14;
// Where several sheets meet J is singular. When a circle closes after several turns about a mean that
// is less singular than this, it may have run round branch points beside t = 1: landing tells.
constexpr double kBranchCondition = 1e10;
constexpr double kBranchResidual = 1e-14;
// Newton at a regular end: the correction aimed at, and the one that passes where rounding stops it.
constexpr double kRegularTolerance = 1e-13;
constexpr double kStagnation = 1e-10;
// A circle is closed when the point comes back to within this distance, relative.
constexpr double kClosure = 1e-6;
// Two radii agree to this: good enough at once, good enough after all.
constexpr double kAgreementAtOnce = 1e-10;
constexpr double kAgreementAtLast = 1e-5;

const PathTime kEnd(1.0, 0.0);

double difference(const Point& a, const Point& b) {
  double largest = 0;
  double size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return largest / size;
}

/// Of 0 that of the smallest double.
Complex logarithm(const Complex& z) {
  return {std::log(std::max(std::abs(z), std::numeric_limits<double>::min())), std::arg(z)};
}

}  // namespace

std::string to_string(PathStatus status) {
  switch (status) {
    case PathStatus::finite:
      return "finite";
    case PathStatus::at_infinity:
      return "at infinity";
    case PathStatus::failed:
      return "failed";
  }
  return "";
}

std::string to_string(Failure failure) {
  switch (failure) {
    case Failure::step_limit:
      return "step limit";
    case Failure::step_too_small:
      return "step too small";
    case Failure::precision:
      return "precision";
    case Failure::bad_start:
      return "bad start";
    case Failure::cancelled:
      return "cancelled";
    case Failure::jumped:
      return "jumped";
  }
  return "";
}

Failure to_failure(Journey journey) {
  switch (journey) {
    case Journey::bad_start:
      return Failure::bad_start;
    case Journey::step_limit:
      return Failure::step_limit;
    case Journey::cancelled:
      return Failure::cancelled;
    case Journey::arrived:
    case Journey::stopped:
    case Journey::step_too_small:
    case Journey::off_path:
      return Failure::step_too_small;
  }
  return Failure::step_too_small;
}

Endgame::Endgame(const EndgameOptions& options, const Chart& chart, std::uint64_t path, int care,
                 Manner manner)
    : options_(options), chart_(chart), path_(path), care_(care), manner_(manner) {}

Departure Endgame::depart(Point start, FramePointer frame) {
  tangent_.resize(start.size());
  frame_ = std::move(frame);
  Departure departure = along(Contour::segment(0, 1), std::move(start), 0, this);
  departure.watch_radius = options_.watch_radius;
  return departure;
}

Departure Endgame::along(const Contour& contour, Point x, int samples, Watcher* watcher) {
  Departure departure;
  departure.path = path_;
  departure.contour = contour;
  departure.x = std::move(x);
  departure.care = care_;
  departure.samples = samples;
  departure.watcher = watcher;
  departure.frame = frame_;
  return departure;
}

// Valuations from the tangent at x; J is linearized there.
Endgame::Sight Endgame::sight(const Point& x, double radius, PathSystem& path) {
  path.tangent(1.0, tangent_);
  const auto logarithmic_slope = [&](std::size_t i) {
    const double size = std::norm(x[i]);
    return size > 0 ? -radius * conjugate_product(x[i], tangent_[i]) / size : Complex();
  };
  const std::size_t n = chart_.unknowns;
  const Complex homogenizing = logarithmic_slope(chart_.homogenizing());
  Sight now{radius, {}, {}, 0, path.condition(), 0};
  for (std::size_t i = 0; i < n; ++i) {
    const Complex slope = logarithmic_slope(i) - homogenizing;
    now.valuations.push_back(slope.real());
    now.turning.push_back(slope.imag());
    now.least = std::min(now.least, now.valuations.back());
    now.size = std::max(now.size, std::abs(x[i]));
  }
  now.size /= std::max(std::abs(chart_.x0(x)), std::numeric_limits<double>::min());
  return now;
}

// A sight costs several steps, and a regular path arrives before there are enough of them to tell anything: until then
// the points are kept, to be seen together.
bool Endgame::is_time_to_look(double radius) const {
  return sights_.size() + unseen_.size() >= kSteadySights || radius < kCreepingRadius ||
         watched_ > kPatience || phase_ == Phase::descent;
}

bool Endgame::look(PathSystem& path) {
  const std::vector<Unseen> points = std::exchange(unseen_, {});
  for (const Unseen& point : points) {
    if (!path.linearize(point.x, point.t)) return false;
    sights_.push_back(sight(point.x, std::abs(point.t.rest), path));
  }
  return true;
}

Watcher::Verdict Endgame::watch(const StepRecord& step, PathSystem& path) noexcept {
  const double radius = std::abs(step.t.rest);
  if (radius > options_.watch_radius || radius == 0) return Verdict::go_on;
  if (manner_ == Manner::straight) return watch_straight(step, path);
  ++watched_;
  if (outpost_.empty() || radius > kCreepingRadius / kShrink) {
    outpost_.assign(step.x.begin(), step.x.end());
    radius_ = radius;
  }
  if (radius > kSightRadius) return watched_ > kPatience ? Verdict::stop : Verdict::go_on;
  if (radius * kSightSpacing <= last_kept_) {
    unseen_.push_back({Point(step.x.begin(), step.x.end()), step.t});
    last_kept_ = radius;
  }
  if (!is_time_to_look(radius)) return Verdict::go_on;
  if (!unseen_.empty()) {
    if (!look(path)) return Verdict::stop;
    if (diverges(kSteadyTolerance) &&
        leads_to_infinity(Point(step.x.begin(), step.x.end()), radius, path)) {
      cut_ = true;
      return Verdict::stop;
    }
  }
  if (watched_ > (may_diverge() ? kDivergingPatience : kPatience)) return Verdict::stop;
  if (phase_ == Phase::descent) return may_diverge() ? Verdict::go_on : Verdict::stop;
  if (radius < (may_diverge() ? kDivergingRadius : kCreepingRadius)) ++creeping_;
  const bool worsens = sights_.back().condition > kConditionGrowth * sights_.front().condition;
  return creeping_ >= (worsens ? 1 : kCreepingSteps) ? Verdict::stop : Verdict::go_on;
}

// Only infinity ends a straight way. A sight lies between two points and holds the mean valuations; rounding hardly
// disturbs them, so that what is steady is steadier than in double.
Watcher::Verdict Endgame::watch_straight(const StepRecord& step, PathSystem& path) noexcept {
  const double radius = std::abs(step.t.rest);
  if (radius > kSightRadius ||
      (!logarithms_.empty() && radius * kSightSpacing > logarithms_radius_)) {
    return Verdict::go_on;
  }
  const std::size_t n = chart_.unknowns;
  // The logarithms, imaginary parts included, of the affine coordinates.
  std::vector<Complex> logarithms(n);
  for (std::size_t i = 0; i < n; ++i)
    logarithms[i] = logarithm(step.x[i]) - logarithm(chart_.x0(step.x));
  if (!logarithms_.empty()) {
    const double condition =
        path.linearize(step.x, step.t) ? path.condition() : std::numeric_limits<double>::infinity();
    Sight now{radius, {}, {}, 0, condition, 0};
    for (std::size_t i = 0; i < n; ++i) {
      const Complex change = logarithms[i] - logarithms_[i];
      const double turn = std::remainder(change.imag(), 2 * std::numbers::pi);
      const double decline = std::log(logarithms_radius_ / radius);
      now.valuations.push_back(-change.real() / decline);
      now.turning.push_back(-turn / decline);
      now.least = std::min(now.least, now.valuations.back());
      now.size = std::max(now.size, std::exp(logarithms[i].real()));
    }
    sights_.push_back(std::move(now));
    cut_ = (diverges(kSettledTolerance) || diverges_beyond_double()) &&
           leads_to_infinity(Point(step.x.begin(), step.x.end()), radius, path);
  }
  logarithms_ = std::move(logarithms);
  logarithms_radius_ = radius;
  return cut_ ? Verdict::stop : Verdict::go_on;
}

bool Endgame::may_diverge() const {
  if (sights_.empty()) return false;  // stopped before anything was seen
  return sights_.back().least < -kLeastValuation || sights_.back().size > kDivergedSize;
}

// All coordinates that do not vanish have had the same valuations for several sights: the path is in
// its last phase.
bool Endgame::valuations_are_steady(std::size_t sights, double tolerance) const {
  if (sights_.size() < sights) return false;
  const Sight& then = sights_[sights_.size() - sights];
  const Sight& now = sights_.back();
  for (std::size_t i = 0; i < now.valuations.size(); ++i) {
    if (std::min(then.valuations[i], now.valuations[i]) >= kVanishing) continue;
    if (drift(i, sights) > tolerance) return false;
  }
  return true;
}

// How far coordinate i's valuation has been from the last, of that many sights. A leading power of 1 - t turns no
// coordinate in the complex plane: what turns it comes of the next term, be it the finite root that is left in the end,
// and shows to first order where the valuation may show it only to second.
double Endgame::drift(std::size_t i, std::size_t sights) const {
  const double now = sights_.back().valuations[i];
  double farthest = std::abs(sights_.back().turning[i]);
  for (auto s = sights_.end() - static_cast<std::ptrdiff_t>(sights); s != sights_.end(); ++s) {
    farthest = std::max(farthest, std::abs(s->valuations[i] - now));
  }
  return farthest / (1 + std::abs(now));
}

// What disturbs the leading power of coordinate i changes ever less, over equal factors of 1 - t: it fades on the way to
// infinity, as a power of 1 - t, and grows on the way to a finite point.
bool Endgame::settles(std::size_t i) const {
  const Sight& then = sights_[sights_.size() - kSteadySights];
  const Sight& between = sights_[sights_.size() - kSteadySights / 2];
  const Sight& now = sights_.back();
  const auto rate = [i](const Sight& from, const Sight& to) {
    const double change =
        std::hypot(to.valuations[i] - from.valuations[i], to.turning[i] - from.turning[i]);
    return change / std::log(from.radius / to.radius);
  };
  return rate(between, now) <= rate(then, between);
}

// What grows does so evenly, and none of it, but by whole powers, has faded as it does before a finite singular end.
bool Endgame::growth_lasts(double tolerance) const {
  const Sight& then = sights_[sights_.size() - kSteadySights];
  const Sight& now = sights_.back();
  const double fading = std::pow(now.radius / then.radius, 0.5 / options_.maximum_winding);
  bool lasts = false;
  for (std::size_t i = 0; i < now.valuations.size(); ++i) {
    const double v = now.valuations[i];
    if (v > -kLeastValuation) continue;
    const double change = drift(i, kSteadySights);
    if (change > tolerance || (change > kSettledTolerance && !settles(i))) return false;
    if (std::abs(v - std::round(v)) < kWhole) continue;
    if (v > fading * then.valuations[i]) return false;
    lasts = true;
  }
  return lasts;
}

bool Endgame::diverges(double tolerance) const {
  if (sights_.size() < kSteadySights) return false;
  const Sight& first = sights_.front();
  const Sight& then = sights_[sights_.size() - kSteadySights];
  const Sight& now = sights_.back();
  if (now.least > -kLeastValuation) return false;
  const bool beyond = now.size > kBeyondSize && now.radius < kBeyondRadius;
  if (beyond && now.size > then.size) return true;
  const bool hopeless = now.condition > kHopelessCondition && now.condition > then.condition;
  if (hopeless && growth_lasts(kDriftTolerance)) return true;
  if (!valuations_are_steady(kSteadySights, tolerance)) return false;
  const bool whole = std::abs(now.least - std::round(now.least)) < kWhole;
  const bool far = whole
                       ? now.size > kWholeSize
                       : now.size > kDivergedSize && valuations_are_steady(kLongSights, tolerance);
  return (far || now.condition > kSingularCondition) && now.condition > kDivergedCondition &&
         now.condition > kConditionGrowth * first.condition && now.condition > then.condition;
}

bool Endgame::diverges_beyond_double() const {
  return sights_.size() >= kSteadySights && sights_.back().condition > kHopelessCondition &&
         growth_lasts(kSteadyTolerance);
}

// Growth that was found to lead nowhere is asked again further on.
bool Endgame::leads_to_infinity(const Point& x, double radius, const PathSystem& path) {
  if (radius * kShrink > doubted_) return false;
  doubted_ = radius;
  return stays_at_infinity(x, radius, path);
}

// Of a path on its way from a singular root of its faces to a large finite root beside it valuations are nowhere nearer to
// those of the faces than the inverse square root of that size.
bool Endgame::stays_at_infinity(const Point& x, double radius, const PathSystem& path) const {
  const FaceRoot root =
      face_root(path.homotopy(), outside(frame_, x), radius, sights_.back().valuations);
  if (root.kind != FaceRoot::Kind::singular) return root.kind == FaceRoot::Kind::regular;
  return root.misfit <= kSettledTolerance &&
         valuations_are_steady(kSteadySights, kSettledTolerance);
}

std::nullopt_t Endgame::fail(Failure failure) {
  end_.status = PathStatus::failed;
  end_.failure = failure;
  return std::nullopt;
}

std::optional<Departure> Endgame::accept(Arrival&& arrival, PathSystem& path) {
  path.set_frame(frame_.get());
  std::optional<Departure> next = proceed(std::move(arrival), path);
  if (!next && !end_.x.empty()) {
    end_.size = 1 / chart_.finiteness(end_.x);
    end_.x = outside(frame_, std::move(end_.x));
    end_.frame = frame_;
  }
  return next;
}

std::optional<Departure> Endgame::proceed(Arrival&& arrival, PathSystem& path) {
  end_.count += arrival.count;
  end_.t = arrival.t.t;
  if (arrival.journey == Journey::cancelled) return fail(Failure::cancelled);
  switch (phase_) {
    case Phase::whole_way:
      return judge_arrival(std::move(arrival), path);
    case Phase::descent:
      if (cut_) return at_infinity();
      if (is_handed_on(arrival)) return fail(Failure::precision);
      return is_regular_arrival(arrival, path, landing_condition()) ? std::nullopt : begin_circle();
    case Phase::approach:
      if (arrival.journey != Journey::arrived) return conclude(path);
      outpost_ = std::move(arrival.x);
      radius_ /= kShrink;
      return begin_circle();
    case Phase::circle:
      return next_turn(std::move(arrival), path);
    case Phase::landing:
      return is_regular_arrival(arrival, path, landing_condition()) ? std::nullopt : conclude(path);
  }
  return std::nullopt;
}

std::nullopt_t Endgame::at_infinity() {
  end_.status = PathStatus::at_infinity;
  end_.condition = sights_.back().condition;
  return std::nullopt;
}

std::optional<Departure> Endgame::judge_arrival(Arrival&& arrival, PathSystem& path) {
  end_.x = arrival.x;
  if (cut_) return at_infinity();
  if (arrival.regular_condition) {
    end_.condition = *arrival.regular_condition;
    end_.accuracy = kFineAccuracy;
    return decide_infinity(path);
  }
  // Without a watched point there is nowhere to turn back to: the root it arrived at proves itself later.
  const double condition =
      outpost_.empty() ? std::numeric_limits<double>::infinity() : options_.regular_condition;
  if (is_regular_arrival(arrival, path, condition)) return std::nullopt;
  if (outpost_.empty()) return fail(to_failure(arrival.journey));
  if (is_handed_on(arrival)) return fail(Failure::precision);
  if (arrival.journey == Journey::stopped && may_diverge()) return descend(std::move(arrival));
  if (arrival.journey == Journey::arrived && chart_.finiteness(arrival.x) <= kRoundedZero) {
    arrival.x = outpost_;
    arrival.t = PathTime(1.0 - radius_, radius_);
    return descend(std::move(arrival));
  }
  return begin_circle();
}

// It grows, and breaks off where double tells little of J.
bool Endgame::is_handed_on(const Arrival& arrival) const {
  const bool breaks_off =
      arrival.journey == Journey::step_too_small || arrival.journey == Journey::off_path;
  return manner_ == Manner::thrifty && breaks_off && may_diverge() &&
         sights_.back().condition > kSingularCondition;
}

// Straight towards t = 1 in log(1 - t): where branch points crowd about t = 1, valuations settle late.
Departure Endgame::descend(Arrival&& arrival) {
  phase_ = Phase::descent;
  watched_ = 0;
  return along(Contour::spiral(arrival.t.rest, std::log(kDescent)), std::move(arrival.x), 0, this);
}

// Affine patch a x = 1 through the first outpost: samples of one homogeneous path become points of one chart.
Point Endgame::normalized(const Point& x) const {
  Complex scale = 0;
  for (std::size_t i = 0; i < x.size(); ++i) scale += product(patch_[i], x[i]);
  Point result = x;
  for (Complex& xi : result) xi /= scale;
  return result;
}

std::optional<Departure> Endgame::begin_circle() {
  phase_ = Phase::circle;
  ++radii_;
  turns_ = 0;
  samples_.clear();
  if (patch_.empty()) {
    for (const Complex& xi : outpost_) patch_.push_back(std::conj(xi));
  }
  turn_begin_ = normalized(outpost_);
  return along(Contour::spiral(radius_, Complex(0, 2 * std::numbers::pi)), outpost_,
               options_.samples);
}

std::optional<Departure> Endgame::next_turn(Arrival&& arrival, PathSystem& path) {
  if (arrival.journey != Journey::arrived) return shrink(path);
  ++turns_;
  for (const Point& sample : arrival.samples) samples_.push_back(normalized(sample));
  if (difference(samples_.back(), turn_begin_) < kClosure) return estimate_end(path);
  if (turns_ >= options_.maximum_winding || end_.count.accepted > options_.maximum_steps) {
    return shrink(path);
  }
  return along(Contour::spiral(radius_, Complex(0, 2 * std::numbers::pi)), std::move(arrival.x),
               options_.samples);
}

// Coefficient c_j of the Laurent series in u = (1 - t)^{1/m} / r^{1/m}, from the samples on |u| = 1.
Point Endgame::laurent_coefficient(int j) const {
  const auto count = static_cast<double>(samples_.size());
  Point c(patch_.size());
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const double angle = 2 * std::numbers::pi * j * static_cast<double>(k + 1) / count;
    const Complex weight = std::polar(1 / count, -angle);
    for (std::size_t i = 0; i < c.size(); ++i) c[i] += product(weight, samples_[k][i]);
  }
  return c;
}

// A path is a power series in u when t = 1 is its only branch point inside the circle. Others, inside
// as well, show as negative powers; so does aliasing, when the circle is too wide for its samples.
bool Endgame::is_power_series(const Point& constant, PathSystem& path) const {
  double spread = 0;
  for (const Point& sample : samples_) spread = std::max(spread, difference(sample, constant));
  const double condition =
      path.linearize(samples_.back(), PathTime(1.0 - radius_, radius_)) ? path.condition() : 0;
  const double noise = kNoise * (1 + condition);
  const int terms = std::min(kPrincipalTerms, static_cast<int>(samples_.size()) / 4);
  for (int j = 1; j <= terms; ++j) {
    const double size = max_norm(laurent_coefficient(-j)) / max_norm(constant);
    if (size > kPrincipalPart * spread + noise) return false;
  }
  return true;
}

// Size of the highest coefficient that the samples resolve: what comes after it is aliased.
double Endgame::truncation() const {
  return max_norm(laurent_coefficient(static_cast<int>(samples_.size()) / 2 - 1));
}

std::optional<Departure> Endgame::estimate_end(PathSystem& path) {
  Estimate estimate{laurent_coefficient(0), turns_};
  if (!is_power_series(estimate.x, path)) {
    last_.reset();
    return shrink(path);
  }
  if (last_ && last_->winding == estimate.winding) {
    const double change = difference(estimate.x, last_->x);
    if (!best_ || change < best_difference_) {
      best_ = estimate;
      best_difference_ = change;
    } else {
      return conclude(path);
    }
    if (change < kAgreementAtOnce) return conclude(path);
  } else if (!best_) {
    best_ = estimate;
    best_difference_ = truncation();
  }
  last_ = std::move(estimate);
  return shrink(path);
}

std::optional<Departure> Endgame::shrink(PathSystem& path) {
  if (radii_ >= options_.maximum_radii || radius_ / kShrink < kLeastRadius ||
      end_.count.accepted > options_.maximum_steps) {
    return conclude(path);
  }
  phase_ = Phase::approach;
  return along(Contour::spiral(radius_, -std::log(kShrink)), outpost_);
}

// With an estimate at hand a landing has to prove it wrong; without one, any landing is welcome, and the
// root it leads to is proved on the system as given.
double Endgame::landing_condition() const {
  return best_ ? kBranchCondition : std::numeric_limits<double>::infinity();
}

std::optional<Departure> Endgame::land() {
  phase_ = Phase::landing;
  return along(Contour::landing(radius_), outpost_);
}

std::optional<Departure> Endgame::conclude(PathSystem& path) {
  if (!best_ || best_difference_ > kAgreementAtLast) {
    if (phase_ == Phase::landing) return fail(Failure::precision);
    return land();
  }
  const double condition =
      path.linearize(best_->x, kEnd) ? path.condition() : std::numeric_limits<double>::infinity();
  const bool singular = condition >= kBranchCondition && path.residual() < kBranchResidual;
  if (best_->winding > 1 && !singular && phase_ != Phase::landing) return land();
  end_.x = best_->x;
  end_.winding = best_->winding;
  end_.accuracy = std::max(best_difference_, std::numeric_limits<double>::epsilon());
  end_.t = 1;
  end_.condition = condition;
  end_.singular = best_->winding > 1 || condition > options_.singular_condition;
  return decide_infinity(path);
}

// x_0 beside its error tells; where it may be 0, the face of the path's direction.
std::nullopt_t Endgame::decide_infinity(const PathSystem& path) {
  end_.status = PathStatus::finite;
  if (chart_.finiteness(end_.x) > 10 * end_.accuracy) return std::nullopt;
  const bool is_infinite =
      end_.accuracy <= kFineAccuracy ||
      (!sights_.empty() && !outpost_.empty() && stays_at_infinity(outpost_, radius_, path));
  if (!is_infinite) return fail(Failure::precision);
  end_.status = PathStatus::at_infinity;
  return std::nullopt;
}

bool Endgame::is_regular_arrival(const Arrival& arrival, PathSystem& path, double condition) {
  if (arrival.journey != Journey::arrived) return false;
  CorrectorOptions newton;
  newton.tolerance = kRegularTolerance;
  Point x = arrival.x;
  const Correction correction = path.correct(x, kEnd, newton, true);
  end_.condition = path.condition();
  if (end_.condition > condition || !(correction.converged || correction.last < kStagnation)) {
    return false;
  }
  // x_0 that is made of rounding errors may be 0: not here is it to be told.
  const double moved = std::abs(chart_.x0(path.last_correction()));
  const bool is_known = moved <= kUnknownCorrection * std::abs(chart_.x0(x));
  if (!is_known || chart_.finiteness(x) <= kRoundedZero) return false;
  end_.x = std::move(x);
  end_.accuracy = correction.last;
  end_.status = PathStatus::finite;
  return true;
}

}  // namespace moivre
