// SPDX-License-Identifier: MIT
// The plans of one stage: from the degrees, from known roots, and from a point of one's own.
#include "moivre/start/start_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moivre {
namespace {

class TotalDegreePoints : public StartPoints {
 public:
  explicit TotalDegreePoints(TotalDegreeStart start) : start_(std::move(start)) {}

  StartPoint at(std::uint64_t path) const override { return {start_point(start_, path), nullptr}; }

  // x_j is the k-th of d roots: its angle from the first one tells k.
  std::optional<std::uint64_t> number_of(const Point& x) const override {
    std::uint64_t path = 0;
    std::uint64_t weight = 1;
    for (std::size_t j = 0; j < start_.degrees.size(); ++j) {
      const std::uint64_t d = start_.degrees[j];
      const Complex first = de_moivre_root(start_.c2[j] / start_.c1[j], d, 0);
      const double turn = std::arg(x[j] / x.back() / first) / (2 * std::numbers::pi);
      const auto k = std::llround(turn * static_cast<double>(d)) + static_cast<long long>(d);
      path += weight * (static_cast<std::uint64_t>(k) % d);
      weight *= d;
    }
    return path;
  }

 private:
  TotalDegreeStart start_;
};

// A point is known to be one of the roots from here on, relative.
constexpr double kSameRoot = 1e-6;

/// sin of the angle between two homogeneous points: 0 where they are one.
double apart(const Point& a, const Point& b) {
  Complex inner;
  double aa = 0;
  double bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    inner += product(std::conj(a[i]), b[i]);
    aa += std::norm(a[i]);
    bb += std::norm(b[i]);
  }
  double squared = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    squared += std::norm(b[i] - product(inner / aa, a[i]));
  }
  return std::sqrt(squared / bb);
}

class KnownRoots : public StartPoints {
 public:
  explicit KnownRoots(std::vector<Point> roots) : roots_(std::move(roots)) {}

  StartPoint at(std::uint64_t path) const override { return {roots_[path], nullptr}; }

  std::optional<std::uint64_t> number_of(const Point& x) const override {
    const auto nearest =
        std::min_element(roots_.begin(), roots_.end(),
                         [&](const Point& a, const Point& b) { return apart(a, x) < apart(b, x); });
    if (nearest == roots_.end() || apart(*nearest, x) > kSameRoot) return std::nullopt;
    return static_cast<std::uint64_t>(nearest - roots_.begin());
  }

 private:
  std::vector<Point> roots_;
};

class OwnPoint : public StartPoints {
 public:
  explicit OwnPoint(Point x) : x_(std::move(x)) {}
  StartPoint at(std::uint64_t) const override { return {x_, nullptr}; }
  std::optional<std::uint64_t> number_of(const Point&) const override { return std::nullopt; }

 private:
  Point x_;
};

}  // namespace

StartPlan total_degree_plan(const System& f, std::uint64_t seed) {
  TotalDegreeStart start = total_degree_start(degrees(f), seed);
  StartPlan plan{"total-degree", start.paths, {}, nullptr};
  plan.stages.emplace_back(f, start_system(start, f.variables));
  plan.points = std::make_shared<TotalDegreePoints>(std::move(start));
  return plan;
}

StartPlan plan_from_roots(std::string kind, Homotopy homotopy, std::vector<Point> roots) {
  StartPlan plan{std::move(kind), roots.size(), {}, nullptr};
  plan.stages.push_back(std::move(homotopy));
  plan.points = std::make_shared<KnownRoots>(std::move(roots));
  return plan;
}

StartPlan own_plan(const System& f, const System& g, Point start) {
  StartPlan plan{"own", 1, {}, std::make_shared<OwnPoint>(std::move(start))};
  plan.stages.emplace_back(f, g);
  return plan;
}

}  // namespace moivre
