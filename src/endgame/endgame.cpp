// SPDX-License-Identifier: MIT
// The endgame as a machine of phases: the whole way, approach, circle, landing, the way back.
#include "moivre/endgame/endgame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cycle.h"
#include "face.h"
#include "file_errors.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

const PathTime kEnd(1.0, 0.0);

double difference(const Point& a, const Point& b) {
  double largest = 0;
  double size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::norm(a[i] - b[i]));
    size = std::max(size, std::norm(b[i]));
  }
  return std::sqrt(largest / size);
}

/// One combination of the coordinates of each, which tells points apart but for bad luck.
std::vector<Complex> combinations(const std::vector<Point>& points, std::uint64_t path) {
  std::vector<Complex> phases;
  for (std::size_t i = 0; i < points.front().size(); ++i) {
    phases.push_back(random_phase(path, RandomStream::slice, i));
  }
  std::vector<Complex> z;
  for (const Point& point : points) {
    Complex& sum = z.emplace_back();
    for (std::size_t i = 0; i < point.size(); ++i) sum = add_product(phases[i], point[i], sum);
  }
  return z;
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

Failure to_failure(SegmentStatus status) {
  switch (status) {
    case SegmentStatus::bad_start:
      return Failure::bad_start;
    case SegmentStatus::step_limit:
      return Failure::step_limit;
    case SegmentStatus::cancelled:
      return Failure::cancelled;
    case SegmentStatus::arrived:
    case SegmentStatus::stopped:
    case SegmentStatus::step_too_small:
    case SegmentStatus::off_path:
      return Failure::step_too_small;
  }
  return Failure::step_too_small;
}

Endgame::Endgame(const EndgameOptions& options, const Chart& chart, std::uint64_t path,
                 int tolerance_level)
    : options_(options), chart_(chart), path_(path), tolerance_level_(tolerance_level) {}

PathSegment Endgame::depart(Point start, FramePointer frame) {
  frame_ = std::move(frame);
  PathSegment segment = along(Contour::segment(0, 1), std::move(start), 0, this);
  segment.watch_radius = options_.ends.watch_radius;
  return segment;
}

PathSegment Endgame::along(const Contour& contour, Point x, int samples, Watcher* watcher) {
  PathSegment segment;
  segment.path = path_;
  segment.contour = contour;
  segment.x = std::move(x);
  segment.tolerance_level = tolerance_level_;
  segment.samples = samples;
  segment.watcher = watcher;
  segment.frame = frame_;
  return segment;
}

Watcher::Verdict Endgame::watch(const StepRecord& step, PathSystem&) {
  const double radius = std::abs(step.t.rest);
  if (radius > options_.ends.watch_radius || radius == 0) return Verdict::go_on;
  if (endgame_start_.empty() || radius > options_.ends.first_radius / options_.ends.shrink) {
    endgame_start_.assign(step.x.begin(), step.x.end());
    radius_ = radius;
  }
  if (radius < options_.ends.creeping_radius && !options_.goes_straight) ++creeping_;
  return creeping_ >= options_.creeping_steps ? Verdict::stop : Verdict::go_on;
}

std::nullopt_t Endgame::fail(Failure failure) {
  end_.status = PathStatus::failed;
  end_.failure = failure;
  return std::nullopt;
}

std::optional<PathSegment> Endgame::accept(SegmentResult&& reached, PathSystem& path) {
  path.set_frame(frame_.get());
  return hand_on(proceed(std::move(reached), path), path);
}

std::optional<PathSegment> Endgame::hand_on(std::optional<PathSegment> next, PathSystem& path) {
  if (!next && may_look_again()) next = look_again(path);
  if (!next && may_go_back()) next = go_back();
  if (!next && !waits_) deliver_end();
  return next;
}

// Not from a regular end: that one root is at the end of one path alone follows from the root.
bool Endgame::may_go_back() const {
  const bool is_told_by_circles = end_.status == PathStatus::at_infinity || end_.winding;
  return options_.goes_back && !waits_ && phase_ != Phase::way_back && !turn_begin_.empty() &&
         end_.status != PathStatus::failed && is_told_by_circles;
}

PathSegment Endgame::go_back() {
  phase_ = Phase::way_back;
  const double wide = common_radius(options_.ends.watch_radius);
  return along(Contour::spiral(radius_, std::log(wide / radius_)), turn_begin_);
}

void Endgame::arrive_back(SegmentResult&& reached) {
  end_.count += reached.count;
  if (reached.status == SegmentStatus::arrived) end_.sheet = outside(frame_, std::move(reached.x));
}

void Endgame::deliver_end() {
  const bool may_be_taken_up =
      end_.status == PathStatus::failed && (options_.only_regular || are_steps_spent());
  if (!may_be_taken_up) end_.endgame_start.reset();
  if (end_.x.empty()) return;
  end_.size = 1 / chart_.finiteness(end_.x);
  end_.x = outside(frame_, std::move(end_.x));
}

std::optional<PathSegment> Endgame::proceed(SegmentResult&& reached, PathSystem& path) {
  if (phase_ == Phase::way_back && reached.status != SegmentStatus::cancelled) {
    arrive_back(std::move(reached));
    return std::nullopt;
  }
  end_.count += reached.count;
  end_.t = reached.t.t;
  if (reached.status == SegmentStatus::cancelled) return fail(Failure::cancelled);
  switch (phase_) {
    case Phase::whole_way:
      return judge_result(std::move(reached), path);
    case Phase::first_approach:
    case Phase::approach:
      if (reached.status == SegmentStatus::arrived) {
        endgame_start_ = std::move(reached.x);
        radius_ = next_radius_;
      } else if (phase_ == Phase::approach) {
        return conclude(path);
      }
      return begin_circle();
    case Phase::circle:
      return next_turn(std::move(reached), path);
    case Phase::landing:
      return is_regular_end(reached, path, landing_condition()) ? std::nullopt : conclude(path);
    case Phase::way_back:
      break;
  }
  return std::nullopt;
}

std::optional<PathSegment> Endgame::judge_result(SegmentResult&& reached, PathSystem& path) {
  end_.x = reached.x;
  if (reached.regular_condition) {
    end_.condition = *reached.regular_condition;
    end_.accuracy = reached.accuracy;
    if (is_known_finite()) return take_finite();
    if (endgame_start_.empty()) return fail(Failure::precision);
  }
  // Without a watched point there is nowhere to turn back to: the root it arrived at proves itself
  // later.
  const double condition = endgame_start_.empty() ? std::numeric_limits<double>::infinity()
                                                  : options_.ends.regular_condition;
  if (is_regular_end(reached, path, condition)) return std::nullopt;
  if (endgame_start_.empty()) return fail(to_failure(reached.status));
  if (options_.only_regular) {
    end_.endgame_start = {endgame_start_, radius_, frame_};
    return fail(reached.status == SegmentStatus::step_limit ? Failure::step_limit
                                                            : Failure::precision);
  }
  return turn_to_circles(path);
}

PathSegment Endgame::take_up(const EndgameStart& endgame_start, PathSystem& path) {
  end_.is_taken_up = true;
  frame_ = endgame_start.frame;
  path.set_frame(frame_.get());
  endgame_start_ = endgame_start.x;
  radius_ = endgame_start.radius;
  return turn_to_circles(path);
}

PathSegment Endgame::turn_to_circles(PathSystem& path) {
  polish_endgame_start(path);
  end_.endgame_start = {endgame_start_, radius_, frame_};
  steps_of_way_ = end_.count.accepted;
  phase_ = Phase::first_approach;
  // Others of its cycle may have been seen last farther out, and wait for it there.
  return approach(std::max(common_radius(radius_), options_.ends.first_radius));
}

// A tracker that has t = 1 in view passes points of the way as near to the path as it needs for
// that.
void Endgame::polish_endgame_start(PathSystem& path) {
  Point x = endgame_start_;
  const PathTime time{1.0 - radius_, radius_};
  if (path.correct(x, time, CorrectorOptions{}, true).converged) endgame_start_ = std::move(x);
}

bool Endgame::may_look_again() const {
  return end_.failure == Failure::precision && frame_ && !looks_again_ && end_.endgame_start &&
         !options_.only_regular;
}

// A path may have gone far since it set out: in the units of the point from where its end was
// looked at in vain it may be seen.
std::optional<PathSegment> Endgame::look_again(PathSystem& path) {
  looks_again_ = true;
  end_.failure.reset();
  last_.reset();
  best_.reset();
  const Point endgame_start = outside(end_.endgame_start->frame, end_.endgame_start->x);
  frame_ = std::make_shared<const PathFrame>(frame_at(path.homotopy(), endgame_start));
  path.set_frame(frame_.get());
  endgame_start_ = inside(frame_, endgame_start);
  radius_ = end_.endgame_start->radius;
  return begin_circle();
}

// Affine patch a x = 1 through the circle's beginning: samples of one homogeneous path become
// points of one chart.
Point Endgame::normalized(Point x) const {
  Complex scale = 0;
  for (std::size_t i = 0; i < x.size(); ++i) scale += product(patch_[i], x[i]);
  const Complex inverse = reciprocal(scale);
  for (Complex& xi : x) xi = product(inverse, xi);
  return x;
}

// The least of the radii that all paths have in common that is no smaller than this one.
double Endgame::common_radius(double radius) const {
  const double last = options_.ends.first_radius / options_.ends.shrink;
  const double steps = std::log(radius / last) / std::log(options_.ends.shrink);
  return last * std::pow(options_.ends.shrink, std::ceil(steps));
}

PathSegment Endgame::approach(double radius) {
  next_radius_ = radius;
  return along(Contour::spiral(radius_, std::log(radius / radius_)), endgame_start_);
}

Contour Endgame::circle() const {
  return Contour::spiral(radius_, Complex(0, 2 * std::numbers::pi));
}

PathSegment Endgame::walk_turn(Point x) {
  return along(circle(), std::move(x), options_.ends.samples);
}

std::optional<PathSegment> Endgame::begin_circle() {
  phase_ = Phase::circle;
  turns_ = 0;
  samples_.clear();
  patch_.clear();
  for (const Complex& xi : endgame_start_) patch_.push_back(std::conj(xi));
  turn_begin_ = normalized(endgame_start_);
  return walk_turn(endgame_start_);
}

bool Endgame::are_steps_spent() const {
  return end_.count.accepted > steps_of_way_ + options_.ends.maximum_steps;
}

bool Endgame::may_wait() const {
  return options_.may_wait && radius_ == next_radius_ && !looks_again_;
}

std::optional<PathSegment> Endgame::next_turn(SegmentResult&& reached, PathSystem& path) {
  if (reached.status != SegmentStatus::arrived) return shrink(path);
  ++turns_;
  for (Point& sample : reached.samples) samples_.push_back(normalized(std::move(sample)));
  if (difference(samples_.back(), turn_begin_) < options_.ends.agreement) return estimate_end(path);
  if (turns_ >= options_.ends.maximum_winding || are_steps_spent()) return shrink(path);
  if (!may_wait()) return walk_turn(std::move(reached.x));
  waits_ = true;
  turn_end_ = std::move(reached.x);
  return std::nullopt;
}

PathSegment Endgame::walk_on() {
  waits_ = false;
  return walk_turn(std::move(turn_end_));
}

std::vector<Point> Endgame::samples() const {
  std::vector<Point> samples;
  for (const Point& sample : samples_) samples.push_back(outside(frame_, sample));
  return samples;
}

std::optional<PathSegment> Endgame::join(const std::vector<std::vector<Point>>& samples,
                                         std::size_t own, PathSystem& path) {
  path.set_frame(frame_.get());
  waits_ = false;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    for (const Point& sample : samples[(own + k) % samples.size()]) {
      samples_.push_back(normalized(inside(frame_, sample)));
    }
  }
  turns_ = static_cast<int>(samples_.size()) / options_.ends.samples;
  const bool is_cycle = turns_ <= options_.ends.maximum_winding;
  return hand_on(is_cycle ? estimate_end(path) : shrink(path), path);
}

