// SPDX-License-Identifier: MIT
// The plans of one stage: from the degrees, and from a point of one's own.
#include "moivre/start/start_plan.h"

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

StartPlan own_plan(const System& f, const System& g, Point start) {
  StartPlan plan{"own", 1, {}, std::make_shared<OwnPoint>(std::move(start))};
  plan.stages.emplace_back(f, g);
  return plan;
}

}  // namespace moivre
