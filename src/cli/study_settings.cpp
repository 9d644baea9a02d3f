// SPDX-License-Identifier: MIT
// The settings of a study, made by the choice of trackers that all commands share.
#include "study_settings.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "moivre/expression/joined.h"
#include "tracker_choice.h"

namespace moivre {
namespace {

// From far too loose to far tighter than needed; every decade when `full`.
const std::vector<double> kSomeTolerances{1e-1, 1e-2, 1e-3, 1e-4, 1e-6};
const std::vector<double> kAllTolerances{1e-1, 1e-2, 1e-3, 1e-4, 1e-5,
                                         1e-6, 1e-7, 1e-8, 1e-9, 1e-10};
// Careful enough that no jump was ever seen with them (docs/results/study).
constexpr double kReferenceRtol = 1e-5;
constexpr double kReferenceTolerance = 1e-4;

const std::string kNewton = "+newton";

/// Tighter than this a predictor of low order spends its budget of steps; it is tried only where
/// the user says so.
double tightest_of(const std::string& curve) {
  if (curve == "lanes+tangent") return 1e-4;
  if (curve == "lanes+cubic") return 1e-8;
  return 0;
}

std::vector<std::string> built_curves() {
  std::vector<std::string> curves;
#if MOIVRE_WITH_CVODE
  for (const char* method : {"bdf_projection", "bdf", "adams"}) {
    curves.push_back(method);
    curves.push_back(method + kNewton);
  }
#endif
#if MOIVRE_WITH_LANES
  curves.insert(curves.end(), {"lanes", "lanes+cubic", "lanes+tangent"});
#endif
  return curves;
}

TrackerChoice choice_of(const std::string& curve, double tolerance) {
  TrackerChoice choice;
  const std::size_t plus = curve.find('+');
  if (curve.starts_with("lanes")) {
    choice.kind = "lanes";
    choice.values["tolerance"] = tolerance;
    if (plus != std::string::npos) choice.values["predictor"] = curve.substr(plus + 1);
    return choice;
  }
  choice.kind = "cvode";
  choice.values["rtol"] = tolerance;
  choice.values["method"] = curve.substr(0, plus);
  if (plus != std::string::npos) choice.values["iteration"] = "newton";
  return choice;
}

void require_built(const std::vector<std::string>& curves, const std::vector<std::string>& built) {
  std::vector<std::string> unknown;
  for (const std::string& curve : curves) {
    if (std::find(built.begin(), built.end(), curve) == built.end()) unknown.push_back(curve);
  }
  if (unknown.empty()) return;
  throw std::invalid_argument("--settings " + joined(unknown, ",") + ": the settings are " +
                              joined(built, ", "));
}

}  // namespace

std::vector<ChosenSetting> chosen_settings(const StudyChoice& choice) {
  const std::vector<std::string> built = built_curves();
  require_built(choice.curves, built);
  std::vector<double> tolerances = choice.tolerances;
  if (tolerances.empty()) tolerances = choice.full ? kAllTolerances : kSomeTolerances;
  std::sort(tolerances.begin(), tolerances.end(), std::greater<>());
  std::vector<ChosenSetting> settings;
  for (const std::string& curve : choice.curves.empty() ? built : choice.curves) {
    for (const double tolerance : tolerances) {
      if (choice.tolerances.empty() && tolerance < tightest_of(curve)) continue;
      settings.push_back({curve, tolerance, make_tracker(choice_of(curve, tolerance))});
    }
  }
  return settings;
}

ReferenceTrackers make_reference_trackers() {
  ReferenceTrackers references;
#if MOIVRE_WITH_CVODE
  references.reference_tracker = make_tracker(choice_of("bdf_projection", kReferenceRtol));
#endif
#if MOIVRE_WITH_LANES
  auto& lanes = references.reference_tracker ? references.witness : references.reference_tracker;
  lanes = make_tracker(choice_of("lanes", kReferenceTolerance));
#endif
  return references;
}

}  // namespace moivre
