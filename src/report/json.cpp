// SPDX-License-Identifier: MIT
// The common parts of the JSON reports.
#include "moivre/report/json.h"

#include <cmath>

#include "moivre/report/json_writer.h"
#include "moivre/report/text_pieces.h"
#include "moivre/report/version.h"

namespace moivre {
namespace {

/// `x`: the solution's. It comes last: a tree that grows copies what it has.
Json solution_json(const Solution& solution, Json x) {
  Json json{{"path", solution.path},
            {"x", nullptr},
            {"real", solution.real},
            {"singular", solution.singular},
            {"multiplicity", solution.multiplicity},
            {"cluster", solution.cluster},
            {"radius", solution.cluster ? to_json(solution.radius) : Json()},
            {"winding", solution.winding.empty() ? Json(nullptr) : Json(solution.winding)},
            {"residual", to_json(solution.residual)},
            {"accuracy", to_json(solution.accuracy)},
            {"condition", to_json(solution.condition)},
            {"precision", to_string(solution.precision)},
            {"certified", solution.certified ? Json(*solution.certified) : Json()}};
  json["x"] = std::move(x);
  if (!solution.on_boundary.empty()) json["on_boundary"] = solution.on_boundary;
  return json;
}

/// Behind the numbers that `tree` took.
const double* refilled(Json& tree, const double* number) {
  if (!tree.is_structured()) {
    tree = to_json(*number);
    return number + 1;
  }
  for (Json& part : tree) number = refilled(part, number);
  return number;
}

}  // namespace

Json to_json(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json to_json(Complex x) { return Json::array({to_json(x.real()), to_json(x.imag())}); }

Json to_json(const Point& x) {
  Json list = Json::array();
  for (const Complex& xi : x) list.push_back(to_json(xi));
  return list;
}

Json to_json(const std::optional<std::uint64_t>& x) { return x ? Json(*x) : Json(nullptr); }

Json to_json(const std::vector<LeftOut>& left_out) {
  Json list = Json::array();
  for (const LeftOut& item : left_out) list.push_back({{"what", item.what}, {"why", item.why}});
  return list;
}

Json tracker_json(const std::string& kind, const OptionsInForce& options) {
  Json tracker = {{"kind", kind}};
  for (const auto& [name, value] : options) {
    std::visit([&, &key = name](const auto& v) { tracker[key] = v; }, value);
  }
  return tracker;
}

Json work_json(const StepCount& work) {
  return {{"steps", work.accepted},
          {"rejected", work.rejected},
          {"evaluations", work.work.values},
          {"linearizations", work.work.linearizations},
          {"factorizations", work.work.factorizations}};
}

Json to_json(const Solution& solution) { return solution_json(solution, to_json(solution.x)); }

Json to_json(const MetBound& bound) {
  return {{"kind", name_in_results(bound.kind)},
          {"value", bound.value},
          {"certainty", to_string(certainty_of(bound.kind))}};
}

Json to_json(const PathCounts& paths) {
  return {{"tracked", paths.tracked},
          {"finite", paths.finite},
          {"at_infinity", paths.at_infinity},
          {"failed", paths.failed},
          {"not_needed", paths.not_needed},
          {"by_count", paths.by_count},
          {"on_positive_dimensional", paths.on_positive_dimensional},
          {"retracked", paths.retracked},
          {"handed_over", paths.handed_over},
          {"mixed", paths.mixed},
          {"double_double", paths.double_double},
          {"multiprecision", paths.multiprecision}};
}

Json to_json(const FailedPath& failure) {
  return {{"path", failure.path},
          {"reason", to_string(failure.failure)},
          {"t", to_json(failure.t)},
          {"stage", failure.stage}};
}

Json to_json(const SolveTime& time) {
  return {{"threads", time.threads},
          {"parse", to_json(time.parse)},
          {"start", to_json(time.start)},
          {"track", to_json(time.track)},
          {"track_cpu", to_json(time.track_cpu)},
          {"refine", to_json(time.refine)},
          {"total", to_json(time.total)}};
}

Json to_json(const SystemFacts& system) {
  return {{"variables", system.variables},
          {"degrees", system.degrees},
          {"total_degree", to_json(system.total_degree)}};
}

Json to_json(const StartCounts& counts) {
  Json json;
  Json reasons = Json::object();
  const auto add = [&](const char* name, const StartCount& count) {
    json[name] = to_json(count.paths);
    if (!count.paths) reasons[name] = count.missing;
  };
  add("total_degree", counts.total_degree);
  add("multihomogeneous", counts.multihomogeneous);
  add("mixed_volume", counts.mixed_volume);
  if (!reasons.empty()) json["not_computed"] = reasons;
  return json;
}

Json to_json(const StartFacts& start) {
  return {{"kind", to_string(start.source)},
          {"paths", start.paths},
          {"why", start.why},
          {"counts", to_json(start.counts)}};
}

Json reduced_json(const SystemFacts& reduced) {
  Json json{{"variables", reduced.variables.size()}, {"degrees", reduced.degrees}};
  if (reduced.isotropic_pairs > 0) json["isotropic_pairs"] = reduced.isotropic_pairs;
  return json;
}

Json report_head(const std::string& command, const std::string& file) {
  return {{"moivre", std::string(version())}, {"command", command}, {"file", file}};
}

void refill(Json& tree, std::span<const double> numbers) { refilled(tree, numbers.data()); }

const Json& SolutionJson::read(const Solution& solution) {
  Json x = std::move(solution_["x"]);
  if (x.is_null() || x.size() != solution.x.size()) {
    x = to_json(solution.x);
  } else {
    refilled(x, reinterpret_cast<const double*>(solution.x.data()));  // [complex.numbers]: re, im
  }
  solution_ = solution_json(solution, std::move(x));
  return solution_;
}

std::string to_text(const Json& report) {
  return whole_text([&](const TextSink& sink) {
    write_json(sink, [&report](JsonWriter& writer) { writer.members(report); });
  });
}

}  // namespace moivre
