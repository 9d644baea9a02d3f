// SPDX-License-Identifier: MIT
// Batches of roots along straight lines of members, and triangles of these.
#include "loops.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <numeric>
#include <utility>

#include "moivre/family/learn.h"
#include "moivre/numeric/bytes.h"
#include "moivre/numeric/random.h"
#include "moivre/numeric/threads.h"
#include "moivre/tracker/followed.h"
#include "moivre/tracker/session.h"

namespace moivre {
namespace {

constexpr double kWorstCondition = 1e10;
constexpr double kLeastLoopFiniteness = 1e-9;
constexpr double kLoopNewtonTolerance = 1e-12;

/// What the threads share: paths of a list of roots that nobody has begun, and their ends.
struct Batch {
  const Homotopy& homotopy;
  const std::vector<Point>& starts;
  std::vector<std::size_t> wanted;  ///< numbers of starts
  std::atomic<std::size_t> next{0};
  std::vector<std::optional<Point>>& ends;
  JobShares* shares = nullptr;  ///< says which are this process's, where there are several
  std::mutex mutex = {};
  std::vector<std::size_t> drawn = {};
  Observations* observations = nullptr;
  Fingerprint list = {};

  std::optional<std::size_t> draw() {
    if (shares != nullptr) {
      const auto job = shares->draw();
      if (!job) return std::nullopt;
      const std::lock_guard lock(mutex);
      drawn.push_back(*job);
      return *job;
    }
    const std::size_t k = next++;
    if (k >= wanted.size()) return std::nullopt;
    return wanted[k];
  }

  /// An end, or that there is none.
  std::string bytes_of(std::size_t path) const {
    ByteWriter bytes;
    bytes.put(ends[path].value_or(Point{}));
    return bytes.bytes();
  }
  void keep(std::size_t path) const {
    if (observations == nullptr) return;
    observations->keep(list, JobOutcome{path, bytes_of(path),
                                        ends[path] ? OutcomeKind::root : OutcomeKind::failed});
  }
  void take(std::size_t path, std::string_view outcome) {
    ByteReader bytes(outcome);
    Point end = bytes.get_vector<Complex>();
    if (!end.empty()) ends.at(path) = std::move(end);
  }
};

class BatchSource : public SegmentSource {
 public:
  explicit BatchSource(Batch& batch) : batch_(batch), scratch_(batch.homotopy) {}

  std::optional<PathSegment> next() override {
    const auto path = batch_.draw();
    if (!path) return std::nullopt;
    PathSegment segment;
    segment.path = *path;
    segment.x = batch_.homotopy.chart().homogeneous(batch_.starts[segment.path]);
    return segment;
  }

  void arrived(const PathSegment& segment, SegmentResult&& reached) override {
    if (reached.status != SegmentStatus::arrived) return;
    const Chart& chart = batch_.homotopy.chart();
    if (!is_regular(reached) || chart.finiteness(reached.x) < kLeastLoopFiniteness) return;
    batch_.ends[segment.path] = chart.affine(reached.x);
    batch_.keep(segment.path);
  }

 private:
  /// Improves the end where it was followed in double.
  bool is_regular(SegmentResult& reached) {
    if (reached.regular_condition) return true;
    CorrectorOptions newton;
    newton.tolerance = kLoopNewtonTolerance;
    const Correction correction = scratch_.correct(reached.x, {1.0, 0.0}, newton, true);
    return correction.converged && scratch_.condition() <= kWorstCondition;
  }

