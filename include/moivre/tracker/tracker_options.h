// SPDX-License-Identifier: MIT
// What can be chosen of CVODE as a tracker, and what of the lanes? It stands apart from the
// trackers, so that every program knows their options by name.
//
// What CVODE's methods and iterations do is told in tracker_cvode/cvode_tracker.h.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace moivre {

enum class CvodeMethod { bdf_projection, bdf, adams };
std::string to_string(CvodeMethod method);

/// How the implicit formula of one step is solved.
enum class CvodeIteration { fixed_point, newton };
std::string to_string(CvodeIteration iteration);

struct CvodeOptions {
  CvodeMethod method = CvodeMethod::bdf_projection;
  CvodeIteration iteration = CvodeIteration::fixed_point;
  double rtol = 1e-2;                  ///< relative local error per step, in (0, 0.5]
  std::int64_t maximum_steps = 20000;  ///< accepted and rejected steps of one segment
};

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const CvodeOptions& options);

/// Hermite extrapolation through the last points and tangents of a path: how many of them.
enum class LanePredictor {
  tangent,  ///< one: Euler's, local order 2
  cubic,    ///< two: local order 4
  quintic   ///< three: local order 6
};

/// "tangent", "cubic", "quintic".
std::string to_string(LanePredictor predictor);
/// Local order.
int order_of(LanePredictor predictor);

struct LaneOptions {
  /// |dx|_w of the first Newton correction that steps aim at, in (0, 0.1].
  double tolerance = 3e-3;
  std::int64_t maximum_steps = 20000;  ///< accepted and rejected steps of one segment
  LanePredictor predictor = LanePredictor::quintic;
};

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const LaneOptions& options);

}  // namespace moivre
