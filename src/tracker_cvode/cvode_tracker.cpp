// SPDX-License-Identifier: MIT
// Segments with CVODE: right-hand side, projection, weights, and the loop over steps.
//
// x' = -J^{-1} H_t dt is the path's tangent on the path; beside it, where J is nearly singular, it
// is a stiff field, and the order stays 1. From a step on that Newton's method refuses the field is
// therefore that of the foot, the point of the path to which Newton's method comes, and the
// tolerance is tighter, so that the error test bounds the next steps; both until a few steps are
// accepted (decision 94).
#include "moivre/tracker_cvode/cvode_tracker.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cvode_memory.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/tracker/hermite_predictor.h"
#include "moivre/tracker/option_table.h"
#include "moivre/tracker/session.h"

namespace moivre {
namespace {

// CVODE's convergence test of its iteration, relative to the error test; loose, because Newton's
// projection removes what the iteration leaves.
constexpr double kNonlinearCoefficient = 0.5;
// A step is cut to this fraction when Newton refuses it.
constexpr double kProjectionFailureEta = 0.25;
// Repeated failures inside one step before the segment ends: 4^-20 of a step is far below any
// useful one.
constexpr int kMaximumFailuresInStep = 20;
// Samples go into Cauchy's integral, so they are corrected as far as double allows.
constexpr double kSampleTolerance = 1e-14;
// Each tolerance level divides the tolerance and the trust in Newton by so much; a step that Newton
// refuses the tolerance alone, until so many steps are accepted behind it.
constexpr double kToleranceFactor = 10;
constexpr int kCarefulSteps = 5;
constexpr double kTightest = 1e-8;

class CvodeSession : public TrackerSession {
 public:
  CvodeSession(const CvodeOptions& options, const Homotopy& homotopy)
      : options_(options),
        path_(homotopy),
        memory_(options.method == CvodeMethod::adams ? CV_ADAMS : CV_BDF, options.iteration,
                path_.coordinates()),
        trial_(path_.coordinates()),
        foot_{-1, Point(path_.coordinates()), Point(path_.coordinates())},
        last_{0, Point(path_.coordinates()), Point(path_.coordinates())},
        here_{last_} {
    set_up();
  }

  void run(SegmentSource& source, const std::atomic<bool>& stop) override {
    while (std::optional<PathSegment> segment = source.next()) {
      SegmentResult reached = travel(*segment, stop);
      source.arrived(*segment, std::move(reached));
    }
  }

 private:
  /// A point of the path, and its tangent there.
  struct Foot {
    double s;
    Point x, tangent;
  };

  /// A point of the path that a step has reached, and its tangent there where that is known.
  struct Node {
    double s = 0;
    Point x, tangent;
    bool has_tangent = false;
  };

  bool projects() const { return options_.method == CvodeMethod::bdf_projection; }
  bool is_careful() const { return rtol_ < loosest_rtol_; }
  void forget();
  void take_care();
  void ease();
  std::optional<Complex> find_foot(double s, std::span<const Complex> y);
  bool correct_trial(double s, std::span<const Complex> y);

  void set_up();
  SegmentResult travel(const PathSegment& segment, const std::atomic<bool>& stop);
  bool depart(const PathSegment& segment);
  SegmentStatus step_on(const PathSegment& segment, const std::atomic<bool>& stop,
                        SegmentResult& reached);
  bool take_samples(const PathSegment& segment, double s, SegmentResult& reached);
  bool find_tangent(Node& node);
  void count_into(StepCount& count) const;

  static int right_hand_side(sunrealtype s, N_Vector state, N_Vector derivative, void* self);
  static int project(sunrealtype s, N_Vector state, N_Vector correction, sunrealtype epsilon,
                     N_Vector error, void* self);
  static int weights(N_Vector y, N_Vector weight, void* self);

