// SPDX-License-Identifier: MIT
// The path pool: a shared counter of paths, a session and its endgames on every thread; then
// cycles, walked together.
#include "path_pool.h"

#include <tbb/cache_aligned_allocator.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

#include "point_hash.h"
#include "stage_starts.h"

namespace moivre {
namespace {

// At least what the stack of one thread takes.
constexpr std::size_t kRoomForThreads = std::size_t{4} << 20;

// Where memory ends while it sets up its threads, oneTBB 2022 spins for ever: it holds the lock
// that its exception asks for. What it needs is asked for before, of its own allocator, unlocked.
void expect_room_for_threads() {
  tbb::cache_aligned_allocator<char> memory;
  memory.deallocate(memory.allocate(kRoomForThreads), kRoomForThreads);
}

// To wake the threads of a pool takes longer than to follow so few paths, unless these were found
// to be hard.
constexpr std::uint64_t kFewPaths = 4;

// Paths that a thread takes through the early stages of a plan together: many times the lanes there
// are.
constexpr std::uint64_t kBlock = 128;
constexpr std::uint64_t kBlocksOfAThread = 4;

/// What the threads share: the next path to begin, the sink, and the paths that wait.
struct Shared {
  const PathList& paths;
  int tolerance_level;
  const EndSink& sink;
  const std::atomic<bool>& stop;
  std::atomic<std::uint64_t> next{0};
  std::atomic<bool> has_thrown{
      false};  ///< the sink: no other path begins, no other end is handed in
  std::atomic<bool> is_exhausted{false};  ///< memory ran out: no other path begins
  std::mutex sink_mutex = {};
  std::vector<WaitingPath> waiting = {};

  void hand_in(std::uint64_t path, PathEnd&& end) {
    const std::lock_guard lock(sink_mutex);
    if (has_thrown) return;
    try {
      sink(path, std::move(end));
    } catch (...) {
      has_thrown = true;
      throw;
    }
  }
  void let_wait(std::uint64_t path, std::unique_ptr<Endgame> endgame) {
    const std::lock_guard lock(sink_mutex);
    waiting.push_back({path, std::move(endgame)});
  }

  bool is_over() const {
    return stop.load(std::memory_order_relaxed) || has_thrown || is_exhausted;
  }

  std::optional<std::uint64_t> draw() {
    if (is_over()) return std::nullopt;
    const auto k = paths.draw ? paths.draw() : next.fetch_add(1, std::memory_order_relaxed);
    if (!k || *k >= paths.count) return std::nullopt;
    return paths.path_of(*k);
  }
};

/// Feeds the session of the last stage: first what its endgames ask for, then new paths.
class SessionSource : public SegmentSource {
 public:
  /// beginnings: of new paths; nullptr: there are none, but paths to be taken up.
  SessionSource(const PathProblem& problem, const EndgameOptions& options, Shared& shared,
                StageStarts* beginnings)
      : problem_(problem),
        options_(options),
        shared_(shared),
        beginnings_(beginnings),
        scratch_(problem.plan.last()) {}

  std::optional<PathSegment> next() override {
    if (ready_.empty() && shared_.paths.endgame_starts) {
      if (const auto path = shared_.draw()) take_up(*path, shared_.paths.endgame_starts->at(*path));
    }
    if (!ready_.empty()) {
      PathSegment segment = std::move(ready_.back());
      ready_.pop_back();
      return segment;
    }
    while (std::optional<StageStart> beginning = beginnings_ ? beginnings_->next() : std::nullopt) {
      if (!beginning->lost) return depart(std::move(*beginning));
      shared_.hand_in(beginning->path, std::move(*beginning->lost));
    }
    return std::nullopt;
  }

  void arrived(const PathSegment& segment, SegmentResult&& reached) override {
    const auto found = under_way_.find(segment.path);
    std::unique_ptr<Endgame> endgame = std::move(found->second);
    under_way_.erase(found);
    auto next = endgame->accept(std::move(reached), scratch_);
    take_up({segment.path, std::move(endgame)}, std::move(next));
  }

  void take_up(WaitingPath&& path, std::optional<PathSegment>&& next) {
    if (next) {
      ready_.push_back(std::move(*next));
      under_way_[path.path] = std::move(path.endgame);
    } else if (path.endgame->waits()) {
      let_wait(std::move(path));
    } else {
      hand_in(std::move(path));
    }
  }

 protected:
  bool is_ready() const { return !ready_.empty(); }
  PathSystem& scratch() { return scratch_; }

  virtual void let_wait(WaitingPath&& path) {
    shared_.let_wait(path.path, std::move(path.endgame));
  }
  virtual void hand_in(WaitingPath&& path) {
    shared_.hand_in(path.path, std::move(path.endgame->end()));
  }

 private:
  void take_up(std::uint64_t path, const EndgameStart& endgame_start) {
    auto endgame = new_endgame(path);
    PathSegment next = endgame->take_up(endgame_start, scratch_);
    take_up({path, std::move(endgame)}, std::move(next));
  }

