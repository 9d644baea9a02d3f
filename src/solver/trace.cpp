// SPDX-License-Identifier: MIT
// A single path, watched: a recorder stands between the tracker and the endgame.
#include "moivre/solver/trace.h"

#include <functional>
#include <limits>

#include "facts.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/powers.h"
#include "setting.h"
#include "stage_starts.h"

namespace moivre {
namespace {

/// From homogeneous to the system's own coordinates.
using ToAffine = std::function<Point(const Point&)>;

/// Writes down each step and passes it on to the endgame.
class Recorder : public Watcher {
 public:
  Recorder(const ToAffine& to_affine, std::vector<TraceStep>& steps)
      : to_affine_(to_affine), steps_(steps) {}

  int next_segment() const { return segment_ + 1; }

  void begin_segment(Watcher* inner, FramePointer frame) {
    inner_ = inner;
    frame_ = std::move(frame);
    ++segment_;
  }

  Verdict watch(const StepRecord& record, PathSystem& path) override {
    TraceStep& step = steps_.emplace_back();
    step.segment = segment_;
    step.s = record.s;
    step.t = record.t.t;
    step.x = to_affine_(outside(frame_, Point(record.x.begin(), record.x.end())));
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
  FramePointer frame_;
  int segment_ = -1;
};

/// The start point of a stage, before any step.
TraceStep first_row(const Homotopy& homotopy, const StageStart& beginning,
                    const ToAffine& to_affine) {
  PathSystem path(homotopy);
  path.set_frame(beginning.frame.get());
  Point unit = beginning.x;
  const double length = euclidean_norm(unit);
  for (Complex& xi : unit) xi /= length;
  path.linearize(unit, Complex(0));
  TraceStep step;
  step.x = to_affine(outside(beginning.frame, beginning.x));
  step.h_before = step.h_after = path.residual();
  return step;
}

/// Through the stages before the last: where the path begins there, or how it was lost.
StageStart follow_early_stages(const PathProblem& problem, std::uint64_t path, int tolerance_level,
                               Recorder& recorder, const ToAffine& to_affine,
                               const std::atomic<bool>& stop, Trace& trace) {
  StageStart beginning = first_stage_start(problem.plan, path);
  for (std::size_t stage = 0; stage + 1 < problem.plan.stages.size() && !beginning.lost; ++stage) {
    const Homotopy& homotopy = problem.plan.stages[stage];
    trace.steps.push_back(first_row(homotopy, beginning, to_affine));
    recorder.begin_segment(nullptr, beginning.frame);
    const auto session = problem.tracker.open(homotopy);
    SegmentResult reached =
        follow(*session, segment_of(beginning, tolerance_level, &recorder), stop);
    take_result(problem.plan, stage, std::move(reached), beginning);
  }
  return beginning;
}

void follow_to_the_end(const PathProblem& problem, int tolerance_level, const ToAffine& to_affine,
                       const std::atomic<bool>& stop, Trace& trace) {
  const Homotopy& last = problem.plan.last();
  Recorder recorder(to_affine, trace.steps);
  StageStart beginning =
      follow_early_stages(problem, trace.path, tolerance_level, recorder, to_affine, stop, trace);
  if (beginning.lost) {
    trace.end = std::move(*beginning.lost);
  } else {
    const auto session = problem.tracker.open(last);
    PathSystem scratch(last);
    const TraceStep start = first_row(last, beginning, to_affine);
    trace.steps.push_back(start);
    trace.steps.back().segment = recorder.next_segment();
    Endgame endgame(problem.endgame, last.chart(), trace.path, tolerance_level);
    std::optional<PathSegment> segment =
        endgame.depart(std::move(beginning.x), std::move(beginning.frame));
    while (segment) {
      recorder.begin_segment(segment->watcher, segment->frame);
      segment->watcher = &recorder;
      segment->watch_radius = std::numeric_limits<double>::infinity();
      segment = endgame.accept(follow(*session, std::move(*segment), stop), scratch);
    }
    trace.end = std::move(endgame.end());
  }
  if (trace.end.status != PathStatus::at_infinity) trace.x = to_affine(trace.end.x);
  trace.tracker = problem.tracker.kind();
  trace.tracker_options = problem.tracker.options_in_force();
}

}  // namespace

Trace trace_path(const System& f, const Tracker& tracker, const SolveOptions& options,
                 std::uint64_t path, const std::atomic<bool>& stop) {
  require_square(f);
  const PowerFree bases = power_free(f);
  const Setting setting(bases.system, tracker, options, stop);
  require_paths(setting.prepared);
  const StartPlan& plan = *setting.prepared.plan;
  const std::uint64_t paths = bases.sheets * plan.paths;
  if (path >= paths) {
    throw InvalidInput("there is no path " + std::to_string(path) + ": the start system has " +
                       std::to_string(paths) + ", numbered from 0 to " + std::to_string(paths - 1));
  }
  Trace trace;
  trace.system = facts_of(f);
  trace.paths = paths;
  trace.path = path / bases.sheets;
  trace.left_out = setting.prepared.left_out;
  follow_to_the_end(
      setting.problem(0), options.tolerance_level,
      [&](const Point& x) { return to_original(setting.prepared, x); }, stop, trace);
  trace.path = path;
  return trace;
}

Trace trace_path(const System& f, const System& g, const Point& start, const Tracker& tracker,
                 const SolveOptions& options, const std::atomic<bool>& stop) {
  require_square(f);
  if (g.variables != f.variables || start.size() != f.variables.size()) {
    throw InvalidInput("the start system and its point must be in the variables of the system");
  }
  require_square(g);
  Point homogeneous = start;
  homogeneous.push_back(1);
  const StartPlan plan = own_plan(f, g, std::move(homogeneous));
  Trace trace;
  trace.system = facts_of(f);
  follow_to_the_end(
      {plan, tracker, options.endgame}, options.tolerance_level,
      [&](const Point& x) { return plan.last().chart().affine(x); }, stop, trace);
  return trace;
}

}  // namespace moivre
