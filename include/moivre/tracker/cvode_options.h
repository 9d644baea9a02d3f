// SPDX-License-Identifier: MIT
// What can be chosen of CVODE as a tracker? It stands apart from the tracker, so that every program
// knows its options by name.
//
// What the methods and iterations do is told in tracker_cvode/cvode_tracker.h.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "moivre/tracker/option_table.h"

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

const OptionTable<CvodeOptions>& cvode_table();

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const CvodeOptions& options);

}  // namespace moivre
