// SPDX-License-Identifier: MIT
// Which homotopies lead to all roots, and where do their paths begin? A plan of stages; it tracks
// nothing itself.
//
//   path 0..paths-1 --start point--> stage 1 --its end at t = 1--> stage 2 --> ... --> the target's
//   roots
//
// Every path goes through all stages. Start points are computed from the path's number, never
// stored; where the first stage is toric a path brings the weights of its cell in its frame
// (homotopy/frame.h). Immutable and shared by all threads.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "moivre/homotopy/homotopy.h"
#include "moivre/start/start_kind.h"
#include "moivre/start/total_degree.h"

namespace moivre {

/// Where a path begins.
struct StartPoint {
  Point x;             ///< homogeneous coordinates, in the frame
  FramePointer frame;  ///< of the first stage, where that is framed; else nullptr
};

/// The start points of the first stage.
class StartPoints {
 public:
  virtual ~StartPoints() = default;
  virtual StartPoint at(std::uint64_t path) const = 0;
};

struct StartPlan {
  StartSource source = StartSource::total_degree;
  std::uint64_t paths = 0;
  std::vector<Homotopy> stages;
  std::shared_ptr<const StartPoints> points;

  const Homotopy& last() const { return stages.back(); }
};

/// t F + (1 - t) G from the degrees. Throws as total_degree_start() does.
StartPlan total_degree_plan(const System& f, std::uint64_t seed);

/// Along `homotopy`, from roots that are known at its t = 0, homogeneous: a path from each.
StartPlan plan_from_roots(Homotopy homotopy, std::vector<Point> roots);

/// t F + (1 - t) G from one point near a root of G, homogeneous; path 0.
StartPlan own_plan(const System& f, const System& g, Point start);

}  // namespace moivre
