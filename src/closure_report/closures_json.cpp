// SPDX-License-Identifier: MIT
// Closures as JSON: the contract of docs/json.md, key by key.
#include "joint_values.h"
#include "moivre/closure_report/closure_report.h"
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

Json closure_json(const Closure& closure, const Mechanism& mechanism) {
  Json joints = Json::object();
  for (const JointValue& joint : joint_values(mechanism, closure.q)) {
    joints[joint.name] = to_json(joint.value);
  }
  Json json{{"id", closure.id},
            {"coordinates", coordinates_json(mechanism, closure.q)},
            {"bodies", bodies_json(mechanism, closure.q)},
            {"points", points_json(mechanism, closure.q)},
            {"residual", to_json(closure.residual)},
            {"misfit", to_json(closure.misfit)},
            {"fitted", closure.is_fitted},
            {"newton_iterations", closure.newton_iterations},
            {"smallest_singular_value", to_json(closure.smallest_singular_value)},
            {"path", closure.path},
            {"multiplicity", closure.multiplicity},
            {"singular", closure.singular},
            {"certified", closure.certified ? Json(*closure.certified) : Json()}};
  if (!joints.empty()) json["joints"] = std::move(joints);
  if (!closure.of.empty()) json["of"] = closure.of;
  return json;
}

Json counts_json(const ClosureCounts& counts) {
  return {{"complex", counts.complex},
          {"real", counts.real},
          {"filtered", counts.filtered},
          {"rejected", counts.rejected},
          {"fitted", counts.fitted}};
}

Json sub_chain_json(const SubChain& part) {
  return {{"bodies", part.chain.bodies},
          {"counts", counts_json(part.counts)},
          {"paths", to_json(part.paths)},
          {"closures", list_json(part.closures, [&](const Closure& closure) {
             return closure_json(closure, part.chain.mechanism);
           })}};
}

}  // namespace

std::string closures_json(const ClosureResult& result, const Mechanism& mechanism,
                          const std::string& file, const Sensitivities* sensitivities) {
  Json report = report_head("closures", file);
  report["seed"] = result.seed;
  report["complete"] = result.complete;
  report["message"] = result.message;
  report["title"] = mechanism.title;
  report["idle"] = idle_json(result.idle);
  report["warnings"] = mechanism.warnings;
  report["at"] = to_json(result.time);
  report["units"] = units_json(mechanism);
  report["mobility"] = mobility_summary(result);
  report["system"] = to_json(result.system);
  report["reduced"] = reduced_json(result.reduced);
  report["start"] = to_json(result.start);
  report["tracker"] = tracker_json(result.tracker, result.tracker_options);
  report["paths"] = to_json(result.paths);
  report["stages"] = list_json(result.stages, stage_json);
  report["counts"] = counts_json(result.counts);
  report["completeness"] = result.completeness ? Json(to_string(*result.completeness)) : Json();
  report["fit"] = mechanism.fit ? to_json(*mechanism.fit) : Json(nullptr);
  report["least_misfit"] = result.least_misfit ? to_json(*result.least_misfit) : Json(nullptr);
  report["moves"] = moves_json(result.moves, mechanism);
  report["closures"] = list_json(
      result.closures, [&](const Closure& closure) { return closure_json(closure, mechanism); });
  report["all_listed"] = result.all_listed;
  report["sub_chains"] = list_json(result.sub_chains, sub_chain_json);
  if (sensitivities != nullptr) {
    report["dimensions"] = dimensions_json(*sensitivities);
    for (std::size_t k = 0; k < result.closures.size(); ++k) {
      report["closures"][k]["sensitivity"] = sensitivity_json(*sensitivities, k);
    }
  }
  report["solutions"] = list_json(result.solutions, [](const Solution& s) { return to_json(s); });
  report["failures"] = list_json(result.failures, [](const FailedPath& f) { return to_json(f); });
  report["left_out"] = to_json(result.left_out);
  report["work"] = work_json(result.work);
  report["time_s"] = to_json(result.time_s);
  return to_text(report);
}

}  // namespace moivre
