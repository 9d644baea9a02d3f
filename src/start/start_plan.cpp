// SPDX-License-Identifier: MIT
// The plans of one stage: from the degrees, from known roots, and from a point of one's own.
#include "moivre/start/start_plan.h"

namespace moivre {
namespace {

class TotalDegreePoints : public StartPoints {
 public:
  explicit TotalDegreePoints(TotalDegreeStart start) : start_(std::move(start)) {}

  StartPoint at(std::uint64_t path) const override { return {start_point(start_, path), nullptr}; }

 private:
  TotalDegreeStart start_;
};

class KnownRoots : public StartPoints {
 public:
  explicit KnownRoots(std::vector<Point> roots) : roots_(std::move(roots)) {}

  StartPoint at(std::uint64_t path) const override { return {roots_[path], nullptr}; }

 private:
  std::vector<Point> roots_;
};

class OwnPoint : public StartPoints {
 public:
  explicit OwnPoint(Point x) : x_(std::move(x)) {}
  StartPoint at(std::uint64_t) const override { return {x_, nullptr}; }

 private:
  Point x_;
};

}  // namespace

StartPlan total_degree_plan(const System& f, std::uint64_t seed) {
  TotalDegreeStart start = total_degree_start(degrees(f), seed);
  StartPlan plan{StartSource::total_degree, start.paths, {}, nullptr};
  plan.stages.emplace_back(f, start_system(start, f.variables));
  plan.points = std::make_shared<TotalDegreePoints>(std::move(start));
  return plan;
}

StartPlan plan_from_roots(Homotopy homotopy, std::vector<Point> roots) {
  StartPlan plan{StartSource::family, roots.size(), {}, nullptr};
  plan.stages.push_back(std::move(homotopy));
  plan.points = std::make_shared<KnownRoots>(std::move(roots));
  return plan;
}

StartPlan own_plan(const System& f, const System& g, Point start) {
  StartPlan plan{StartSource::own, 1, {}, std::make_shared<OwnPoint>(std::move(start))};
  plan.stages.emplace_back(f, g);
  return plan;
}

}  // namespace moivre
