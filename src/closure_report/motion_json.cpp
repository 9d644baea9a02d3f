// SPDX-License-Identifier: MIT
// A motion as JSON: the contract of docs/json.md, key by key.
#include "circuits_report.h"
#include "moivre/closure_report/motion_report.h"
#include "moivre/closures/idle_joints.h"
#include "moivre/kinematics/null_space.h"
#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/pose.h"
#include "pose_json.h"
#include "readings_parts.h"
#include "shown_angles.h"

namespace moivre {
namespace {

Json numbers_json(const std::vector<double>& numbers) {
  return list_json(numbers, [](double x) { return to_json(x); });
}

Json vector_json(const Mechanism& mechanism, const Eigen::Vector3d& v) {
  Json json = Json::array({to_json(v.x()), to_json(v.y())});
  if (mechanism.space == Space::spatial) json.push_back(to_json(v.z()));
  return json;
}

/// {"crank.A": {"position": [x, y], "velocity": ..., "acceleration": ...}}, {} for typed equations.
Json points_motion_json(const Mechanism& mechanism, const BranchSample& sample) {
  Json json = Json::object();
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
      const PointState at =
          point_state(mechanism, {body, k}, sample.q, sample.velocity, sample.acceleration);
      json[mechanism.bodies[body].name + "." + mechanism.bodies[body].points[k].name] = {
          {"position", vector_json(mechanism, at.position)},
          {"velocity", vector_json(mechanism, at.velocity)},
          {"acceleration", vector_json(mechanism, at.acceleration)}};
    }
  }
  return json;
}

/// `q`: the sample's, in the form that is wanted.
Json sample_json(const BranchSample& sample, const Eigen::VectorXd& q, const Mechanism& mechanism) {
  return {{"t", to_json(sample.time)},
          {"drivers", numbers_json(driver_values(mechanism, sample.time))},
          {"coordinates", coordinates_json(mechanism, q)},
          {"velocities", coordinates_json(mechanism, sample.velocity)},
          {"accelerations", coordinates_json(mechanism, sample.acceleration)},
          {"points", points_motion_json(mechanism, sample)},
          {"residual", to_json(sample.residual)},
          {"determined", sample.is_determined}};
}

Json index_json(const std::optional<std::size_t>& index) {
  return index ? Json(*index) : Json(nullptr);
}

Json branch_json(const MotionBranch& branch, const Mechanism& mechanism, const Phi& phi,
                 const AngleForm& form) {
  const Eigen::VectorXd turns = turns_to_begin(mechanism, branch);
  Json json{{"id", branch.id},
            {"begins", to_json(branch.begins)},
            {"ends", to_json(branch.ends)},
            {"begin_event", index_json(branch.begin_event)},
            {"end_event", index_json(branch.end_event)},
            {"complete", branch.complete},
            {"message", branch.message},
            {"steps", branch.steps},
            {"retracked", branch.retracked},
            {"samples", list_json(branch.samples, [&](const BranchSample& sample) {
               return sample_json(sample, shown(phi, sample, form, turns), mechanism);
             })}};
  if (!branch.of.empty()) json["of"] = branch.of;
  return json;
}

/// How the pose can move on where a branch cannot, though the drivers stand: one such direction, of length 1 (angles in radians,
/// lengths beside the mechanism's). A joint's limit holds nothing else.
Json free_motion_json(const MotionEvent& event, const Mechanism& mechanism, const Phi& phi) {
  if (event.at.kind == EventKind::joint_limit) return nullptr;
  const auto& all = phi.coordinates();
  Eigen::VectorXd scale(phi.dimension());
  for (Eigen::Index k = 0; k < scale.size(); ++k) {
    const bool is_length = all[static_cast<std::size_t>(k)].kind == CoordinateKind::length;
    scale[k] = is_length ? phi.length() : 1;
  }
  const Eigen::VectorXd direction =
      shortest_direction(phi.jacobian(event.at.q, event.at.time) * scale.asDiagonal());
  return coordinates_json(mechanism, direction.cwiseProduct(scale));
}

