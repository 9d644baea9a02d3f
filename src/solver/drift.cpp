// SPDX-License-Identifier: MIT
// Many paths in one session, each with a watcher that keeps the largest |H| and the last point.
#include "moivre/solver/drift.h"

#include <algorithm>

#include "facts.h"
#include "moivre/numeric/invalid_input.h"
#include "prepare.h"
#include "stage_starts.h"

namespace moivre {
namespace {

/// Watches one path.
class DriftWatcher : public Watcher {
 public:
  explicit DriftWatcher(PathDrift& drift) : drift_(&drift) {}

  Verdict watch(const StepRecord& step, PathSystem& path) override {
    path.linearize(step.x, step.t);
    const double after = path.residual();
    drift_->after = std::max(drift_->after, after);
    drift_->before = std::max(drift_->before, step.correction > 0 ? step.drift : after);
    drift_->correction = std::max(drift_->correction, step.correction);
    if (step.s == 1) end_.assign(step.x.begin(), step.x.end());
    return Verdict::go_on;
  }

  const Point& end() const { return end_; }

 private:
  PathDrift* drift_;
  Point end_;  // homogeneous, at t = 1; empty before
};

class DriftSource : public SegmentSource {
 public:
  DriftSource(const Prepared& prepared, int tolerance_level, std::vector<PathDrift>& drifts,
              StageStarts& beginnings)
      : prepared_(prepared),
        tolerance_level_(tolerance_level),
        drifts_(drifts),
        beginnings_(beginnings) {
    watchers_.reserve(drifts.size());
    for (PathDrift& drift : drifts) watchers_.emplace_back(drift);
  }

  std::optional<PathSegment> next() override {
    std::optional<StageStart> beginning = beginnings_.next();
    while (beginning && beginning->lost) beginning = beginnings_.next();
    if (!beginning) return std::nullopt;
    while (drifts_[next_].path != beginning->path) ++next_;
    PathSegment segment = segment_of(*beginning, tolerance_level_);
    segment.path = next_;
    segment.watcher = &watchers_[next_++];
    return segment;
  }

  void arrived(const PathSegment& segment, SegmentResult&& reached) override {
    PathDrift& drift = drifts_[segment.path];
    const Point& end = watchers_[segment.path].end();
    drift.count = reached.count;
    drift.arrived = !end.empty() && prepared_.plan->last().chart().x0(end) != 0.0;
    if (drift.arrived) drift.end = to_original(prepared_, outside(segment.frame, end));
  }

 private:
  const Prepared& prepared_;
  int tolerance_level_;
  std::vector<PathDrift>& drifts_;
  StageStarts& beginnings_;
  std::vector<DriftWatcher> watchers_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<PathDrift> measure_drift(const System& f, const Tracker& tracker,
                                     const SolveOptions& options,
                                     const std::vector<std::uint64_t>& paths,
                                     const std::atomic<bool>& stop) {
  require_square(f);
  const Prepared prepared = prepare(f, options, stop);
  std::vector<PathDrift> drifts(paths.size());
  if (prepared.interrupted) {
    for (std::size_t k = 0; k < paths.size(); ++k) drifts[k].path = paths[k];
    return drifts;
  }
  require_paths(prepared);
  for (std::size_t k = 0; k < paths.size(); ++k) {
    if (paths[k] >= prepared.plan->paths) {
      throw InvalidInput("there is no path " + std::to_string(paths[k]));
    }
    drifts[k].path = paths[k];
  }
  std::size_t drawn = 0;
  const auto draw = [&]() -> std::optional<std::uint64_t> {
    if (drawn == paths.size() || stop.load(std::memory_order_relaxed)) return std::nullopt;
    return paths[drawn++];
  };
  StageStarts beginnings(*prepared.plan, tracker, options.tolerance_level, paths.size(), draw);
  DriftSource source(prepared, options.tolerance_level, drifts, beginnings);
  beginnings.advance(stop);
  run_session(*tracker.open(prepared.plan->last()), source, stop);
  return drifts;
}

}  // namespace moivre
