// SPDX-License-Identifier: MIT
// A motion as JSON: the contract of docs/json.md, key by key.
#include "circuits_report.h"
#include "free_motion.h"
#include "moivre/closure_report/motion_report.h"
#include "moivre/closures/idle_joints.h"
#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/pose.h"
#include "moivre/report/json_writer.h"
#include "moivre/report/text_pieces.h"
#include "pose_json.h"
#include "readings_parts.h"
#include "shown_angles.h"

namespace moivre {
namespace {

Json numbers_json(const std::vector<double>& numbers) {
  return list_json(numbers, [](double x) { return to_json(x); });
}

/// {"crank.A": {"position": [x, y], "velocity": ..., "acceleration": ...}}, {} for typed equations;
/// numbers are to be filled in.
Json points_motion_form(const Mechanism& mechanism) {
  const Json vector = Json::array_t(mechanism.space == Space::planar ? 2 : 3);
  Json form = Json::object();
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (const BodyPoint& point : mechanism.bodies[body].points) {
      form[mechanism.bodies[body].name + "." + point.name] = {
          {"position", vector}, {"velocity", vector}, {"acceleration", vector}};
    }
  }
  return form;
}

/// In the order of the form.
std::vector<double> points_motion(const Mechanism& mechanism, const BranchSample& sample) {
  const Eigen::Index axes = mechanism.space == Space::planar ? 2 : 3;
  std::vector<double> numbers;
  for (const PointState& at :
       point_states(mechanism, sample.q, sample.velocity, sample.acceleration)) {
    for (const Eigen::Vector3d* v : {&at.position, &at.velocity, &at.acceleration}) {
      numbers.insert(numbers.end(), v->begin(), v->begin() + axes);
    }
  }
  return numbers;
}

/// Samples of one mechanism, one after another: names are made once, numbers for each sample.
class SampleJson {
 public:
  explicit SampleJson(const Mechanism& mechanism)
      : mechanism_(mechanism),
        sample_{{"t", nullptr},
                {"drivers", Json::array_t(mechanism.drivers.size())},
                {"coordinates", coordinates_form(mechanism)},
                {"velocities", coordinates_form(mechanism)},
                {"accelerations", coordinates_form(mechanism)},
                {"points", points_motion_form(mechanism)},
                {"residual", nullptr},
                {"determined", nullptr}} {}

  /// `q`: the sample's, in the form that is wanted. It stands until the next sample is read.
  Json& read(const BranchSample& sample, const Eigen::VectorXd& q) {
    sample_["t"] = to_json(sample.time);
    refill(sample_["drivers"], driver_values(mechanism_, sample.time));
    refill(sample_["coordinates"], q);
    refill(sample_["velocities"], sample.velocity);
    refill(sample_["accelerations"], sample.acceleration);
    refill(sample_["points"], points_motion(mechanism_, sample));
    sample_["residual"] = to_json(sample.residual);
    sample_["determined"] = sample.is_determined;
    return sample_;
  }