std::optional<PathSegment> Endgame::end_with(const Endgame& sheet) {
  waits_ = false;
  end_.status = sheet.end_.status;
  end_.is_as_rounded = sheet.end_.is_as_rounded;
  if (may_go_back()) return go_back();
  deliver_end();
  return std::nullopt;
}

// Coefficient c_j of the Laurent series in u = (1 - t)^{1/m} / r^{1/m}, from the samples on |u| =
// 1.
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

// Where the path leaves the patch inside the circle its coordinates have poles there: as many fewer
// in the patch x_j = 1 as x_j turns the other way around 0.
void Endgame::leave_poles() {
  const std::vector<int> turns = turns_around_zero(samples_);
  const auto fewest = std::min_element(turns.begin(), turns.end());
  if (*fewest >= 0) return;
  patch_.assign(patch_.size(), 0);
  patch_[static_cast<std::size_t>(fewest - turns.begin())] = 1;
  for (Point& sample : samples_) sample = normalized(std::move(sample));
}

std::vector<Complex> Endgame::samples_of_x0() const {
  std::vector<Complex> x0;
  for (const Point& sample : samples_) x0.push_back(chart_.x0(sample));
  return x0;
}

// In the units of the system, not in those of the path.
bool Endgame::ends_beyond(const std::vector<Complex>& x0) const {
  const double unit =
      chart_.finiteness(endgame_start_) / chart_.finiteness(outside(frame_, endgame_start_));
  return end_beyond(unit / options_.ends.beyond, x0, turns_);
}

