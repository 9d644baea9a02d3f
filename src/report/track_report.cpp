// SPDX-License-Identifier: MIT
// A trace as CSV, as JSON and as a sentence.
#include "moivre/report/track_report.h"

#include "moivre/expression/counted.h"
#include "moivre/report/json.h"
#include "moivre/report/number_text.h"
#include "moivre/report/text_blocks.h"

namespace moivre {
namespace {

std::string cell(Complex x) { return ',' + exact_text(x.real()) + ',' + exact_text(x.imag()); }

Json step_json(const TraceStep& step) {
  return {{"journey", step.segment},
          {"s", to_json(step.s)},
          {"t", to_json(step.t)},
          {"x", to_json(step.x)},
          {"h_before", to_json(step.h_before)},
          {"h_after", to_json(step.h_after)},
          {"correction", to_json(step.correction)},
          {"step", to_json(step.step)},
          {"order", step.order}};
}

Json end_json(const Trace& trace) {
  const PathEnd& end = trace.end;
  return {{"status", to_string(end.status)},
          {"reason", end.failure ? Json(to_string(*end.failure)) : Json(nullptr)},
          {"t", to_json(end.t)},
          {"x", trace.x.empty() ? Json(nullptr) : to_json(trace.x)},
          {"singular", end.singular},
          {"winding", end.winding ? Json(*end.winding) : Json(nullptr)},
          {"accuracy", end.status == PathStatus::finite ? to_json(end.accuracy) : Json(nullptr)},
          {"condition", end.status == PathStatus::finite ? to_json(end.condition) : Json(nullptr)}};
}

Json start_json(const Trace& trace, const TrackHeading& heading) {
  if (heading.from.empty()) return {{"kind", "total-degree"}, {"paths", to_json(trace.paths)}};
  return {{"kind", "own"},
          {"paths", to_json(trace.paths)},
          {"from", heading.from},
          {"points", heading.points}};
}

}  // namespace

std::string track_csv(const Trace& trace) {
  std::string text = "journey,s,t.re,t.im";
  for (const std::string& name : trace.system.variables) text += ',' + name + ".re," + name + ".im";
  text += ",h_before,h_after,correction,step,order\n";
  for (const TraceStep& step : trace.steps) {
    text += std::to_string(step.segment) + ',' + exact_text(step.s) + cell(step.t);
    for (const Complex& xi : step.x) text += cell(xi);
    for (const double x : {step.h_before, step.h_after, step.correction, step.step}) {
      text += ',' + exact_text(x);
    }
    text += ',' + std::to_string(step.order) + '\n';
  }
  return text;
}

std::string track_json(const Trace& trace, const TrackHeading& heading) {
  Json report = report_head("track", heading.file);
  report["seed"] = heading.seed;
  report["path"] = trace.path;
  report["system"] = {{"variables", trace.system.variables},
                      {"degrees", trace.system.degrees},
                      {"total_degree", to_json(trace.system.total_degree)}};
  report["start"] = start_json(trace, heading);
  report["tracker"] = tracker_json(trace.tracker, trace.tracker_options);
  report["steps"] = Json::array();
  for (const TraceStep& step : trace.steps) report["steps"].push_back(step_json(step));
  report["end"] = end_json(trace);
  report["work"] = work_json(trace.end.count);
  report["left_out"] = to_json(trace.left_out);
  return to_text(report);
}

std::string track_verdict(const Trace& trace) {
  const PathEnd& end = trace.end;
  const std::string steps = counted(end.count.accepted, "step") + " and " +
                            std::to_string(end.count.rejected) + " rejected";
  std::string text = "path " + std::to_string(trace.path) + ": ";
  switch (end.status) {
    case PathStatus::finite:
      text += "finite";
      if (end.winding) text += ", winding number " + std::to_string(*end.winding);
      if (end.singular) text += ", singular";
      break;
    case PathStatus::at_infinity:
      text += "at infinity";
      break;
    case PathStatus::failed:
      text += "failed at t = " + complex_text(end.t) + ": " +
              (end.failure ? to_string(*end.failure) : "unknown reason");
      break;
  }
  return text + "; " + steps + '\n';
}

}  // namespace moivre
