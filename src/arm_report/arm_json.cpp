// SPDX-License-Identifier: MIT
// Inverse kinematics as JSON: the contract of docs/json.md, key by key.
#include <algorithm>

#include "moivre/arm_report/arm_report.h"
#include "moivre/arms/posture.h"
#include "moivre/arms/turns.h"
#include "moivre/report/json.h"
#include "moivre/report/json_writer.h"
#include "moivre/report/text_pieces.h"

namespace moivre {
namespace {

Json values_json(const Arm& arm, const Eigen::VectorXd& values) {
  Json json = Json::object();
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    json[arm.joints[k].name] = to_json(values[static_cast<Eigen::Index>(k)]);
  }
  return json;
}

Json joint_json(const ArmJoint& joint) {
  const std::string turn = joint.limits ? "revolute" : "continuous";
  const Json limits = joint.limits
                          ? Json{to_json(joint.limits->lower), to_json(joint.limits->upper)}
                          : Json(nullptr);
  return {{"name", joint.name}, {"type", joint.is_slide ? "prismatic" : turn}, {"limits", limits}};
}

Json pose_json(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  const Eigen::Vector3d t = pose.translation();
  Json json = Json::array();
  for (const double x : {t.x(), t.y(), t.z(), q.w(), q.x(), q.y(), q.z()}) {
    json.push_back(to_json(x));
  }
  return json;
}

Json word(const std::optional<bool>& is_so, const char* yes, const char* no) {
  return is_so ? Json(*is_so ? yes : no) : Json(nullptr);
}

Json posture_json(const Posture& posture) {
  return {{"shoulder", word(posture.is_right, "right", "left")},
          {"elbow", word(posture.is_up, "up", "down")},
          {"wrist", word(posture.is_flipped, "flip", "no flip")}};
}

/// x y z in metres, then the rotation in radians.
Json twist_json(const Twist& twist) {
  Json json = Json::array();
  for (const double x : twist.translation) json.push_back(to_json(x));
  for (const double x : twist.rotation) json.push_back(to_json(x));
  return json;
}

Json closure_json(const ArmClosure& closure, const Arm& arm, const ArmReport& report) {
  Json json = {{"id", closure.id},
               {"coordinates", values_json(arm, closure.values)},
               {"in_limits", values_json(arm, closure.in_limits)},
               {"within_limits", closure.beyond.empty()},
               {"beyond_limits",
                list_json(closure.beyond, [&](std::size_t k) { return Json(arm.joints[k].name); })},
               {"posture", posture_json(posture_of(arm, closure.values))},
               {"residual", to_json(closure.residual)},
               {"newton_iterations", closure.newton_iterations},
               {"smallest_singular_value", to_json(closure.smallest_singular_value)},
               {"weakest",
                {{"joints", values_json(arm, closure.weakest.joints)},
                 {"tip", twist_json(closure.weakest.tip)}}},
               {"path", closure.path},
               {"multiplicity", closure.multiplicity},
               {"singular", closure.singular},
               {"moved_by_digits", to_json(closure.moved_by_digits)},
               {"within_digits", closure.within_digits}};
  if (report.stands) {
    json["distance"] = to_json(distance_from(arm, closure.in_limits, *report.stands));
  }
  if (report.has_all_turns) {
    json["turns"] = list_json(all_turns(arm, closure.in_limits),
                              [&](const Eigen::VectorXd& x) { return values_json(arm, x); });
  }
  return json;
}

Json relation_json(const JointRelation& relation, const Arm& arm) {
  Json factors = Json::object();
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const double factor = relation.factors[static_cast<Eigen::Index>(k)];
    if (factor != 0) factors[arm.joints[k].name] = to_json(factor);
  }
  return {{"factors", factors}, {"value", to_json(relation.value)}};
}

Json sample_json(const Eigen::VectorXd& sample, const Arm& arm) {
  Eigen::VectorXd values = sample;
  const bool is_within = place_in_limits(arm, values).empty();
  return {{"coordinates", values_json(arm, values)}, {"within_limits", is_within}};
}

Json moves_json(const SelfMotion& set, const Arm& arm) {
  Eigen::VectorXd placed = set.values;
  place_in_limits(arm, placed);
  Json directions = Json::array();
  for (Eigen::Index k = 0; k < set.directions.cols(); ++k) {
    directions.push_back(values_json(arm, set.directions.col(k)));
  }
  return {{"pose", values_json(arm, placed)},
          {"tangent", directions.front()},
          {"lost", twist_json(set.lost)},
          {"dimension", set.dimension},
          {"directions", directions},
          {"relations",
           list_json(set.relations, [&](const JointRelation& r) { return relation_json(r, arm); })},
          {"closes", set.closes},
          {"misfit", to_json(set.misfit)},
          {"within_digits", set.within_digits},
          {"samples",
           list_json(set.samples, [&](const Eigen::VectorXd& x) { return sample_json(x, arm); })}};
}