// The faces of the cycle's direction have a common root there.
FaceRoot Endgame::place_at_infinity(PathSystem& path) const {
  return face_root(path, outside(frame_, endgame_start_), radius_,
                   valuations(samples_, chart_.homogenizing(), turns_), options_.ends);
}

// Gives the samples all their digits: residuals in double-double. False where Newton's method does
// not converge.
bool Endgame::polish_samples(PathSystem& path) {
  const Contour turn = circle();
  CorrectorOptions newton;
  newton.tolerance = options_.ends.sample_error;  // the next correction would be its square
  newton.fine = true;
  const auto count = static_cast<std::size_t>(options_.ends.samples);
  for (std::size_t of_turn = 0; of_turn < count; ++of_turn) {
    const PathTime time = turn.at(static_cast<double>(of_turn + 1) / static_cast<double>(count));
    // At one t after another: its coefficients are evaluated once for all sheets.
    for (std::size_t k = of_turn; k < samples_.size(); k += count) {
      if (!path.correct(samples_[k], time, newton, true).converged) return false;
      samples_[k] = normalized(std::move(samples_[k]));
    }
  }
  return true;
}

// What the power sums of x_0 are is what the errors of the file's numbers make of them.
bool Endgame::errors_explain(PathSystem& path) const {
  if (path.homotopy().largest_error() == 0) return false;
  const auto changes =
      changes_of_x0(path, frame_.get(), circle(), static_cast<std::size_t>(options_.ends.samples),
                    samples_, patch_);
  const SumsAndErrors sums = sums_and_errors(samples_of_x0(), turns_, 0, options_.ends, changes);
  return sums.sum <= options_.ends.zero_sum && sums.error <= options_.ends.sample_error;
}

