// SPDX-License-Identifier: MIT
// A single path, watched: a recorder stands between the tracker and the endgame.
#include "moivre/solver/trace.h"

#include <functional>
#include <limits>
#include <stdexcept>

#include "facts.h"
#include "prepare.h"

namespace moivre {
namespace {

/// From homogeneous to the system's own coordinates.
using ToAffine = std::function<Point(const Point&)>;

/// Writes down each step and passes it on to the endgame.
class Recorder : public Watcher {
 public:
  Recorder(const ToAffine& to_affine, std::vector<TraceStep>& steps)
      : to_affine_(to_affine), steps_(steps) {}

  void begin_journey(Watcher* inner) {
    inner_ = inner;
    ++journey_;
  }

  Verdict watch(const StepRecord& record, PathSystem& path) noexcept override {
    TraceStep& step = steps_.emplace_back();
    step.journey = journey_;
    step.s = record.s;
    step.t = record.t.t;
    step.x = to_affine_(Point(record.x.begin(), record.x.end()));
    path.linearize(record.x, record.t);
    step.h_after = path.residual();
    step.h_before = record.correction > 0 ? record.drift : step.h_after;
    step.correction = record.correction;
    step.step = record.step;
    step.order = record.order;
    return inner_ == nullptr ? Verdict::go_on : inner_->watch(record, path);
  }

 private:
  const ToAffine& to_affine_;
  std::vector<TraceStep>& steps_;
  Watcher* inner_ = nullptr;
  int journey_ = -1;
};

/// The start point itself, before any step.
TraceStep first_row(PathSystem& path, const Point& start, const ToAffine& to_affine) {
  Point unit = start;
  const double length = euclidean_norm(unit);
  for (Complex& xi : unit) xi /= length;
  path.linearize(unit, Complex(0));
  TraceStep step;
  step.x = to_affine(start);
  step.h_before = step.h_after = path.residual();
  return step;
}

void follow_to_the_end(const Homotopy& homotopy, const Tracker& tracker, const Point& start,
                       const SolveOptions& options, const ToAffine& to_affine,
                       const std::atomic<bool>& stop, Trace& trace) {
  const auto session = tracker.open(homotopy);
  PathSystem scratch(homotopy);
  trace.steps.push_back(first_row(scratch, start, to_affine));
  Recorder recorder(to_affine, trace.steps);
  Endgame endgame(options.endgame, trace.path, options.care);
  std::optional<Departure> departure = endgame.depart(start);
  while (departure) {
    recorder.begin_journey(departure->watcher);
    departure->watcher = &recorder;
    departure->watch_radius = std::numeric_limits<double>::infinity();
    departure = endgame.accept(follow(*session, std::move(*departure), stop), scratch);
  }
  trace.end = std::move(endgame.end());
  if (trace.end.status != PathStatus::at_infinity) trace.x = to_affine(trace.end.x);
  trace.tracker = tracker.kind();
  trace.tracker_options = tracker.options_in_force();
}

}  // namespace

Trace trace_path(const System& f, const Tracker& tracker, const SolveOptions& options,
                 std::uint64_t path, const std::atomic<bool>& stop) {
  require_square(f);
  const Prepared prepared = prepare(f, options);
  require_paths(prepared);
  if (path >= prepared.start.paths) {
    throw std::invalid_argument("there is no path " + std::to_string(path) +
                                ": the start system has " + std::to_string(prepared.start.paths) +
                                ", numbered from 0 to " + std::to_string(prepared.start.paths - 1));
  }
  Trace trace;
  trace.system = facts_of(f);
  trace.paths = prepared.start.paths;
  trace.path = path;
  trace.left_out = prepared.left_out;
  follow_to_the_end(
      *prepared.homotopy, tracker, start_point(prepared.start, path), options,
      [&](const Point& x) { return to_original(prepared, x); }, stop, trace);
  return trace;
}

Trace trace_path(const System& f, const System& g, const Point& start, const Tracker& tracker,
                 const SolveOptions& options, const std::atomic<bool>& stop) {
  require_square(f);
  if (g.variables != f.variables || start.size() != f.variables.size()) {
    throw std::invalid_argument(
        "the start system and its point must be in the variables of the system");
  }
  require_square(g);
  const Homotopy homotopy(f, g);
  Trace trace;
  trace.system = facts_of(f);
  Point homogeneous = start;
  homogeneous.push_back(1);
  follow_to_the_end(
      homotopy, tracker, homogeneous, options,
      [](const Point& x) {
        Point affine(x.begin(), x.end() - 1);
        for (Complex& xi : affine) xi /= x.back();
        return affine;
      },
      stop, trace);
  return trace;
}

}  // namespace moivre
