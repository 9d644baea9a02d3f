// SPDX-License-Identifier: MIT
// A solve as JSON: the contract of docs/json.md, key by key.
#include "moivre/report/json.h"
#include "moivre/report/solve_report.h"

namespace moivre {

std::string solve_json(const SolveResult& result, const std::string& file) {
  Json report = report_head("solve", file);
  report["seed"] = result.seed;
  report["complete"] = result.complete;
  report["message"] = result.message;
  report["system"] = to_json(result.system);
  report["reduced"] = {{"variables", result.reduced.variables.size()},
                       {"degrees", result.reduced.degrees}};
  report["start"] = {
      {"kind", result.start.kind}, {"paths", result.start.paths}, {"why", result.start.why}};
  report["tracker"] = tracker_json(result.tracker, result.tracker_options);
  report["paths"] = to_json(result.paths);
  report["solutions"] = list_json(result.solutions, [](const Solution& s) { return to_json(s); });
  report["failures"] = list_json(result.failures, [](const FailedPath& f) { return to_json(f); });
  report["left_out"] = to_json(result.left_out);
  report["work"] = work_json(result.work);
  report["time_s"] = to_json(result.time);
  return to_text(report);
}

}  // namespace moivre