// A large finite root with the same face is recognized by the errors of the samples. Where these
// leave a doubt, or are large, the samples get all their digits first, so that no error of theirs
// passes for one of the file. What the digits of the coefficients explain is at infinity as
// rounded.
FaceRoot Endgame::confirmed(FaceRoot place, PathSystem& path) {
  const auto measured = [&] { return sums_and_errors(samples_of_x0(), turns_, 0, options_.ends); };
  if (place == FaceRoot::exact) {
    // u times the operations of as many residuals.
    const double rounding = options_.ends.samples * options_.ends.rounding;
    const SumsAndErrors first = measured();
    if (first.sum <= options_.ends.zero_sum && first.error * std::max(first.sum, 1.0) <= rounding) {
      return FaceRoot::exact;
    }
  }
  // With more digits than double the samples of a path have all of theirs.
  if (!options_.goes_straight && !polish_samples(path)) return FaceRoot::none;
  if (place == FaceRoot::exact) {
    const SumsAndErrors fine = measured();
    if (fine.sum <= options_.ends.zero_sum && fine.error <= options_.ends.sample_error) {
      return FaceRoot::exact;
    }
  }
  return errors_explain(path) ? FaceRoot::as_rounded : FaceRoot::none;
}

bool Endgame::sheets_meet(const Point& x) const {
  return meet_together(combinations(samples_, path_), combinations({x}, path_).front(), turns_,
                       options_.ends);
}

// Simple roots that lie beside each other meet as far as the samples tell, on a circle that is wide
// relative to their distance.
bool Endgame::sheets_meet_in_all_digits(PathSystem& path) {
  if (!polish_samples(path)) return true;
  const Complex common = combinations({laurent_coefficient(0)}, path_).front();
  std::vector<Complex> apart = combinations(samples_, path_);
  double size = 0;
  for (Complex& z : apart) {
    z -= common;
    size = std::max(size, modulus(z));
  }
  const double known = std::numeric_limits<double>::epsilon() * modulus(common) / size;
  // All samples may err one way.
  return sums_and_errors(apart, turns_, known, options_.ends).sum <= options_.ends.samples;
}

// Size of the highest coefficient that the samples resolve: what comes after it is aliased.
double Endgame::truncation() const {
  return max_norm(laurent_coefficient(static_cast<int>(samples_.size()) / 2 - 1));
}

