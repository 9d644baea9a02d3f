// SPDX-License-Identifier: MIT
// Journeys with CVODE: right-hand side, projection, weights, and the loop over steps.
#include "moivre/tracker_cvode/cvode_tracker.h"

#include <algorithm>
#include <cmath>

#include "cvode_memory.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

// CVODE's convergence test of its iteration, relative to the error test; loose, because Newton's
// projection removes what the iteration leaves.
constexpr double kNonlinearCoefficient = 0.5;
// A step is cut to this fraction when Newton refuses it.
constexpr double kProjectionFailureEta = 0.25;
// Repeated failures inside one step before the journey ends: 4^-20 of a step is far below any
// useful one.
constexpr int kMaximumFailuresInStep = 20;
// Samples go into Cauchy's integral, so they are corrected as far as double allows.
constexpr double kSampleTolerance = 1e-14;
// Each level of care divides the tolerance and the trust in Newton by so much.
constexpr double kCareFactor = 10;

class CvodeSession : public TrackerSession {
 public:
  CvodeSession(const CvodeOptions& options, const Homotopy& homotopy)
      : options_(options),
        path_(homotopy),
        memory_(options.method == CvodeMethod::adams ? CV_ADAMS : CV_BDF, options.iteration,
                path_.coordinates()),
        trial_(path_.coordinates()) {
    set_up();
  }

  void run(DepartureSource& source, const std::atomic<bool>& stop) override {
    while (std::optional<Departure> departure = source.next()) {
      Arrival arrival = travel(*departure, stop);
      source.arrived(*departure, std::move(arrival));
    }
  }

 private:
  bool projects() const { return options_.method == CvodeMethod::bdf_projection; }

  void set_up();
  Arrival travel(const Departure& departure, const std::atomic<bool>& stop);
  bool depart(const Departure& departure);
  Journey step_on(const Departure& departure, const std::atomic<bool>& stop, Arrival& arrival);
  bool take_samples(const Departure& departure, double previous, double s, Arrival& arrival);
  void count_into(StepCount& count) const;

  static int right_hand_side(sunrealtype s, N_Vector y, N_Vector dy, void* self);
  static int project(sunrealtype s, N_Vector y, N_Vector correction, sunrealtype epsilon,
                     N_Vector error, void* self);
  static int weights(N_Vector y, N_Vector weight, void* self);

  CvodeOptions options_;
  PathSystem path_;
  CvodeMemory memory_;
  Point trial_;
  Contour contour_ = Contour::segment(0, 1);
  CorrectorOptions newton_;
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

int CvodeSession::right_hand_side(sunrealtype s, N_Vector y, N_Vector dy, void* self) {
  auto& session = *static_cast<CvodeSession*>(self);
  if (!session.path_.linearize(coordinates(y), session.contour_.at(s))) return 1;
  session.linearized_at_ = s;
  session.path_.tangent(session.contour_.dt(s), coordinates(dy));
  return 0;
}

int CvodeSession::project(sunrealtype s, N_Vector y, N_Vector correction, sunrealtype, N_Vector,
                          void* self) {
  auto& session = *static_cast<CvodeSession*>(self);
  const auto from = coordinates(y);
  const auto to = coordinates(correction);
  std::copy(from.begin(), from.end(), session.trial_.begin());
  const bool fresh = session.linearized_at_ != s;
  session.last_correction_ =
      session.path_.correct(session.trial_, session.contour_.at(s), session.newton_, fresh);
  session.linearized_at_ = -1;
  if (!session.last_correction_.converged) return 1;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = session.trial_[i] - from[i];
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

bool CvodeSession::depart(const Departure& departure) {
  const double care = std::pow(kCareFactor, -departure.care);
  contour_ = departure.contour;
  path_.set_frame(departure.frame.get());
  rtol_ = options_.rtol * care;
  newton_ = CorrectorOptions{};
  newton_.largest_correction *= care;
  const auto x = coordinates(memory_.state());
  const double norm = euclidean_norm(departure.x);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = departure.x[i] / norm;
  if (!path_.correct(x, contour_.at(0), CorrectorOptions{}, true).converged) return false;
  linearized_at_ = -1;
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

bool CvodeSession::take_samples(const Departure& departure, double previous, double s,
                                Arrival& arrival) {
  const auto samples = static_cast<double>(departure.samples);
  const auto x = coordinates(memory_.state());
  for (double k = std::floor(previous * samples) + 1; k <= s * samples; ++k) {
    Point sample(x.begin(), x.end());
    const double at = k / samples;
    if (at < s) {
      // The state vector lends its memory to the interpolant and gets its value back.
      if (CVodeGetDky(memory_.cvode(), at, 0, memory_.state()) != CV_SUCCESS) return false;
      std::swap_ranges(sample.begin(), sample.end(), x.begin());
    }
    CorrectorOptions polish = newton_;
    polish.tolerance = kSampleTolerance;
    linearized_at_ = -1;
    if (!path_.correct(sample, contour_.at(at), polish, true).converged) return false;
    arrival.samples.push_back(std::move(sample));
  }
  return true;
}

Journey CvodeSession::step_on(const Departure& departure, const std::atomic<bool>& stop,
                              Arrival& arrival) {
  const auto x = coordinates(memory_.state());
  for (std::int64_t steps = 0; arrival.s < 1; ++steps) {
    if (stop.load(std::memory_order_relaxed)) return Journey::cancelled;
    if (steps >= options_.maximum_steps) return Journey::step_limit;
    const double previous = arrival.s;
    last_correction_ = {};
    const int flag = CVode(memory_.cvode(), 1, memory_.state(), &arrival.s, CV_ONE_STEP);
    if (flag == CV_TOO_MUCH_WORK) return Journey::step_limit;
    if (flag < 0 || !(arrival.s > previous)) {
      arrival.s = previous;
      return Journey::step_too_small;
    }
    std::copy(x.begin(), x.end(), arrival.x.begin());
    if (departure.samples > 0 && !take_samples(departure, previous, arrival.s, arrival)) {
      return Journey::off_path;
    }
    if (departure.watcher != nullptr &&
        std::abs(contour_.at(arrival.s).rest) <= departure.watch_radius) {
      StepRecord record;
      record.s = arrival.s;
      record.t = contour_.at(arrival.s);
      record.x = arrival.x;
      record.step = arrival.s - previous;
      CVodeGetLastOrder(memory_.cvode(), &record.order);
      record.drift = last_correction_.residual;
      record.correction = last_correction_.first;
      linearized_at_ = -1;
      if (departure.watcher->watch(record, path_) == Watcher::Verdict::stop && arrival.s < 1) {
        return Journey::stopped;
      }
    }
  }
  if (!projects()) {
    linearized_at_ = -1;
    if (!path_.correct(arrival.x, contour_.at(1), CorrectorOptions{}, true).converged) {
      return Journey::off_path;
    }
  }
  return Journey::arrived;
}

Arrival CvodeSession::travel(const Departure& departure, const std::atomic<bool>& stop) {
  const WorkCount before = path_.work();
  Arrival arrival;
  arrival.x = departure.x;
  if (!depart(departure)) {
    arrival.journey = Journey::bad_start;
  } else {
    const auto x = coordinates(memory_.state());
    std::copy(x.begin(), x.end(), arrival.x.begin());
    arrival.journey = step_on(departure, stop, arrival);
    count_into(arrival.count);
  }
  arrival.t = contour_.at(arrival.s);
  arrival.count.work = path_.work() - before;
  return arrival;
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