Json stage_json(const ArmStage& stage) {
  return {{"group", stage.group},
          {"paths", stage.paths.tracked},
          {"solves", stage.solves},
          {"finite", stage.paths.finite},
          {"at_infinity", stage.paths.at_infinity},
          {"failed", stage.paths.failed},
          {"not_needed", stage.paths.not_needed}};
}

/// What differs from pose to pose, but the time.
void add_result(const ArmResult& result, const Arm& arm, const ArmReport& report, Json& json) {
  json["complete"] = result.complete;
  json["message"] = result.message;
  json["target"] = pose_json(result.pose);
  json["accuracy"] = to_json(result.accuracy);
  json["start"] = to_json(result.start);
  json["paths"] = to_json(result.paths);
  json["stages"] = list_json(result.stages, stage_json);
  json["counts"] = {{"complex", result.counts.complex},
                    {"real", result.counts.real},
                    {"filtered", 0},
                    {"beyond_limits", result.counts.beyond_limits},
                    {"rejected", result.counts.rejected}};
  json["moves"] = nullptr;
  if (!result.moves.empty()) {
    json["moves"] =
        list_json(result.moves, [&](const SelfMotion& m) { return moves_json(m, arm); });
  }
  json["nearest"] = nullptr;
  if (result.nearest) {
    json["nearest"] = {{"coordinates", values_json(arm, result.nearest->values)},
                       {"misfit", to_json(result.nearest->misfit)},
                       {"position", to_json(result.nearest->apart.position)},
                       {"rotation", to_json(result.nearest->apart.rotation)}};
  }
  json["closures"] =
      list_json(result.closures, [&](const ArmClosure& c) { return closure_json(c, arm, report); });
  json["failures"] = list_json(result.failures, [](const FailedPath& f) { return to_json(f); });
  json["left_out"] = to_json(result.left_out);
}

Json pose_of_list(const ArmReport& report, std::size_t k) {
  Json pose = {{"pose", k}};
  if (const auto swept = swept_joint(report, k)) {
    pose["held"] = {{swept->name, to_json(swept->value)}};
  }
  add_result(report.results[k], arm_of(report, k), report, pose);
  return pose;
}

}  // namespace

const Arm& arm_of(const ArmReport& report, std::size_t k) {
  return report.swept.empty() ? report.arm : report.swept.at(k);
}

std::optional<HeldJoint> swept_joint(const ArmReport& report, std::size_t k) {
  if (report.swept.empty()) return std::nullopt;
  return report.swept.at(k).held.back();
}

bool is_complete(const ArmReport& report) {
  return std::all_of(report.results.begin(), report.results.end(),
                     [](const ArmResult& result) { return result.complete; });
}

void write_arm_json(const TextSink& sink, const ArmReport& report) {
  const Arm& arm = report.arm;
  const ArmResult first = report.results.empty() ? ArmResult{} : report.results.front();
  Json held = Json::object();
  for (const HeldJoint& joint : arm.held) held[joint.name] = to_json(joint.value);
  if (const auto swept = swept_joint(report, 0)) held.erase(swept->name);
  StepCount work;
  SolveTime time;
  for (const ArmResult& result : report.results) {
    work += result.work;
    time.start += result.time_s.start;
    time.track += result.time_s.track;
    time.track_cpu += result.time_s.track_cpu;
    time.refine += result.time_s.refine;
  }
  time.threads = first.time_s.threads;
  time.parse = report.parse_s;
  time.total = report.total_s;
  write_json(sink, [&](JsonWriter& json) {
    json.members(report_head("closures", report.file));
    json.member("seed", first.seed);
    json.member("robot", arm.robot);
    json.member("base", arm.base);
    json.member("tip", arm.tip);
    json.member("joints", list_json(arm.joints, joint_json));
    json.member("held", held);
    json.member("units", {{"length", "m"}, {"angle", "rad"}});
    json.member("tracker", tracker_json(first.tracker, first.tracker_options));
    if (report.is_list) {
      json.member("complete", is_complete(report));
      std::size_t number = 0;
      json.list("poses", report.results,
                [&](const ArmResult&) { return pose_of_list(report, number++); });
    } else {
      Json result = Json::object();
      add_result(first, arm, report, result);
      json.members(result);
    }
    json.member("work", work_json(work));
    json.member("time_s", to_json(time));
  });
}

std::string arm_json(const ArmReport& report) {
  return whole_text([&](const TextSink& sink) { write_arm_json(sink, report); });
}

}  // namespace moivre