  Batch& batch_;
  PathSystem scratch_;
};

void follow(Batch& batch, const Tracker& tracker, const Follower& follower) {
  batch.next = 0;
  on_threads(std::min(follower.threads, static_cast<int>(batch.wanted.size())), [&] {
    BatchSource source(batch);
    run_session(*tracker.open(batch.homotopy), source, follower.stop);
  });
}

/// Between generic members all paths are regular: one that double has lost needs more digits.
void follow_lost(Batch& batch, const Follower& follower) {
  std::erase_if(batch.wanted, [&](std::size_t k) { return batch.ends[k].has_value(); });
  const auto fine = follower.tracker.in_double_double();
  if (fine) follow(batch, *fine, follower);
  for (const std::size_t k : batch.wanted) {
    if (!batch.ends[k] && !follower.stop) batch.keep(k);
  }
}

/// Those that this process draws, and what others tell of theirs.
void follow_shared(Batch& batch, JobShares& shares, const Follower& follower) {
  std::vector<bool> is_wanted(batch.starts.size(), false);
  for (const std::size_t k : batch.wanted) is_wanted[k] = true;
  for (std::size_t k = 0; k < is_wanted.size(); ++k) {
    if (!is_wanted[k]) shares.tell(k, batch.bytes_of(k));
  }
  const auto follow_mine = [&] {
    batch.shares = &shares;
    follow(batch, follower.tracker, follower);
    batch.shares = nullptr;
    batch.wanted = std::exchange(batch.drawn, {});
    const std::vector<std::size_t> mine = batch.wanted;
    follow_lost(batch, follower);
    if (follower.stop) return;
    for (const std::size_t k : mine) shares.tell(k, batch.bytes_of(k));
  };
  do_together(shares, follower.stop, follow_mine, [&](const ToldOutcome& told) {
    batch.take(told.job, told.bytes);
    batch.keep(told.job);
  });
}

/// Takes the ends that are known; the others are wanted.
void recall(Batch& batch, const Follower& follower) {
  batch.wanted.resize(batch.starts.size());
  std::iota(batch.wanted.begin(), batch.wanted.end(), std::size_t{0});
  if (follower.observations == nullptr) return;
  FingerprintMaker maker;
  maker.add(std::string_view("roots"));
  add_to(maker, batch.homotopy);
  add_to(maker, follower.tracker);
  for (const Point& start : batch.starts) maker.add(start);
  batch.list = maker.fingerprint();
  batch.observations = follower.observations;
  const auto known = follower.observations->recall(batch.list);
  for (const auto& [path, outcome] : known) batch.take(path, outcome);
  std::erase_if(batch.wanted, [&](std::size_t k) { return known.count(k) > 0; });
}

Point random_member(const std::vector<double>& sizes, std::uint64_t seed, std::uint64_t number) {
  Point p;
  for (std::size_t j = 0; j < sizes.size(); ++j) {
    const std::uint64_t index = (number << 24) + 2 * j;
    const double radius = 0.5 + random_unit(seed, RandomStream::family, index);
    p.push_back(sizes[j] * radius * random_phase(seed, RandomStream::family, index + 1));
  }
  return p;
}

}  // namespace

std::vector<std::optional<Point>> follow_roots(const System& system, const Point& from,
                                               const Point& to, const std::vector<Point>& roots,
                                               const Follower& follower) {
  const Homotopy homotopy = Homotopy::parameters(system, from, to);
  std::vector<std::optional<Point>> ends(roots.size());
  Batch batch{homotopy, roots, {}, {}, ends};
  recall(batch, follower);
  const auto shares = batch.observations != nullptr && roots.size() > 1
                          ? batch.observations->share(batch.list, roots.size())
                          : std::unique_ptr<JobShares>();
  if (shares) {
    follow_shared(batch, *shares, follower);
    if (!follower.stop) batch.observations->lists_are_done();
  } else {
    follow(batch, follower.tracker, follower);
    follow_lost(batch, follower);
  }
  return ends;
}

LoopCount go_round_loops(const System& system, const Point& base, const LoopSearch& search,
                         const Follower& follower, RootSet& roots) {
  const MonodromyOptions& options = search.options;
  LoopCount count;
  for (int quiet = 0; quiet < options.quiet_loops && !follower.stop;) {
    count.was_cut = count.loops == options.most_loops || roots.size() > options.most_roots;
    if (count.was_cut) break;
    const std::uint64_t number =
        search.first_number + 2 * static_cast<std::uint64_t>(count.loops++);
    const Point a = random_member(search.sizes, options.seed, number);
    const Point b = random_member(search.sizes, options.seed, number + 1);
    std::vector<Point> points = roots.roots();
    const Point* from = &base;
    for (const Point* to : {&a, &b, &base}) {
      count.paths += points.size();
      RootSet arrived;  // a path that jumped comes to a point that is there already
      for (auto& end : follow_roots(system, *from, *to, points, follower)) {
        if (end) arrived.add(std::move(*end));
      }
      points = arrived.roots();
      from = to;
    }
    const std::size_t before = roots.size();
    for (Point& point : points) roots.add(std::move(point));
    quiet = roots.size() == before ? quiet + 1 : 0;
    if (options.progress) options.progress({count.loops, roots.size()});
  }
  return count;
}

}  // namespace moivre
