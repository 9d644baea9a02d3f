// SPDX-License-Identifier: MIT
// A solve as JSON: the contract of docs/json.md, key by key.
#include "json.h"
#include "moivre/report/solve_report.h"

namespace moivre {
namespace {

Json solution_json(const Solution& solution) {
  return {{"path", solution.path},
          {"x", to_json(solution.x)},
          {"real", solution.real},
          {"singular", solution.singular},
          {"multiplicity", solution.multiplicity},
          {"winding", solution.winding},
          {"residual", to_json(solution.residual)},
          {"accuracy", to_json(solution.accuracy)},
          {"condition", to_json(solution.condition)}};
}

Json paths_json(const PathCounts& paths) {
  return {{"tracked", paths.tracked},
          {"finite", paths.finite},
          {"at_infinity", paths.at_infinity},
          {"failed", paths.failed},
          {"on_positive_dimensional", paths.on_positive_dimensional},
          {"retracked", paths.retracked},
          {"handed_over", paths.handed_over}};
}

Json failure_json(const FailedPath& failure) {
  return {
      {"path", failure.path}, {"reason", to_string(failure.failure)}, {"t", to_json(failure.t)}};
}

Json time_json(const SolveTime& time) {
  return {{"threads", time.threads},        {"parse", to_json(time.parse)},
          {"start", to_json(time.start)},   {"track", to_json(time.track)},
          {"refine", to_json(time.refine)}, {"total", to_json(time.total)}};
}

template <class List, class Element>
Json list_json(const List& list, Element element) {
  Json array = Json::array();
  for (const auto& item : list) array.push_back(element(item));
  return array;
}

}  // namespace

std::string solve_json(const SolveResult& result, const std::string& file) {
  Json report = report_head("solve", file);
  report["seed"] = result.seed;
  report["complete"] = result.complete;
  report["message"] = result.message;
  report["system"] = {{"variables", result.system.variables},
                      {"degrees", result.system.degrees},
                      {"total_degree", to_json(result.system.total_degree)}};
  report["reduced"] = {{"variables", result.reduced.variables.size()},
                       {"degrees", result.reduced.degrees}};
  report["start"] = {
      {"kind", result.start.kind}, {"paths", result.start.paths}, {"why", result.start.why}};
  report["tracker"] = tracker_json(result.tracker, result.tracker_options);
  report["paths"] = paths_json(result.paths);
  report["solutions"] = list_json(result.solutions, solution_json);
  report["failures"] = list_json(result.failures, failure_json);
  report["left_out"] = to_json(result.left_out);
  report["work"] = work_json(result.work);
  report["time_s"] = time_json(result.time);
  return to_text(report);
}

}  // namespace moivre
