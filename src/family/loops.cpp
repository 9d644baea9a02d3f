// SPDX-License-Identifier: MIT
// Batches of roots along straight lines of members, and triangles of these.
#include "loops.h"

#include <algorithm>
#include <numeric>

#include "moivre/family/learn.h"
#include "moivre/numeric/bytes.h"
#include "moivre/numeric/random.h"
#include "moivre/numeric/threads.h"
#include "moivre/tracker/followed.h"

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
  Observations* observations = nullptr;
  Fingerprint list = {};

  /// An end, or that there is none.
  void keep(std::size_t path) const {
    if (observations == nullptr) return;
    ByteWriter bytes;
    bytes.put(ends[path].value_or(Point{}));
    observations->keep(list, JobOutcome{path, bytes.bytes(),
                                        ends[path] ? OutcomeKind::root : OutcomeKind::failed});
  }
};

class BatchSource : public DepartureSource {
 public:
  explicit BatchSource(Batch& batch) : batch_(batch), scratch_(batch.homotopy) {}

  std::optional<Departure> next() override {
    const std::size_t k = batch_.next++;
    if (k >= batch_.wanted.size()) return std::nullopt;
    Departure departure;
    departure.path = batch_.wanted[k];
    departure.x = batch_.homotopy.chart().homogeneous(batch_.starts[departure.path]);
    return departure;
  }

  void arrived(const Departure& departure, Arrival&& arrival) override {
    if (arrival.journey != Journey::arrived) return;
    const Chart& chart = batch_.homotopy.chart();
    if (!is_regular(arrival) || chart.finiteness(arrival.x) < kLeastLoopFiniteness) return;
    batch_.ends[departure.path] = chart.affine(arrival.x);
    batch_.keep(departure.path);
  }

 private:
  /// Improves the end where it was followed in double.
  bool is_regular(Arrival& arrival) {
    if (arrival.regular_condition) return true;
    CorrectorOptions newton;
    newton.tolerance = kLoopNewtonTolerance;
    const Correction correction = scratch_.correct(arrival.x, {1.0, 0.0}, newton, true);
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
  for (const auto& [path, outcome] : known) {
    ByteReader bytes(outcome);
    Point end = bytes.get_vector<Complex>();
    if (!end.empty()) batch.ends.at(path) = std::move(end);
  }
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
  follow(batch, follower.tracker, follower);
  // Between generic members all paths are regular. A path that double loses needs more digits.
  std::erase_if(batch.wanted, [&](std::size_t k) { return ends[k].has_value(); });
  const auto fine = follower.tracker.in_double_double();
  if (fine) follow(batch, *fine, follower);
  for (const std::size_t k : batch.wanted) {
    if (!ends[k] && !follower.stop) batch.keep(k);
  }
  return ends;
}

LoopCount go_round_loops(const System& system, const Point& base, const LoopSearch& search,
                         const Follower& follower, RootSet& roots) {
  const MonodromyOptions& options = search.options;
  LoopCount count;
  for (int quiet = 0; count.loops < options.most_loops && quiet < options.quiet_loops &&
                      roots.size() <= options.most_roots && !follower.stop;) {
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
