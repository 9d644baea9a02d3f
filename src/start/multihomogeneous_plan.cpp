// SPDX-License-Identifier: MIT
// The plan of a linear-product start.
#include "moivre/start/multihomogeneous_plan.h"

namespace moivre {
namespace {

class LinearProductPoints : public StartPoints {
 public:
  explicit LinearProductPoints(LinearProductStart start) : start_(std::move(start)) {}
  StartPoint at(std::uint64_t path) const override { return {start_point(start_, path), nullptr}; }

 private:
  LinearProductStart start_;
};

}  // namespace

std::optional<StartPlan> multihomogeneous_plan(const System& f, const Partition& groups,
                                               std::uint64_t seed) {
  LinearProductStart start = linear_product_start(f, groups, seed);
  const std::optional<System> g = start_system(start, f.variables);
  if (!g) return std::nullopt;
  StartPlan plan{StartSource::multihomogeneous, start.paths, {}, nullptr};
  plan.stages.emplace_back(f, *g);
  plan.points = std::make_shared<LinearProductPoints>(std::move(start));
  return plan;
}

}  // namespace moivre
