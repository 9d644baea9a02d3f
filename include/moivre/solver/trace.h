// SPDX-License-Identifier: MIT
// What happens along one path? Every accepted step of a path as solve() follows it, and the verdict
// on its end.
//
// A trace is a sequence of path segments. The first goes from t = 0 to t = 1. If the end is not
// regular, the endgame's segments towards t = 1 and its circles around it follow. s runs from 0 to
// 1 in each segment. The first row is the start point, with a step of 0.
//
//   path of solve()   number as in Solution::path; H is the homotopy after elimination and scaling,
//                     x is given back in the system's own variables
//   path of one's own H(x, t) = t F(x) + (1 - t) G(x) exactly, from a root of G: nothing is
//   eliminated, scaled or chosen at
//                     random. If F and G are real, paths can meet before t = 1; then multiply G by
//                     a complex constant.
//
// |H| = max_i |H_i| at the point of unit length in homogeneous coordinates. Affine coordinates are
// infinite where x_0 = 0.
// Edges: a trace goes to the end with all effort, also where solve() leaves the path because a
// bound is met. A system without a path (solved or refuted by elimination) is refused.
#pragma once

#include "moivre/endgame/endgame.h"
#include "moivre/solver/solve.h"

namespace moivre {

struct TraceStep {
  int segment = 0;  ///< counts from 0
  double s = 0;
  Complex t;
  Point x;                ///< affine
  double h_before = 0;    ///< |H| before the Newton correction: how far the step drifted
  double h_after = 0;     ///< |H| after it
  double correction = 0;  ///< first Newton correction, relative to each coordinate
  double step = 0;        ///< in s
  int order = 0;          ///< of the integrator
};

struct Trace {
  SystemFacts system;
  std::optional<std::uint64_t> paths;  ///< of the start system; nullopt with a start of one's own
  std::uint64_t path = 0;
  std::vector<TraceStep> steps;
  PathEnd end;
  Point x;  ///< affine end point, as the tracker and the endgame leave it; empty at infinity
  std::string tracker;
  OptionsInForce tracker_options;
  std::vector<LeftOut> left_out;
};

/// Path `path` of solve(f, tracker, options). Throws std::invalid_argument when there is no such
/// path or f is not square.
Trace trace_path(const System& f, const Tracker& tracker, const SolveOptions& options,
                 std::uint64_t path, const std::atomic<bool>& stop);

/// The path of t F + (1 - t) G from `start`, n coordinates near a root of G. Throws
/// std::invalid_argument when F and G are not both n polynomials in the same n variables, in the
/// same order.
Trace trace_path(const System& f, const System& g, const Point& start, const Tracker& tracker,
                 const SolveOptions& options, const std::atomic<bool>& stop);

}  // namespace moivre
