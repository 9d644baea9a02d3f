// SPDX-License-Identifier: MIT
// The path pool: a shared counter of paths, a session and its endgames on every thread.
#include "path_pool.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <map>
#include <mutex>

#include "beginnings.h"
#include "marks.h"

namespace moivre {
namespace {

// To wake the threads of a pool takes longer than to follow so few paths, unless these were found to be hard.
constexpr std::uint64_t kFewPaths = 4;

// Paths that a thread takes through the early stages of a plan together: many times the lanes there are.
constexpr std::uint64_t kBlock = 128;
constexpr std::uint64_t kBlocksOfAThread = 4;

/// What the threads share: the next path to begin and the sink.
struct Shared {
  std::uint64_t count;
  const std::function<std::uint64_t(std::uint64_t)>& path_of;
  int care;
  const EndSink& sink;
  const std::atomic<bool>& stop;
  std::atomic<std::uint64_t> next{0};
  std::mutex sink_mutex;

  std::optional<std::uint64_t> draw() {
    if (stop.load(std::memory_order_relaxed)) return std::nullopt;
    const std::uint64_t k = next.fetch_add(1, std::memory_order_relaxed);
    if (k >= count) return std::nullopt;
    return path_of(k);
  }
};

/// Feeds the session of the last stage: first what its endgames ask for, then new paths.
class SessionSource : public DepartureSource {
 public:
  SessionSource(const PathProblem& problem, Shared& shared, Beginnings& beginnings)
      : problem_(problem),
        shared_(shared),
        beginnings_(beginnings),
        scratch_(problem.plan.last()) {}

  std::optional<Departure> next() override {
    if (!ready_.empty()) {
      Departure departure = std::move(ready_.back());
      ready_.pop_back();
      return departure;
    }
    while (std::optional<Beginning> beginning = beginnings_.next()) {
      if (!beginning->lost) return depart(std::move(*beginning));
      hand_in(beginning->path, std::move(*beginning->lost));
    }
    return std::nullopt;
  }

  void arrived(const Departure& departure, Arrival&& arrival) override {
    const auto found = under_way_.find(departure.path);
    if (auto next = found->second->accept(std::move(arrival), scratch_)) {
      ready_.push_back(std::move(*next));
      return;
    }
    hand_in(departure.path, std::move(found->second->end()));
    under_way_.erase(found);
  }

 private:
  Departure depart(Beginning&& beginning) {
    const std::uint64_t path = beginning.path;
    auto& endgame = under_way_[path];
    endgame = std::make_unique<Endgame>(problem_.endgame, problem_.plan.last().chart(), path,
                                        shared_.care);
    PathEnd& end = endgame->end();
    end.count = beginning.count;
    end.stage = problem_.plan.stages.size() - 1;
    if (end.stage > 0) end.mark = mark_of(outside(beginning.frame, beginning.x));
    return endgame->depart(std::move(beginning.x), std::move(beginning.frame));
  }

  void hand_in(std::uint64_t path, PathEnd&& end) {
    const std::lock_guard lock(shared_.sink_mutex);
    shared_.sink(path, std::move(end));
  }

  const PathProblem& problem_;
  Shared& shared_;
  Beginnings& beginnings_;
  PathSystem scratch_;
  std::vector<Departure> ready_;
  std::map<std::uint64_t, std::unique_ptr<Endgame>> under_way_;
};

void track_on_one_thread(const PathProblem& problem, std::uint64_t threads, Shared& shared) {
  const std::uint64_t share = shared.count / (threads * kBlocksOfAThread) + 1;
  Beginnings beginnings(problem.plan, problem.tracker, shared.care, std::min(kBlock, share),
                        [&] { return shared.draw(); });
  SessionSource source(problem, shared, beginnings);
  const auto session = problem.tracker.open(problem.plan.last());
  if (problem.plan.stages.size() == 1) return session->run(source, shared.stop);
  while (beginnings.advance(shared.stop)) session->run(source, shared.stop);
}

}  // namespace

void for_each_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& f) {
  if (threads <= 1 || count <= 1) {
    for (std::size_t k = 0; k < count; ++k) f(k);
    return;
  }
  // Without it oneTBB warns, and keeps to the number of cores, where more threads are asked for.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, f); });
}

void track_paths(const PathProblem& problem, std::uint64_t count,
                 const std::function<std::uint64_t(std::uint64_t)>& path_of, int care, int threads,
                 const EndSink& sink, const std::atomic<bool>& stop) {
  Shared shared{count, path_of, care, sink, stop, {}, {}};
  const bool few = count <= kFewPaths && care == 0;
  const std::uint64_t sessions =
      few ? std::min<std::uint64_t>(count, 1)
          : std::min<std::uint64_t>(static_cast<std::uint64_t>(threads), count);
  for_each_parallel(sessions, threads,
                    [&](std::size_t) { track_on_one_thread(problem, sessions, shared); });
}

std::optional<Point> followed_back(const PathProblem& problem, const Point& x, int care,
                                   const std::atomic<bool>& stop) {
  const Homotopy& homotopy = problem.plan.last();
  const auto session = problem.tracker.open(homotopy);
  Departure departure;
  departure.contour = Contour::segment(1, 0);
  if (homotopy.is_framed()) {
    departure.frame = std::make_shared<PathFrame>(frame_at(homotopy, x));
  }
  departure.x = inside(departure.frame, x);
  departure.care = care;
  const FramePointer frame = departure.frame;
  Arrival back = follow(*session, std::move(departure), stop);
  if (back.journey != Journey::arrived) return std::nullopt;
  return outside(frame, std::move(back.x));
}

}  // namespace moivre
