// SPDX-License-Identifier: MIT
// A solve as JSON: the contract of docs/json.md, key by key.
#include "moivre/report/json_writer.h"
#include "moivre/report/solve_report.h"
#include "moivre/report/text_pieces.h"

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

Json point_of_set_json(const Solution& point) {
  return {{"path", point.path}, {"paths", point.multiplicity}, {"x", to_json(point.x)},
          {"real", point.real}, {"residual", point.residual},  {"accuracy", point.accuracy}};
}

Json plane_json(const CoordinatePlane& plane, const std::vector<std::string>& unknowns) {
  return {{"zero", zero_names(plane, unknowns)}, {"dimension", plane.dimension}};
}

Json cross_check_json(const CrossCheck& check) {
  return {{"witness", check.witness},
          {"common", check.common},
          {"missed", check.missed},
          {"unwitnessed", check.unwitnessed},
          {"disagreements", list_json(check.disagreements, disagreement_json)}};
}

}  // namespace

void write_solve_json(const TextSink& sink, const SolveResult& result, const std::string& file) {
  write_json(sink, [&](JsonWriter& report) {
    report.members(report_head("solve", file));
    report.member("seed", result.seed);
    report.member("complete", result.complete);
    report.member("message", result.message);
    report.member("system", to_json(result.system));
    report.member("reduced", reduced_json(result.reduced));
    report.member("start", to_json(result.start));
    report.member("completeness",
                  result.completeness ? Json(to_string(*result.completeness)) : Json());
    report.member("bound", result.bound ? to_json(*result.bound) : Json());
    report.member("tracker", tracker_json(result.tracker, result.tracker_options));
    report.member("paths", to_json(result.paths));
    if (result.digits) report.member("digits", *result.digits);
    report.list("solutions", result.solutions, [&](const Solution& s) {
      Json solution = to_json(s);
      if (result.digits) solution["x_digits"] = digits_json(s.x_digits);
      return solution;
    });
    if (!result.on_sets.empty()) report.list("on_sets", result.on_sets, point_of_set_json);
    if (!result.planes.empty()) {
      report.list("planes", result.planes, [&](const CoordinatePlane& plane) {
        return plane_json(plane, result.system.variables);
      });
    }
    report.member("excess", result.excess);
    if (result.on_denominators > 0) report.member("on_denominators", result.on_denominators);
    if (result.filtered > 0) report.member("filtered", result.filtered);
    report.list("failures", result.failures, [](const FailedPath& f) { return to_json(f); });
    if (result.cross_check) report.member("cross_check", cross_check_json(*result.cross_check));
    report.member("left_out", to_json(result.left_out));
    report.member("work", work_json(result.work));
    report.member("time_s", to_json(result.time));
  });
}

std::string solve_json(const SolveResult& result, const std::string& file) {
  return whole_text([&](const TextSink& sink) { write_solve_json(sink, result, file); });
}

}  // namespace moivre