  PathSegment depart(StageStart&& beginning) {
    const std::uint64_t path = beginning.path;
    auto& endgame = under_way_[path];
    endgame = new_endgame(path);
    PathEnd& end = endgame->end();
    end.count = beginning.count;
    return endgame->depart(std::move(beginning.x), std::move(beginning.frame));
  }

  std::unique_ptr<Endgame> new_endgame(std::uint64_t path) const {
    auto endgame = std::make_unique<Endgame>(options_, problem_.plan.last().chart(), path,
                                             shared_.tolerance_level);
    endgame->end().stage = problem_.plan.stages.size() - 1;
    return endgame;
  }

  const PathProblem& problem_;
  const EndgameOptions& options_;
  Shared& shared_;
  StageStarts* beginnings_;
  PathSystem scratch_;
  std::vector<PathSegment> ready_;
  std::map<std::uint64_t, std::unique_ptr<Endgame>> under_way_;
};

void track_on_one_thread(const PathProblem& problem, const EndgameOptions& options,
                         std::uint64_t threads, Shared& shared) {
  if (shared.paths.endgame_starts) {
    SessionSource source(problem, options, shared, nullptr);
    run_session(*problem.tracker.open(problem.plan.last()), source, shared.stop);
    return;
  }
  const std::uint64_t share = shared.paths.count / (threads * kBlocksOfAThread) + 1;
  StageStarts beginnings(problem.plan, problem.tracker, shared.tolerance_level,
                         std::min(kBlock, share), [&] { return shared.draw(); });
  SessionSource source(problem, options, shared, &beginnings);
  const auto session = problem.tracker.open(problem.plan.last());
  if (problem.plan.stages.size() == 1) return run_session(*session, source, shared.stop);
  while (beginnings.advance(shared.stop)) run_session(*session, source, shared.stop);
}

/// False where memory ran out.
bool is_within_memory(Shared& shared, const std::function<void()>& work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    shared.is_exhausted = true;
  }
  return !shared.is_exhausted;
}

/// What one thread does with the chains that it draws: on every circle their sheets wait for one
/// another after a turn.
class CycleSource : public SessionSource {
 public:
  CycleSource(const PathProblem& problem, Shared& shared, std::vector<WaitingPath>& waiting,
              const std::vector<SheetChain>& chains, const JobDraw& draw)
      : SessionSource(problem, problem.endgame, shared, nullptr),
        most_turns_(static_cast<std::size_t>(problem.endgame.ends.maximum_winding)),
        shared_(shared),
        waiting_(waiting),
        chains_(chains),
        draw_(draw) {}

  std::optional<PathSegment> next() override {
    while (!is_ready() && !shared_.is_over()) {
      const auto chain = draw_();
      if (!chain) break;
      go_on(waiting_, chains_[*chain]);
    }
    return SessionSource::next();
  }

 private:
  /// Sheets that began together: how many have no end yet, and which of them wait.
  struct Sheets {
    std::size_t without_end = 0;
    std::vector<WaitingPath> waiting;
  };

  /// Those of a closed chain share their turns. One with more of them than a cycle may have is left
  /// for a smaller circle. Where one is open, its last walks on.
  void go_on(std::vector<WaitingPath>& waiting, const SheetChain& chain) {
    const auto sheets = std::make_shared<Sheets>();
    sheets->without_end = chain.sheets.size();
    std::size_t turns = 0;
    for (const std::size_t k : chain.sheets) {
      sheets_of_[waiting[k].path] = sheets;
      sheets->waiting.push_back(std::move(waiting[k]));
      turns += static_cast<std::size_t>(sheets->waiting.back().endgame->turns());
    }
    if (chain.is_closed || turns > most_turns_) {
      join(std::exchange(sheets->waiting, {}));
    } else {
      WaitingPath last = std::move(sheets->waiting.back());
      sheets->waiting.pop_back();
      PathSegment next = last.endgame->walk_on();
      take_up(std::move(last), std::move(next));
    }
  }

  /// What the first finds at infinity holds for all.
  void join(std::vector<WaitingPath>&& sheets) {
    std::vector<std::vector<Point>> samples;
    for (const WaitingPath& sheet : sheets) samples.push_back(sheet.endgame->samples());
    Endgame& first = *sheets.front().endgame;
    std::optional<PathSegment> next_of_first = first.join(samples, 0, scratch());
    const bool is_told = first.end().status == PathStatus::at_infinity;
    for (std::size_t k = 1; k < sheets.size(); ++k) {
      std::optional<PathSegment> next = is_told ? sheets[k].endgame->end_with(first)
                                                : sheets[k].endgame->join(samples, k, scratch());
      take_up(std::move(sheets[k]), std::move(next));
    }
    take_up(std::move(sheets.front()), std::move(next_of_first));
  }

  void let_wait(WaitingPath&& path) override {
    const auto sheets = sheets_of_.at(path.path);
    sheets->waiting.push_back(std::move(path));
    go_on_if_all_wait(*sheets);
  }