Json event_json(const MotionEvent& event, const Mechanism& mechanism, const Phi& phi) {
  return {{"kind", to_string(event.at.kind)},
          {"t", to_json(event.at.time)},
          {"uncertainty", to_json(event.at.uncertainty)},
          {"drivers", numbers_json(event.drivers)},
          {"joint", event.at.joint.empty() ? Json(nullptr) : Json(event.at.joint)},
          {"ending", event.ending},
          {"beginning", event.beginning},
          {"coordinates", coordinates_json(mechanism, phi.canonical(event.at.q))},
          {"free_motion", free_motion_json(event, mechanism, phi)}};
}

Json checkpoint_json(const Checkpoint& checkpoint) {
  return {{"t", to_json(checkpoint.time)},
          {"drivers", numbers_json(checkpoint.drivers)},
          {"counts",
           {{"complex", checkpoint.counts.complex},
            {"real", checkpoint.counts.real},
            {"filtered", checkpoint.counts.filtered},
            {"fitted", checkpoint.counts.fitted}}},
          {"branches", checkpoint.branches},
          {"agrees", checkpoint.agrees},
          {"message", checkpoint.message}};
}

/// Branches, events, circuits and checkpoints.
void add_course(const MotionResult& result, const Mechanism& mechanism, const AngleForm& form,
                Json& report) {
  const Phi phi(hold_idle(mechanism).mechanism);
  report["branches"] = list_json(result.branches, [&](const MotionBranch& branch) {
    return branch_json(branch, mechanism, phi, form);
  });
  report["events"] = list_json(
      result.events, [&](const MotionEvent& event) { return event_json(event, mechanism, phi); });
  add_circuits(find_circuits(mechanism, result), result, mechanism, report);
  report["checkpoints"] = list_json(result.checkpoints, checkpoint_json);
}

Json part_json(const MotionSubChain& part, const AngleForm& form) {
  Json json{{"bodies", part.chain.bodies}};
  add_course(part.motion, part.chain.mechanism, form, json);
  return json;
}

/// Into the branches, and of each into its samples.
void add_readings(const Readings& readings, const Mechanism& mechanism, const AngleForm& form,
                  Json& report) {
  report["columns"] = columns_json(readings);
  for (std::size_t b = 0; b < readings.branches.size(); ++b) {
    const BranchReadings& from = readings.branches[b];
    Json& branch = report["branches"][b];
    for (std::size_t j = 0; j < from.values.size(); ++j) {
      branch["samples"][j]["columns"] = row_json(readings, from.values[j], form);
    }
    branch["extremes"] = extremes_json(readings, from, mechanism);
    branch["time_ratios"] = time_ratios_json(from);
  }
}

}  // namespace

std::string motion_json(const MotionResult& result, const Mechanism& mechanism,
                        const std::string& file, const AngleForm& form, const Readings* readings) {
  Json report = report_head("motion", file);
  report["seed"] = result.seed;
  report["complete"] = result.complete;
  report["message"] = result.message;
  report["title"] = mechanism.title;
  report["idle"] = idle_json(result.idle);
  report["warnings"] = mechanism.warnings;
  report["from"] = to_json(result.from);
  report["to"] = to_json(result.to);
  report["steps"] = result.times.empty() ? 0 : result.times.size() - 1;
  report["units"] = units_json(mechanism);
  report["drivers"] = list_json(mechanism.drivers, [](const Driver& driver) {
    return Json{{"name", driver.name}, {"kind", to_string(driver.kind)}};
  });
  report["tracker"] =
      result.tracker.empty() ? Json(nullptr) : tracker_json(result.tracker, result.tracker_options);
  report["paths"] = to_json(result.paths);
  add_course(result, mechanism, form, report);
  if (readings != nullptr) add_readings(*readings, mechanism, form, report);
  report["all_listed"] = result.all_listed;
  report["sub_chains"] = list_json(
      result.sub_chains, [&](const MotionSubChain& part) { return part_json(part, form); });
  report["failures"] = result.failures;
  report["left_out"] = to_json(result.left_out);
  report["work"] = {{"steps", result.steps}, {"rejected", result.rejected}};
  report["time_s"] = to_json(result.time_s);
  return to_text(report);
}

}  // namespace moivre
