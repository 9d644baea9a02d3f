// SPDX-License-Identifier: MIT
// Batches of roots along straight lines of members, and triangles of these.
#include "loops.h"

#include <algorithm>
#include <cmath>

#include "moivre/family/learn.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

// Nearer than this, relative, two regular roots of a generic member are one.
constexpr double kSame = 1e-6;
constexpr double kWorstCondition = 1e10;
constexpr double kLeastFiniteness = 1e-9;
constexpr double kNewtonTolerance = 1e-12;

/// Departures of a list of points, arrivals in its order.
class BatchSource : public DepartureSource {
 public:
  BatchSource(const Homotopy& homotopy, const std::vector<Point>& starts)
      : homotopy_(homotopy), starts_(starts), scratch_(homotopy), ends(starts.size()) {}

  std::optional<Departure> next() override {
    if (next_ == starts_.size()) return std::nullopt;
    Departure departure;
    departure.path = next_;
    departure.x = homotopy_.chart().homogeneous(starts_[next_++]);
    return departure;
  }

  void arrived(const Departure& departure, Arrival&& arrival) override {
    if (arrival.journey != Journey::arrived) return;
    CorrectorOptions newton;
    newton.tolerance = kNewtonTolerance;
    const Correction correction = scratch_.correct(arrival.x, {1.0, 0.0}, newton, true);
    const Chart& chart = homotopy_.chart();
    if (!correction.converged || !(scratch_.condition() <= kWorstCondition)) return;
    if (chart.finiteness(arrival.x) < kLeastFiniteness) return;
    ends[departure.path] = chart.affine(arrival.x);
  }

 private:
  const Homotopy& homotopy_;
  const std::vector<Point>& starts_;
  PathSystem scratch_;
  std::size_t next_ = 0;

 public:
  std::vector<std::optional<Point>> ends;
};

std::vector<Point> arrived_points(std::vector<std::optional<Point>> ends) {
  std::vector<Point> points;
  for (auto& end : ends) {
    // A path that jumped comes to a point that is there already.
    if (end && !is_among(points, *end)) points.push_back(std::move(*end));
  }
  return points;
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
                                               const Tracker& tracker,
                                               const std::atomic<bool>& stop) {
  const Homotopy homotopy = Homotopy::parameters(system, from, to);
  BatchSource source(homotopy, roots);
  tracker.open(homotopy)->run(source, stop);
  return std::move(source.ends);
}

bool is_among(const std::vector<Point>& roots, const Point& x) {
  const double least = kSame * std::max(1.0, max_norm(x));
  return std::any_of(roots.begin(), roots.end(), [&](const Point& root) {
    return std::equal(x.begin(), x.end(), root.begin(),
                      [&](const Complex& a, const Complex& b) { return std::abs(a - b) <= least; });
  });
}

int go_round_loops(const System& system, const Point& base, const std::vector<double>& sizes,
                   const Tracker& tracker, const MonodromyOptions& options,
                   std::uint64_t first_number, const std::atomic<bool>& stop,
                   std::vector<Point>& roots) {
  int quiet = 0;
  int loop = 0;
  for (; loop < options.most_loops && quiet < options.quiet_loops && !stop; ++loop) {
    const std::uint64_t number = first_number + 2 * static_cast<std::uint64_t>(loop);
    const Point a = random_member(sizes, options.seed, number);
    const Point b = random_member(sizes, options.seed, number + 1);
    std::vector<Point> points = roots;
    const Point* from = &base;
    for (const Point* to : {&a, &b, &base}) {
      points = arrived_points(follow_roots(system, *from, *to, points, tracker, stop));
      from = to;
    }
    const std::size_t before = roots.size();
    for (Point& point : points) {
      if (!is_among(roots, point)) roots.push_back(std::move(point));
    }
    quiet = roots.size() == before ? quiet + 1 : 0;
    if (roots.size() > options.most_roots) break;
  }
  return loop;
}

}  // namespace moivre