  void hand_in(WaitingPath&& path) override {
    const auto found = sheets_of_.find(path.path);
    const auto sheets = found->second;
    sheets_of_.erase(found);
    SessionSource::hand_in(std::move(path));
    --sheets->without_end;
    go_on_if_all_wait(*sheets);
  }

  /// On a smaller circle they may belong to several cycles.
  void go_on_if_all_wait(Sheets& sheets) {
    if (sheets.waiting.size() < sheets.without_end) return;
    std::vector<WaitingPath> waiting = std::exchange(sheets.waiting, {});
    for (const SheetChain& chain : chains_among(waiting)) go_on(waiting, chain);
  }

  std::size_t most_turns_;
  Shared& shared_;
  std::vector<WaitingPath>& waiting_;
  const std::vector<SheetChain>& chains_;
  const JobDraw& draw_;
  std::map<std::uint64_t, std::shared_ptr<Sheets>> sheets_of_;
};

}  // namespace

void for_each_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& f) {
  if (threads <= 1 || count <= 1) {
    for (std::size_t k = 0; k < count; ++k) f(k);
    return;
  }
  expect_room_for_threads();
  // Without it oneTBB warns, and keeps to the number of cores, where more threads are asked for.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  std::atomic<bool> is_of_work = false;
  const auto work = [&](std::size_t k) {
    try {
      f(k);
    } catch (...) {
      is_of_work = true;
      throw;
    }
  };
  try {
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, work); });
  } catch (const std::runtime_error&) {
    if (is_of_work) throw;
    // The system has no memory for another thread.
    throw std::bad_alloc();
  }
}

bool are_few(std::uint64_t paths, int tolerance_level) {
  return paths <= kFewPaths && tolerance_level == 0;
}

bool track_until_they_wait(const PathProblem& problem, const PathList& paths, int tolerance_level,
                           int threads, const EndSink& sink, const std::atomic<bool>& stop,
                           std::vector<WaitingPath>& waiting) {
  Shared shared{paths, tolerance_level, sink, stop};
  EndgameOptions options = problem.endgame;
  options.may_wait = paths.count + paths.known > 1;
  const std::uint64_t sessions =
      std::min(are_few(paths.count, tolerance_level) ? std::uint64_t{1}
                                                     : static_cast<std::uint64_t>(threads),
               paths.count);
  for_each_parallel(sessions, threads, [&](std::size_t) {
    is_within_memory(shared, [&] { track_on_one_thread(problem, options, sessions, shared); });
  });
  for (WaitingPath& path : shared.waiting) waiting.push_back(std::move(path));
  return !shared.is_exhausted;
}

std::vector<SheetChain> chains_among(std::vector<WaitingPath>& waiting) {
  std::sort(waiting.begin(), waiting.end(),
            [](const WaitingPath& a, const WaitingPath& b) { return a.path < b.path; });
  std::vector<Turn> turns;
  for (const WaitingPath& path : waiting) {
    const Endgame& endgame = *path.endgame;
    turns.push_back(
        {endgame.radius(), hash_of(endgame.begin_of_turn()), hash_of(endgame.end_of_turn())});
  }
  return chains_of(turns);
}

bool walk_cycles(const PathProblem& problem, std::vector<WaitingPath>& waiting,
                 const std::vector<SheetChain>& chains, const JobDraw& draw, int threads,
                 const EndSink& sink, const std::atomic<bool>& stop) {
  const PathList none;
  Shared shared{none, 0, sink, stop};
  const std::size_t sessions = std::min(static_cast<std::size_t>(threads), chains.size());
  is_within_memory(shared, [&] {
    for_each_parallel(sessions, threads, [&](std::size_t) {
      CycleSource source(problem, shared, waiting, chains, draw);
      run_session(*problem.tracker.open(problem.plan.last()), source, shared.stop);
    });
  });
  return !shared.is_exhausted;
}

bool track_paths(const PathProblem& problem, const PathList& paths, int tolerance_level,
                 int threads, const EndSink& sink, const std::atomic<bool>& stop,
                 const std::function<void()>& when_they_wait) {
  std::vector<WaitingPath> waiting;
  if (!track_until_they_wait(problem, paths, tolerance_level, threads, sink, stop, waiting))
    return false;
  if (waiting.empty()) return true;
  if (when_they_wait) when_they_wait();
  std::vector<SheetChain> chains;
  try {
    chains = chains_among(waiting);
  } catch (const std::bad_alloc&) {
    return false;
  }
  std::atomic<std::size_t> next{0};
  const JobDraw in_order = [&]() -> std::optional<std::uint64_t> {
    const std::size_t k = next.fetch_add(1, std::memory_order_relaxed);
    if (k >= chains.size()) return std::nullopt;
    return k;
  };
  return walk_cycles(problem, waiting, chains, in_order, threads, sink, stop);
}

}  // namespace moivre
