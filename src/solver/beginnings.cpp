// SPDX-License-Identifier: MIT
// Blocks of paths through the early stages of a plan.
#include "beginnings.h"

namespace moivre {
namespace {

/// Hands out a block's paths on one stage and takes them back at its end.
class StageSource : public DepartureSource {
 public:
  StageSource(const StartPlan& plan, std::vector<Beginning>& block, std::size_t stage, int care)
      : plan_(plan), block_(block), stage_(stage), care_(care) {}

  std::optional<Departure> next() override {
    while (next_ < block_.size() && block_[next_].lost) ++next_;
    if (next_ == block_.size()) return std::nullopt;
    Departure departure = departure_of(block_[next_], care_);
    departure.path = next_++;
    return departure;
  }

  void arrived(const Departure& departure, Arrival&& arrival) override {
    take_arrival(plan_, stage_, std::move(arrival), block_[departure.path]);
  }

 private:
  const StartPlan& plan_;
  std::vector<Beginning>& block_;
  std::size_t stage_;
  int care_;
  std::size_t next_ = 0;
};

}  // namespace

Beginning first_beginning(const StartPlan& plan, std::uint64_t path) {
  StartPoint start = plan.points->at(path);
  return {path, std::move(start.x), std::move(start.frame), std::nullopt, {}};
}

Departure departure_of(const Beginning& beginning, int care, Watcher* watcher) {
  Departure departure;
  departure.path = beginning.path;
  departure.x = beginning.x;
  departure.care = care;
  departure.watcher = watcher;
  departure.frame = beginning.frame;
  return departure;
}

void take_arrival(const StartPlan& plan, std::size_t stage, Arrival&& arrival,
                  Beginning& beginning) {
  beginning.count += arrival.count;
  beginning.x = outside(beginning.frame, std::move(arrival.x));
  beginning.frame.reset();
  if (arrival.journey == Journey::arrived) {
    const Homotopy& next = plan.stages[stage + 1];
    if (!next.is_framed()) return;
    beginning.frame = std::make_shared<PathFrame>(frame_at(next, beginning.x));
    beginning.x = inside(beginning.frame, std::move(beginning.x));
    return;
  }
  PathEnd& end = beginning.lost.emplace();
  end.failure = to_failure(arrival.journey);
  end.x = beginning.x;
  end.t = arrival.t.t;
  end.stage = stage;
  end.count = beginning.count;
}

Beginnings::Beginnings(const StartPlan& plan, const Tracker& tracker, int care, std::size_t block,
                       Draw draw)
    : plan_(plan), care_(care), block_size_(block), draw_(std::move(draw)) {
  for (std::size_t stage = 0; stage + 1 < plan.stages.size(); ++stage) {
    early_.push_back(tracker.open(plan.stages[stage]));
  }
}

bool Beginnings::advance(const std::atomic<bool>& stop) {
  if (early_.empty()) return true;
  block_.clear();
  next_ = 0;
  while (block_.size() < block_size_ && !stop.load(std::memory_order_relaxed)) {
    const std::optional<std::uint64_t> path = draw_();
    if (!path) break;
    block_.push_back(first_beginning(plan_, *path));
  }
  for (std::size_t stage = 0; stage < early_.size(); ++stage) {
    StageSource source(plan_, block_, stage, care_);
    run_session(*early_[stage], source, stop);
  }
  return !block_.empty();
}

std::optional<Beginning> Beginnings::next() {
  if (early_.empty()) {
    const std::optional<std::uint64_t> path = draw_();
    if (!path) return std::nullopt;
    return first_beginning(plan_, *path);
  }
  if (next_ == block_.size()) return std::nullopt;
  return std::move(block_[next_++]);
}

}  // namespace moivre