  CvodeOptions options_;
  PathSystem path_;
  CvodeMemory memory_;
  Point trial_;
  Foot foot_;         ///< s < 0: none is known
  Node last_, here_;  ///< on circles: both ends of the last step
  HermitePredictor<Complex> between_;
  Contour contour_ = Contour::segment(0, 1);
  CorrectorOptions newton_;
  double loosest_rtol_ = 0;
  double rtol_ = 0;
  double linearized_at_ =
      -1;  // s of the last right-hand side, whose factors the projection may use
  Correction last_correction_;
};

void CvodeSession::set_up() {
  void* cvode = memory_.cvode();
  N_VConst(1, memory_.state());
  require_sundials(CVodeInit(cvode, right_hand_side, 0, memory_.state()), "CVodeInit");
  memory_.silence();
  require_sundials(CVodeSetUserData(cvode, this), "CVodeSetUserData");
  require_sundials(CVodeWFtolerances(cvode, weights), "CVodeWFtolerances");
  memory_.attach_solvers();
  require_sundials(CVodeSetNonlinConvCoef(cvode, kNonlinearCoefficient), "CVodeSetNonlinConvCoef");
  require_sundials(CVodeSetMaxNumSteps(cvode, static_cast<long>(options_.maximum_steps)),
                   "CVodeSetMaxNumSteps");
  require_sundials(CVodeSetMaxHnilWarns(cvode, -1), "CVodeSetMaxHnilWarns");
  require_sundials(CVodeSetMaxConvFails(cvode, kMaximumFailuresInStep), "CVodeSetMaxConvFails");
  require_sundials(CVodeSetMaxErrTestFails(cvode, kMaximumFailuresInStep),
                   "CVodeSetMaxErrTestFails");
  if (!projects()) return;
  require_sundials(CVodeSetProjFn(cvode, project), "CVodeSetProjFn");
  require_sundials(CVodeSetProjErrEst(cvode, SUNFALSE), "CVodeSetProjErrEst");
  require_sundials(CVodeSetProjFailEta(cvode, kProjectionFailureEta), "CVodeSetProjFailEta");
  require_sundials(CVodeSetMaxNumProjFails(cvode, kMaximumFailuresInStep),
                   "CVodeSetMaxNumProjFails");
}

/// Neither the factors nor the foot are those of the point that comes.
void CvodeSession::forget() {
  linearized_at_ = -1;
  foot_.s = -1;
}

void CvodeSession::take_care() {
  rtol_ = std::max(rtol_ / kToleranceFactor, std::min(loosest_rtol_, kTightest));
  forget();
}

void CvodeSession::ease() {
  static const double factor = std::pow(kToleranceFactor, 1.0 / kCarefulSteps);
  rtol_ = std::min(loosest_rtol_, rtol_ * factor);
}

/// The multiple of x that is nearest to y: both are homogeneous.
Complex nearest_multiple(std::span<const Complex> x, std::span<const Complex> y) {
  Complex over = 0;
  double under = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    over = add_product(std::conj(x[i]), y[i], over);
    under += std::norm(x[i]);
  }
  return over / under;
}

/// foot_ <- where Newton's method comes from y; gives its multiple that is nearest to y. CVODE asks
/// several times at one s: near the foot of there nothing is done.
std::optional<Complex> CvodeSession::find_foot(double s, std::span<const Complex> y) {
  if (foot_.s == s) {
    const Complex scale = nearest_multiple(foot_.x, y);
    for (std::size_t i = 0; i < y.size(); ++i) trial_[i] = y[i] - product(scale, foot_.x[i]);
    if (weighted_norm(trial_, foot_.x) <= newton_.largest_correction) return scale;
  }
  forget();
  std::copy(y.begin(), y.end(), foot_.x.begin());
  CorrectorOptions renewing = newton_;
  renewing.renews = true;
  last_correction_ = path_.correct(foot_.x, contour_.at(s), renewing, true);
  if (!last_correction_.converged) return std::nullopt;
  path_.tangent(contour_.dt(s), foot_.tangent);
  foot_.s = s;
  return nearest_multiple(foot_.x, y);
}

/// trial_ <- the point of the path near y.
bool CvodeSession::correct_trial(double s, std::span<const Complex> y) {
  if (is_careful()) {
    const auto scale = find_foot(s, y);
    for (std::size_t i = 0; scale && i < y.size(); ++i) trial_[i] = product(*scale, foot_.x[i]);
    return scale.has_value();
  }
  std::copy(y.begin(), y.end(), trial_.begin());
  last_correction_ = path_.correct(trial_, contour_.at(s), newton_, linearized_at_ != s);
  linearized_at_ = -1;
  return last_correction_.converged;
}

int CvodeSession::right_hand_side(sunrealtype s, N_Vector state, N_Vector derivative, void* self) {
  auto& session = *static_cast<CvodeSession*>(self);
  const auto y = coordinates(state);
  const auto dy = coordinates(derivative);
  if (!session.is_careful()) {
    if (!session.path_.linearize(y, session.contour_.at(s))) return 1;
    session.linearized_at_ = s;
    session.path_.tangent(session.contour_.dt(s), dy);
    return 0;
  }
  const auto scale = session.find_foot(s, y);
  if (!scale) {
    session.take_care();
    return 1;
  }
  for (std::size_t i = 0; i < dy.size(); ++i) dy[i] = product(*scale, session.foot_.tangent[i]);
  return 0;
}

int CvodeSession::project(sunrealtype s, N_Vector state, N_Vector correction, sunrealtype, N_Vector,
                          void* self) {
  auto& session = *static_cast<CvodeSession*>(self);
  const auto y = coordinates(state);
  const auto dy = coordinates(correction);
  if (!session.correct_trial(s, y)) {
    session.take_care();
    return 1;
  }
  for (std::size_t i = 0; i < dy.size(); ++i) dy[i] = session.trial_[i] - y[i];
  return 0;
}

int CvodeSession::weights(N_Vector y, N_Vector weight, void* self) {
  const double rtol = static_cast<CvodeSession*>(self)->rtol_;
  const auto x = coordinates(y);
  double* w = N_VGetArrayPointer(weight);
  double largest = 0;
  for (const Complex& xi : x) largest = std::max(largest, std::abs(xi));
  const double floor = kRelativeFloor * largest;
  for (std::size_t i = 0; i < x.size(); ++i) {
    w[2 * i] = w[2 * i + 1] = 1 / (rtol * std::max(std::abs(x[i]), floor));
  }
  return std::isfinite(largest) && largest > 0 ? 0 : -1;
}

bool CvodeSession::depart(const PathSegment& segment) {
  const double tightening = std::pow(kToleranceFactor, -segment.tolerance_level);
  contour_ = segment.contour;
  path_.set_frame(segment.frame.get());
  loosest_rtol_ = rtol_ = options_.rtol * tightening;
  newton_ = CorrectorOptions{};
  newton_.largest_correction *= tightening;
  const auto x = coordinates(memory_.state());
  const double norm = euclidean_norm(segment.x);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = segment.x[i] / norm;
  if (!path_.correct(x, contour_.at(0), CorrectorOptions{}, true).converged) return false;
  forget();
  last_.s = 0;
  std::copy(x.begin(), x.end(), last_.x.begin());
  last_.has_tangent = false;
  return CVodeReInit(memory_.cvode(), 0, memory_.state()) == CV_SUCCESS &&
         CVodeSetStopTime(memory_.cvode(), 1) == CV_SUCCESS;
}

void CvodeSession::count_into(StepCount& count) const {
  long steps = 0;
  long error_failures = 0;
  long nonlinear_failures = 0;
  long projection_failures = 0;
  CVodeGetNumSteps(memory_.cvode(), &steps);
  CVodeGetNumErrTestFails(memory_.cvode(), &error_failures);
  CVodeGetNumNonlinSolvConvFails(memory_.cvode(), &nonlinear_failures);
  if (projects()) CVodeGetNumProjFails(memory_.cvode(), &projection_failures);
  count.accepted = static_cast<std::uint64_t>(steps);
  count.rejected =
      static_cast<std::uint64_t>(error_failures + nonlinear_failures + projection_failures);
}

bool CvodeSession::find_tangent(Node& node) {
  if (node.has_tangent) return true;
  forget();
  if (!path_.linearize(node.x, contour_.at(node.s))) return false;
  path_.tangent(contour_.dt(node.s), node.tangent);
  node.has_tangent = true;
  return true;
}

/// Those of the step that has come to s: from the cubic polynomial of its ends and their tangents,
/// which is nearer to the path than CVODE's interpolant, of first order where steps are bounded by
/// Newton's method.
bool CvodeSession::take_samples(const PathSegment& segment, double s, SegmentResult& reached) {
  const auto samples = static_cast<double>(segment.samples);
  here_.s = s;
  here_.x = reached.x;
  here_.has_tangent = false;
  for (double k = std::floor(last_.s * samples) + 1; k <= s * samples; ++k) {
    const double at = k / samples;
    Point sample = here_.x;
    if (at < s) {
      if (!find_tangent(last_) || !find_tangent(here_)) return false;
      const HermiteNode<Complex> nodes[] = {{last_.s, 1, &last_.x, &last_.tangent},
                                            {here_.s, 1, &here_.x, &here_.tangent}};
      between_.predict(nodes, at, sample);
    }
    CorrectorOptions polish = newton_;
    polish.tolerance = kSampleTolerance;
    forget();
    if (!path_.correct(sample, contour_.at(at), polish, true).converged) return false;
    reached.samples.push_back(std::move(sample));
  }
  std::swap(last_, here_);
  return true;
}

SegmentStatus CvodeSession::step_on(const PathSegment& segment, const std::atomic<bool>& stop,
                                    SegmentResult& reached) {
  const auto x = coordinates(memory_.state());
  for (std::int64_t steps = 0; reached.s < 1; ++steps) {
    if (stop.load(std::memory_order_relaxed)) return SegmentStatus::cancelled;
    if (steps >= options_.maximum_steps) return SegmentStatus::step_limit;
    const double previous = reached.s;
    last_correction_ = {};
    const int flag = CVode(memory_.cvode(), 1, memory_.state(), &reached.s, CV_ONE_STEP);
    if (flag == CV_TOO_MUCH_WORK) return SegmentStatus::step_limit;
    if (flag < 0 || !(reached.s > previous)) {
      reached.s = previous;
      return SegmentStatus::step_too_small;
    }
    ease();
    std::copy(x.begin(), x.end(), reached.x.begin());
    if (segment.samples > 0 && !take_samples(segment, reached.s, reached)) {
      return SegmentStatus::off_path;
    }
    if (segment.watcher != nullptr &&
        std::abs(contour_.at(reached.s).rest) <= segment.watch_radius) {
      StepRecord record;
      record.s = reached.s;
      record.t = contour_.at(reached.s);
      record.x = reached.x;
      record.step = reached.s - previous;
      CVodeGetLastOrder(memory_.cvode(), &record.order);
      record.drift = last_correction_.residual;
      record.correction = last_correction_.first;
      forget();
      if (segment.watcher->watch(record, path_) == Watcher::Verdict::stop && reached.s < 1) {
        return SegmentStatus::stopped;
      }
    }
  }
  if (!projects()) {
    forget();
    if (!path_.correct(reached.x, contour_.at(1), CorrectorOptions{}, true).converged) {
      return SegmentStatus::off_path;
    }
  }
  return SegmentStatus::arrived;
}

SegmentResult CvodeSession::travel(const PathSegment& segment, const std::atomic<bool>& stop) {
  const WorkCount before = path_.work();
  SegmentResult reached;
  reached.x = segment.x;
  if (!depart(segment)) {
    reached.status = SegmentStatus::bad_start;
  } else {
    const auto x = coordinates(memory_.state());
    std::copy(x.begin(), x.end(), reached.x.begin());
    reached.status = step_on(segment, stop, reached);
    count_into(reached.count);
  }
  reached.t = contour_.at(reached.s);
  reached.count.work = path_.work() - before;
  return reached;
}

class CvodeTracker : public Tracker {
 public:
  explicit CvodeTracker(const CvodeOptions& options) : options_(options) {}

  std::string kind() const override { return "cvode"; }
  OptionsInForce options_in_force() const override { return in_force(cvode_table(), options_); }
  std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const override {
    return std::make_unique<CvodeSession>(options_, homotopy);
  }

 private:
  CvodeOptions options_;
};

}  // namespace

std::unique_ptr<Tracker> make_cvode_tracker(const CvodeOptions& options) {
  require_unbroken(validate(options));
  return std::make_unique<CvodeTracker>(options);
}

}  // namespace moivre
