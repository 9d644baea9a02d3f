// SPDX-License-Identifier: MIT
// The path pool: a shared counter of paths, a session and its endgames on every thread.
#include "path_pool.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <map>
#include <mutex>
#include <numbers>

namespace moivre {
namespace {

// To wake the threads of a pool takes longer than to follow so few paths, unless these were found to be hard.
constexpr std::uint64_t kFewPaths = 4;

/// What the threads share: the next path to begin and the sink.
struct Shared {
  std::uint64_t count;
  const std::function<std::uint64_t(std::uint64_t)>& path_of;
  int care;
  const EndSink& sink;
  const std::atomic<bool>& stop;
  std::atomic<std::uint64_t> next{0};
  std::mutex sink_mutex;
};

/// Feeds one session: first what its endgames ask for, then new paths.
class SessionSource : public DepartureSource {
 public:
  SessionSource(const PathProblem& problem, Shared& shared)
      : problem_(problem), shared_(shared), scratch_(problem.homotopy) {}

  std::optional<Departure> next() override {
    if (!ready_.empty()) {
      Departure departure = std::move(ready_.back());
      ready_.pop_back();
      return departure;
    }
    if (shared_.stop.load(std::memory_order_relaxed)) return std::nullopt;
    const std::uint64_t k = shared_.next.fetch_add(1, std::memory_order_relaxed);
    if (k >= shared_.count) return std::nullopt;
    const std::uint64_t path = shared_.path_of(k);
    auto& endgame = under_way_[path];
    endgame = std::make_unique<Endgame>(problem_.endgame, path, shared_.care, problem_.manner);
    return endgame->depart(start_point(problem_.start, path));
  }

  void arrived(const Departure& departure, Arrival&& arrival) override {
    const auto found = under_way_.find(departure.path);
    if (auto next = found->second->accept(std::move(arrival), scratch_)) {
      ready_.push_back(std::move(*next));
      return;
    }
    const std::lock_guard lock(shared_.sink_mutex);
    shared_.sink(departure.path, std::move(found->second->end()));
    under_way_.erase(found);
  }

 private:
  const PathProblem& problem_;
  Shared& shared_;
  PathSystem scratch_;
  std::vector<Departure> ready_;
  std::map<std::uint64_t, std::unique_ptr<Endgame>> under_way_;
};

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
  for_each_parallel(sessions, threads, [&](std::size_t) {
    SessionSource source(problem, shared);
    problem.tracker.open(problem.homotopy)->run(source, stop);
  });
}

std::optional<std::uint64_t> path_through(const PathProblem& problem, const Point& x, int care,
                                          const std::atomic<bool>& stop) {
  const auto session = problem.tracker.open(problem.homotopy);
  const Arrival back = follow(*session, {0, Contour::segment(1, 0), x, care, 0, nullptr}, stop);
  if (back.journey != Journey::arrived) return std::nullopt;
  std::uint64_t path = 0;
  std::uint64_t weight = 1;
  for (std::size_t j = 0; j < problem.start.degrees.size(); ++j) {
    const std::uint64_t d = problem.start.degrees[j];
    const Complex first = de_moivre_root(problem.start.c2[j] / problem.start.c1[j], d, 0);
    const double turn = std::arg(back.x[j] / back.x.back() / first) / (2 * std::numbers::pi);
    const auto k = std::llround(turn * static_cast<double>(d));
    path += weight *
            static_cast<std::uint64_t>((k + static_cast<long long>(d)) % static_cast<long long>(d));
    weight *= d;
  }
  return path;
}

}  // namespace moivre