 private:
  const Mechanism& mechanism_;
  Json sample_;
};

Json index_json(const std::optional<std::size_t>& index) {
  return index ? Json(*index) : Json(nullptr);
}

/// What columns a branch has; none where no readings are wanted.
struct BranchColumns {
  const Readings& readings;
  const BranchReadings& of_branch;
};

void write_branch(const MotionBranch& branch, const Mechanism& mechanism, const Phi& phi,
                  const AngleForm& form, const std::optional<BranchColumns>& columns,
                  JsonWriter& report) {
  const Eigen::VectorXd turns = turns_to_begin(mechanism, branch);
  report.member("id", branch.id);
  report.member("begins", to_json(branch.begins));
  report.member("ends", to_json(branch.ends));
  report.member("begin_event", index_json(branch.begin_event));
  report.member("end_event", index_json(branch.end_event));
  report.member("complete", branch.complete);
  report.member("message", branch.message);
  report.member("steps", branch.steps);
  report.member("retracked", branch.retracked);
  SampleJson json(mechanism);
  std::size_t number = 0;
  report.list("samples", branch.samples, [&](const BranchSample& sample) -> const Json& {
    Json& told = json.read(sample, shown(phi, sample, form, turns));
    if (columns) {
      told["columns"] = row_json(columns->readings, columns->of_branch.values[number++], form);
    }
    return told;
  });
  if (!branch.of.empty()) report.member("of", branch.of);
  if (!columns) return;
  report.member("extremes", extremes_json(columns->readings, columns->of_branch, mechanism));
  report.member("time_ratios", time_ratios_json(columns->of_branch));
}

/// How the pose can move on where a branch cannot, though the drivers stand: one such direction, of
/// length 1 (angles in radians, lengths relative to the mechanism's). A joint's limit holds nothing
/// else.
Json free_motion_json(const MotionEvent& event, const Mechanism& mechanism, const Phi& phi) {
  if (event.at.kind == EventKind::joint_limit) return nullptr;
  return coordinates_json(mechanism, free_motion(phi, event.at.q, event.at.time));
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

/// Branches, events, circuits and checkpoints; of the readings where there are any.
void write_course(const MotionResult& result, const Mechanism& mechanism, const AngleForm& form,
                  const Readings* readings, JsonWriter& report) {
  const Phi phi(hold_idle(mechanism).mechanism);
  std::size_t number = 0;
  report.long_list("branches", result.branches, [&](const MotionBranch& branch) {
    std::optional<BranchColumns> columns;
    if (readings != nullptr)
      columns.emplace(BranchColumns{*readings, readings->branches[number++]});
    write_branch(branch, mechanism, phi, form, columns, report);
  });
  report.list("events", result.events,
              [&](const MotionEvent& event) { return event_json(event, mechanism, phi); });
  report.members(circuits_json(find_circuits(mechanism, result), result, mechanism));
  report.list("checkpoints", result.checkpoints, checkpoint_json);
}

}  // namespace

void write_motion_json(const TextSink& sink, const MotionResult& result, const Mechanism& mechanism,
                       const std::string& file, const AngleForm& form, const Readings* readings) {
  write_json(sink, [&](JsonWriter& report) {
    report.members(result_head("motion", file, result, mechanism));
    report.member("from", to_json(result.from));
    report.member("to", to_json(result.to));
    report.member("steps", result.times.empty() ? 0 : result.times.size() - 1);
    report.member("units", units_json(mechanism));
    report.list("drivers", mechanism.drivers, [](const Driver& driver) {
      return Json{{"name", driver.name}, {"kind", to_string(driver.kind)}};
    });
    report.member("tracker", result.tracker.empty()
                                 ? Json(nullptr)
                                 : tracker_json(result.tracker, result.tracker_options));
    report.member("paths", to_json(result.paths));
    write_course(result, mechanism, form, readings, report);
    if (readings != nullptr) report.member("columns", columns_json(*readings));
    report.member("drawn", result.drawn.empty() ? Json(nullptr) : Json(result.drawn));
    report.member("all_listed", result.all_listed);
    report.long_list("sub_chains", result.sub_chains, [&](const MotionSubChain& part) {
      report.member("bodies", part.chain.bodies);
      write_course(part.motion, part.chain.mechanism, form, nullptr, report);
    });
    report.member("failures", result.failures);
    report.member("left_out", to_json(result.left_out));
    report.member("work", {{"steps", result.steps}, {"rejected", result.rejected}});
    report.member("time_s", to_json(result.time_s));
  });
}

std::string motion_json(const MotionResult& result, const Mechanism& mechanism,
                        const std::string& file, const AngleForm& form, const Readings* readings) {
  return whole_text([&](const TextSink& sink) {
    write_motion_json(sink, result, mechanism, file, form, readings);
  });
}

}  // namespace moivre
