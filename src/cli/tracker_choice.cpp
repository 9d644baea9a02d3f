// SPDX-License-Identifier: MIT
// Makes the tracker that was chosen, of those that this program was built with.
#include "tracker_choice.h"

#include <stdexcept>

#include "common_options.h"

#if MOIVRE_WITH_CVODE
#include "moivre/tracker_cvode/cvode_tracker.h"
#endif
#if MOIVRE_WITH_LANES
#include "moivre/tracker_lanes/lane_tracker.h"
#endif

namespace moivre {
namespace {

#if MOIVRE_WITH_CVODE
void take_defaults_of_cvode(TrackerChoice& choice) {
  const CvodeOptions options;
  choice.kind = "cvode";
  choice.rtol = options.rtol;
  choice.maximum_steps = options.maximum_steps;
}

CvodeMethod cvode_method(const std::string& name) {
  for (const CvodeMethod method :
       {CvodeMethod::bdf_projection, CvodeMethod::bdf, CvodeMethod::adams}) {
    if (name == to_string(method)) return method;
  }
  if (name == "adams_projection") {
    throw std::invalid_argument(
        "--method adams_projection: CVODE projects with BDF only (\"CVodeSetProjFn: projection is "
        "only supported with BDF\"); take bdf_projection, or adams without projection");
  }
  throw std::invalid_argument("--method " + name +
                              ": the methods are bdf_projection, bdf and adams");
}

CvodeIteration cvode_iteration(const std::string& name) {
  for (const CvodeIteration iteration : {CvodeIteration::fixed_point, CvodeIteration::newton}) {
    if (name == to_string(iteration)) return iteration;
  }
  throw std::invalid_argument("--iteration " + name +
                              ": the iterations are fixed_point and newton");
}

std::unique_ptr<Tracker> make_cvode(const TrackerChoice& choice) {
  CvodeOptions options;
  options.rtol = choice.rtol;
  options.maximum_steps = choice.maximum_steps;
  std::unique_ptr<Tracker> tracker;
  require_all({[&] { options.method = cvode_method(choice.method); },
               [&] { options.iteration = cvode_iteration(choice.iteration); },
               [&] { tracker = make_cvode_tracker(options); }});
  return tracker;
}
#else
void take_defaults_of_cvode(TrackerChoice&) {}

std::unique_ptr<Tracker> make_cvode(const TrackerChoice&) {
  throw std::invalid_argument("--tracker cvode: this program was built without the CVODE tracker");
}
#endif

#if MOIVRE_WITH_LANES
void take_defaults_of_lanes(TrackerChoice& choice) {
  const LaneOptions options;
  choice.kind = "lanes";
  choice.tolerance = options.tolerance;
  choice.maximum_steps = options.maximum_steps;
}

LanePredictor lane_predictor(const std::string& name) {
  for (const LanePredictor predictor :
       {LanePredictor::tangent, LanePredictor::cubic, LanePredictor::quintic}) {
    if (name == to_string(predictor)) return predictor;
  }
  throw std::invalid_argument("--predictor " + name +
                              ": the predictors are tangent, cubic and quintic");
}

std::unique_ptr<Tracker> make_lanes(const TrackerChoice& choice) {
  LaneOptions options;
  options.predictor = lane_predictor(choice.predictor);
  options.tolerance = choice.tolerance;
  options.maximum_steps = choice.maximum_steps;
  return make_lane_tracker(options);
}
#else
void take_defaults_of_lanes(TrackerChoice&) {}

std::unique_ptr<Tracker> make_lanes(const TrackerChoice&) {
  throw std::invalid_argument("--tracker lanes: this program was built without the lane tracker");
}
#endif

}  // namespace

TrackerChoice::TrackerChoice() {
  take_defaults_of_lanes(*this);
  take_defaults_of_cvode(*this);
}

void add_tracker_options(CLI::App& command, TrackerChoice& choice) {
  const std::string group = "Tracker";
  command.add_option("--tracker", choice.kind, "cvode or lanes")
      ->capture_default_str()
      ->group(group);
  command.add_option("--method", choice.method, "cvode: bdf_projection, bdf or adams")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--iteration", choice.iteration,
                  "cvode: fixed_point, or newton with a Jacobian by difference quotients")
      ->capture_default_str()
      ->group(group);
  command.add_option("--rtol", choice.rtol, "cvode: relative local error of a step")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--tolerance", choice.tolerance,
                  "lanes: relative size of Newton's first correction that steps aim at")
      ->each([&choice](const std::string&) { choice.of_lanes.emplace_back("--tolerance"); })
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--predictor", choice.predictor,
                  "lanes: tangent, cubic or quintic, through one, two or three points and tangents")
      ->each([&choice](const std::string&) { choice.of_lanes.emplace_back("--predictor"); })
      ->capture_default_str()
      ->group(group);
  command.add_option("--max-steps", choice.maximum_steps, "steps of one path segment")
      ->capture_default_str()
      ->group(group);
}

std::unique_ptr<Tracker> make_tracker(const TrackerChoice& choice, bool has_witness) {
  if (choice.kind == "cvode" && !has_witness && !choice.of_lanes.empty()) {
    throw std::invalid_argument(choice.of_lanes.front() +
                                ": only the lanes take it (--tracker lanes)");
  }
  if (choice.kind == "cvode") return make_cvode(choice);
  if (choice.kind == "lanes") return make_lanes(choice);
  throw std::invalid_argument("--tracker " + choice.kind + ": the trackers are cvode and lanes");
}

std::unique_ptr<Tracker> make_fallback(const TrackerChoice& choice) {
  return MOIVRE_WITH_CVODE && choice.kind == "lanes" ? make_cvode(choice) : nullptr;
}

std::unique_ptr<Tracker> make_witness(const TrackerChoice& choice) {
  return choice.kind == "lanes" ? make_cvode(choice) : make_lanes(choice);
}

}  // namespace moivre
