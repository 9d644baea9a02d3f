// SPDX-License-Identifier: MIT
// Blocks of paths through the early stages of a plan.
#include "stage_starts.h"

namespace moivre {
namespace {

/// Hands out a block's paths on one stage and takes them back at its end.
class StageSource : public SegmentSource {
 public:
  StageSource(const StartPlan& plan, std::vector<StageStart>& block, std::size_t stage,
              int tolerance_level)
      : plan_(plan), block_(block), stage_(stage), tolerance_level_(tolerance_level) {}

  std::optional<PathSegment> next() override {
    while (next_ < block_.size() && block_[next_].lost) ++next_;
    if (next_ == block_.size()) return std::nullopt;
    PathSegment segment = segment_of(block_[next_], tolerance_level_);
    segment.path = next_++;
    return segment;
  }

  void arrived(const PathSegment& segment, SegmentResult&& reached) override {
    take_result(plan_, stage_, std::move(reached), block_[segment.path]);
  }

 private:
  const StartPlan& plan_;
  std::vector<StageStart>& block_;
  std::size_t stage_;
  int tolerance_level_;
  std::size_t next_ = 0;
};

}  // namespace

StageStart first_stage_start(const StartPlan& plan, std::uint64_t path) {
  StartPoint start = plan.points->at(path);
  return {path, std::move(start.x), std::move(start.frame), std::nullopt, {}};
}

PathSegment segment_of(const StageStart& beginning, int tolerance_level, Watcher* watcher) {
  PathSegment segment;
  segment.path = beginning.path;
  segment.x = beginning.x;
  segment.tolerance_level = tolerance_level;
  segment.watcher = watcher;
  segment.frame = beginning.frame;
  return segment;
}

void take_result(const StartPlan& plan, std::size_t stage, SegmentResult&& reached,
                 StageStart& beginning) {
  beginning.count += reached.count;
  beginning.x = outside(beginning.frame, std::move(reached.x));
  beginning.frame.reset();
  if (reached.status == SegmentStatus::arrived) {
    const Homotopy& next = plan.stages[stage + 1];
    if (!next.is_framed()) return;
    beginning.frame = std::make_shared<PathFrame>(frame_at(next, beginning.x));
    beginning.x = inside(beginning.frame, std::move(beginning.x));
    return;
  }
  PathEnd& end = beginning.lost.emplace();
  end.failure = to_failure(reached.status);
  end.x = beginning.x;
  end.t = reached.t.t;
  end.stage = stage;
  end.count = beginning.count;
}

StageStarts::StageStarts(const StartPlan& plan, const Tracker& tracker, int tolerance_level,
                         std::size_t block, Draw draw)
    : plan_(plan), tolerance_level_(tolerance_level), block_size_(block), draw_(std::move(draw)) {
  for (std::size_t stage = 0; stage + 1 < plan.stages.size(); ++stage) {
    early_.push_back(tracker.open(plan.stages[stage]));
  }
}

bool StageStarts::advance(const std::atomic<bool>& stop) {
  if (early_.empty()) return true;
  block_.clear();
  next_ = 0;
  while (block_.size() < block_size_ && !stop.load(std::memory_order_relaxed)) {
    const std::optional<std::uint64_t> path = draw_();
    if (!path) break;
    block_.push_back(first_stage_start(plan_, *path));
  }
  for (std::size_t stage = 0; stage < early_.size(); ++stage) {
    StageSource source(plan_, block_, stage, tolerance_level_);
    run_session(*early_[stage], source, stop);
  }
  return !block_.empty();
}

std::optional<StageStart> StageStarts::next() {
  if (early_.empty()) {
    const std::optional<std::uint64_t> path = draw_();
    if (!path) return std::nullopt;
    return first_stage_start(plan_, *path);
  }
  if (next_ == block_.size()) return std::nullopt;
  return std::move(block_[next_++]);
}

}  // namespace moivre