std::optional<PathSegment> Endgame::estimate_end(PathSystem& path) {
  leave_poles();
  const std::vector<Complex> x0 = samples_of_x0();
  const bool is_beyond = ends_beyond(x0);
  if (is_beyond || vanish_together(x0, turns_, options_.ends)) {
    const FaceRoot place = place_at_infinity(path);
    if (place != FaceRoot::none) {
      const FaceRoot infinity = confirmed(place, path);
      if (infinity == FaceRoot::none) return shrink(path);
      end_.status = PathStatus::at_infinity;
      end_.is_as_rounded = infinity == FaceRoot::as_rounded;
      return std::nullopt;
    }
  }
  if (is_beyond) return shrink(path);
  Estimate estimate{laurent_coefficient(0), turns_};
  if (!sheets_meet(estimate.x)) {
    last_.reset();
    return shrink(path);
  }
  // So near to infinity smaller circles tell more than agreement does.
  if (chart_.finiteness(outside(frame_, estimate.x)) < 1 / options_.ends.beyond)
    return shrink(path);
  if (last_ && last_->winding == estimate.winding) {
    const double change = difference(estimate.x, normalized(last_->x));
    if (!best_ || change < best_difference_) {
      best_ = estimate;
      best_difference_ = change;
    }
    if (change > best_difference_ || change < options_.ends.sample_error) {
      if (estimate.winding == 1 || sheets_meet_in_all_digits(path)) return conclude(path);
      best_.reset();
      last_.reset();
      return shrink(path);
    }
  } else if (!best_) {
    best_ = estimate;
    best_difference_ = truncation();
  }
  last_ = std::move(estimate);
  return shrink(path);
}

std::optional<PathSegment> Endgame::shrink(PathSystem& path) {
  const double smaller = radius_ / options_.ends.shrink;
  if (smaller < options_.ends.least_radius || are_steps_spent()) return conclude(path);
  phase_ = Phase::approach;
  return approach(smaller);
}

// With an estimate at hand a landing has to prove it wrong; without one, any landing is welcome,
// and the root it leads to is proved on the system as given.
double Endgame::landing_condition() const {
  return best_ ? options_.ends.singular_condition : std::numeric_limits<double>::infinity();
}

std::optional<PathSegment> Endgame::land() {
  phase_ = Phase::landing;
  return along(Contour::landing(radius_), endgame_start_);
}

std::optional<PathSegment> Endgame::conclude(PathSystem& path) {
  if (!best_ || best_difference_ > options_.ends.agreement) {
    if (phase_ == Phase::landing) return fail(Failure::precision);
    return land();
  }
  const double condition =
      path.linearize(best_->x, kEnd) ? path.condition() : std::numeric_limits<double>::infinity();
  const bool is_singular = condition >= options_.ends.singular_condition;
  // Where several sheets meet J is singular. A circle that closes after several turns about a mean
  // that is less singular may have run round branch points beside t = 1: landing tells.
  if (best_->winding > 1 && !is_singular && phase_ != Phase::landing) return land();
  end_.x = best_->x;
  end_.winding = best_->winding;
  end_.accuracy = std::max(best_difference_, std::numeric_limits<double>::epsilon());
  end_.t = 1;
  end_.condition = condition;
  end_.singular = best_->winding > 1 || is_singular;
  return take_finite();
}

// x_0 relative to its error. That it is 0, no number of digits tells: a root of size 1e31 ends as
// an end at infinity does.
bool Endgame::is_known_finite() const {
  return chart_.finiteness(end_.x) > options_.ends.known_size * end_.accuracy;
}

std::nullopt_t Endgame::take_finite() {
  if (!is_known_finite()) return fail(Failure::precision);
  end_.status = PathStatus::finite;
  return std::nullopt;
}

bool Endgame::is_regular_end(const SegmentResult& reached, PathSystem& path, double condition) {
  if (reached.status != SegmentStatus::arrived) return false;
  CorrectorOptions newton;
  newton.tolerance = options_.ends.rounding;
  Point x = reached.x;
  const Correction correction = path.correct(x, kEnd, newton, true);
  end_.condition = path.condition();
  if (end_.condition > condition ||
      !(correction.converged || correction.last < options_.ends.sample_error)) {
    return false;
  }
  // x_0 that is made of rounding errors may be 0: not here is it to be told.
  const double moved = std::abs(chart_.x0(path.last_correction()));
  const bool is_known = moved < std::abs(chart_.x0(x));
  if (!is_known || chart_.finiteness(x) <= options_.ends.rounding) return false;
  end_.x = std::move(x);
  end_.accuracy = correction.last;
  end_.status = PathStatus::finite;
  return true;
}

}  // namespace moivre
