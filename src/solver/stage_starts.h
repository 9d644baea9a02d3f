// SPDX-License-Identifier: MIT
// Where does each path set out on the plan's last stage? Its start point, or where the stages
// before have brought it.
//
// A plan of one stage: start points as they are asked for. Of several: a block of paths at a time
// is followed through the early stages, so that no more points are kept than a block's and the
// lanes stay full.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "moivre/endgame/endgame.h"
#include "moivre/start/start_plan.h"

namespace moivre {

/// A path at the beginning of a stage, or the verdict on one that did not come so far.
struct StageStart {
  std::uint64_t path = 0;
  Point x;  ///< in the frame
  FramePointer frame;
  std::optional<PathEnd> lost;
  StepCount count;  ///< of the stages before
};

/// The first stage's.
StageStart first_stage_start(const StartPlan& plan, std::uint64_t path);

/// Where the path departs on a stage, by whatever follows it there: `watcher` sees its steps on
/// early stages too.
PathSegment segment_of(const StageStart& beginning, int tolerance_level,
                       Watcher* watcher = nullptr);

/// Takes the result of an early stage of the plan into the beginning of the next one.
void take_result(const StartPlan& plan, std::size_t stage, SegmentResult&& reached,
                 StageStart& beginning);

/// Of one thread. `draw` gives the next path's number, or nullopt when there are no more.
class StageStarts {
 public:
  using Draw = std::function<std::optional<std::uint64_t>()>;

  StageStarts(const StartPlan& plan, const Tracker& tracker, int tolerance_level, std::size_t block,
              Draw draw);

  /// Follows the next block of paths to the last stage. False when there is none; nothing to do
  /// where the plan has one stage.
  bool advance(const std::atomic<bool>& stop);
  /// The next path: of the block, or of all where the plan has one stage.
  std::optional<StageStart> next();

 private:
  const StartPlan& plan_;
  int tolerance_level_;
  std::size_t block_size_;
  Draw draw_;
  std::vector<std::unique_ptr<TrackerSession>> early_;  // a session a stage but the last
  std::vector<StageStart> block_;
  std::size_t next_ = 0;
};

}  // namespace moivre
