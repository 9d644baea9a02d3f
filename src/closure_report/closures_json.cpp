// SPDX-License-Identifier: MIT
// Closures as JSON: the contract of docs/json.md, key by key.
#include "joint_values.h"
#include "moivre/closure_report/closure_report.h"
#include "moivre/report/json_writer.h"
#include "moivre/report/text_pieces.h"
#include "pose_json.h"
#include "sensitivity_json.h"

namespace moivre {
namespace {

Json stage_json(const Stage& stage) {
  return {{"group", stage.group},
          {"paths", stage.paths.tracked},
          {"solves", stage.solves},
          {"finite", stage.paths.finite},
          {"at_infinity", stage.paths.at_infinity},
          {"failed", stage.paths.failed},
          {"not_needed", stage.paths.not_needed},
          {"degrees", stage.reduced.degrees}};
}

Json mobility_summary(const ClosureResult& result) {
  Json json = {{"coordinates", result.coordinates}, {"constraints", result.constraints}};
  if (!result.mobility) {
    json.update({{"rank", nullptr}, {"degrees_of_freedom", nullptr}, {"redundant", nullptr}});
    return json;
  }
  json["rank"] = result.mobility->rank;
  json["degrees_of_freedom"] = result.mobility->degrees_of_freedom;
  json["redundant"] = list_json(result.mobility->redundant,
                                [](const RedundantRow& row) { return Json(to_text(row)); });
  return json;
}

Json moves_json(const std::optional<Moves>& moves, const Mechanism& mechanism) {
  if (!moves) return nullptr;
  return {{"dimension", moves->dimension},
          {"shown", moves->shown},
          {"pose", coordinates_json(mechanism, moves->pose)}};
}

void write_closure(const Closure& closure, const Mechanism& mechanism, PoseJson& pose,
                   JsonWriter& report) {
  report.member("id", closure.id);
  report.members(pose.read(closure.q));
  report.members({{"residual", to_json(closure.residual)},
                  {"misfit", to_json(closure.misfit)},
                  {"fitted", closure.is_fitted},
                  {"play", closure.play ? to_json(*closure.play) : Json(nullptr)},
                  {"newton_iterations", closure.newton_iterations},
                  {"smallest_singular_value", to_json(closure.smallest_singular_value)},
                  {"path", closure.path},
                  {"multiplicity", closure.multiplicity},
                  {"cluster", closure.cluster},
                  {"singular", closure.singular},
                  {"certified", closure.certified ? Json(*closure.certified) : Json()},
                  {"drawn", closure.is_drawn}});
  Json joints = Json::object();
  for (const JointValue& joint : joint_values(mechanism, closure.q)) {
    joints[joint.name] = to_json(joint.value);
  }
  if (!joints.empty()) report.member("joints", joints);
  if (!closure.of.empty()) report.member("of", closure.of);
}

Json counts_json(const ClosureCounts& counts) {
  return {{"complex", counts.complex},
          {"real", counts.real},
          {"filtered", counts.filtered},
          {"rejected", counts.rejected},
          {"fitted", counts.fitted}};
}

void write_sub_chain(const SubChain& part, JsonWriter& report) {
  PoseJson pose(part.chain.mechanism);
  report.member("bodies", part.chain.bodies);
  report.member("counts", counts_json(part.counts));
  report.member("paths", to_json(part.paths));
  report.long_list("closures", part.closures, [&](const Closure& closure) {
    write_closure(closure, part.chain.mechanism, pose, report);
  });
}

void write_closures(const ClosureResult& result, const Mechanism& mechanism,
                    const Sensitivities* sensitivities, JsonWriter& report) {
  PoseJson pose(mechanism);
  std::size_t number = 0;
  report.long_list("closures", result.closures, [&](const Closure& closure) {
    write_closure(closure, mechanism, pose, report);
    if (sensitivities == nullptr) return;
    report.member("sensitivity", sensitivity_json(*sensitivities, number++));
  });
  report.member("all_listed", result.all_listed);
  report.long_list("sub_chains", result.sub_chains,
                   [&](const SubChain& part) { write_sub_chain(part, report); });
  if (sensitivities != nullptr) report.member("dimensions", dimensions_json(*sensitivities));
}

}  // namespace

void write_closures_json(const TextSink& sink, const ClosureResult& result,
                         const Mechanism& mechanism, const std::string& file,
                         const Sensitivities* sensitivities) {
  write_json(sink, [&](JsonWriter& report) {
    report.members(result_head("closures", file, result, mechanism));
    report.member("at", to_json(result.time));
    report.member("units", units_json(mechanism));
    report.member("mobility", mobility_summary(result));
    report.member("system", to_json(result.system));
    report.member("reduced", reduced_json(result.reduced));
    report.member("start", to_json(result.start));
    report.member("tracker", tracker_json(result.tracker, result.tracker_options));
    report.member("paths", to_json(result.paths));
    report.list("stages", result.stages, stage_json);
    report.member("counts", counts_json(result.counts));
    report.member("completeness",
                  result.completeness ? Json(to_string(*result.completeness)) : Json());
    report.member("fit", mechanism.fit ? to_json(*mechanism.fit) : Json(nullptr));
    report.member("least_misfit",
                  result.least_misfit ? to_json(*result.least_misfit) : Json(nullptr));
    report.member("moves", moves_json(result.moves, mechanism));
    write_closures(result, mechanism, sensitivities, report);
    SolutionJson json;
    report.list("solutions", result.solutions,
                [&json](const Solution& solution) -> const Json& { return json.read(solution); });
    report.list("failures", result.failures, [](const FailedPath& f) { return to_json(f); });
    report.member("left_out", to_json(result.left_out));
    report.member("work", work_json(result.work));
    report.member("time_s", to_json(result.time_s));
  });
}

std::string closures_json(const ClosureResult& result, const Mechanism& mechanism,
                          const std::string& file, const Sensitivities* sensitivities) {
  return whole_text([&](const TextSink& sink) {
    write_closures_json(sink, result, mechanism, file, sensitivities);
  });
}

}  // namespace moivre
