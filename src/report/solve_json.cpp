// SPDX-License-Identifier: MIT
// A solve as JSON: the contract of docs/json.md, key by key.
#include "moivre/report/json.h"
#include "moivre/report/solve_report.h"

namespace moivre {
namespace {

Json disagreement_json(const Disagreement& difference) {
  const auto point = [](const std::optional<Point>& x) { return x ? to_json(*x) : Json(); };
  return {{"path", difference.path},
          {"found", point(difference.found)},
          {"witnessed", point(difference.witnessed)},
          {"jumped", difference.jumped ? Json(*difference.jumped) : Json()}};
}

Json digits_json(const std::vector<ComplexDecimal>& x) {
  if (x.empty()) return nullptr;
  return list_json(x, [](const ComplexDecimal& xi) { return Json::array({xi.re, xi.im}); });
}

Json cross_check_json(const CrossCheck& check) {
  return {{"witness", check.witness},
          {"common", check.common},
          {"missed", check.missed},
          {"unwitnessed", check.unwitnessed},
          {"disagreements", list_json(check.disagreements, disagreement_json)}};
}

}  // namespace

std::string solve_json(const SolveResult& result, const std::string& file) {
  Json report = report_head("solve", file);
  report["seed"] = result.seed;
  report["complete"] = result.complete;
  report["message"] = result.message;
  report["system"] = to_json(result.system);
  report["reduced"] = reduced_json(result.reduced);
  report["start"] = to_json(result.start);
  report["completeness"] = result.completeness ? Json(to_string(*result.completeness)) : Json();
  report["bound"] = result.bound ? to_json(*result.bound) : Json();
  report["tracker"] = tracker_json(result.tracker, result.tracker_options);
  report["paths"] = to_json(result.paths);
  if (result.digits) report["digits"] = *result.digits;
  report["solutions"] = list_json(result.solutions, [&](const Solution& s) {
    Json solution = to_json(s);
    if (result.digits) solution["x_digits"] = digits_json(s.x_digits);
    return solution;
  });
  report["excess"] = result.excess;
  if (result.on_denominators > 0) report["on_denominators"] = result.on_denominators;
  if (result.filtered > 0) report["filtered"] = result.filtered;
  report["failures"] = list_json(result.failures, [](const FailedPath& f) { return to_json(f); });
  if (result.cross_check) report["cross_check"] = cross_check_json(*result.cross_check);
  report["left_out"] = to_json(result.left_out);
  report["work"] = work_json(result.work);
  report["time_s"] = to_json(result.time);
  return to_text(report);
}

}  // namespace moivre
