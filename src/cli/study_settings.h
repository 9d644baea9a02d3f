// SPDX-License-Identifier: MIT
// Which trackers and tolerances does a study run? Curves by name, each along the same tolerances.
//
//   bdf_projection, bdf, adams           CVODE's methods, formulas solved by fixed-point iteration
//   the same with +newton                by Newton's iteration with a Jacobian by difference
//                                        quotients
//   lanes, lanes+cubic, lanes+tangent    the SIMD tracker with its three predictors; its tolerance
//                                        is that of the first correction
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "moivre/tracker/tracker.h"

namespace moivre {

struct StudyChoice {
  std::vector<std::string> curves;  ///< empty: all that this program was built with
  std::vector<double> tolerances;   ///< empty: some of them, or all when `full`
  bool full = false;
};

struct ChosenSetting {
  std::string curve;
  double tolerance = 0;
  std::shared_ptr<const Tracker> tracker;
};

/// Curve by curve, tolerances falling. Throws std::invalid_argument for a curve that there is not
/// and a tolerance that its tracker refuses.
std::vector<ChosenSetting> chosen_settings(const StudyChoice& choice);

/// A careful tracker and its careful witness; the second is nullptr where one tracker was built.
struct ReferenceTrackers {
  std::unique_ptr<Tracker> reference_tracker;
  std::unique_ptr<Tracker> witness;
};
ReferenceTrackers make_reference_trackers();

}  // namespace moivre
