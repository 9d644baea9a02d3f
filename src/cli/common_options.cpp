// SPDX-License-Identifier: MIT
// The shared options, and the tracker that they describe.
#include "common_options.h"

#include <stdexcept>

#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

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

}  // namespace

void add_file(CLI::App& command, std::string& file) {
  command.add_option("FILE", file, "polynomial system, in PHCpack's or Bertini's text form")
      ->required();
}

TrackerChoice::TrackerChoice()
    : rtol(CvodeOptions{}.rtol), maximum_steps(CvodeOptions{}.maximum_steps) {}

void add_tracker_options(CLI::App& command, TrackerChoice& choice) {
  const std::string group = "Tracker";
  command.add_option("--tracker", choice.kind, "cvode or lanes")
      ->capture_default_str()
      ->group(group);
  command.add_option("--method", choice.method, "cvode: bdf_projection, bdf or adams")
      ->capture_default_str()
      ->group(group);
  command.add_option("--rtol", choice.rtol, "cvode: relative local error of a step")
      ->capture_default_str()
      ->group(group);
  command.add_option("--max-steps", choice.maximum_steps, "cvode: steps of one journey")
      ->capture_default_str()
      ->group(group);
}

std::unique_ptr<Tracker> make_tracker(const TrackerChoice& choice) {
  if (choice.kind == "lanes") {
    throw std::invalid_argument(
        "--tracker lanes: this program was built without the lane tracker; take --tracker cvode");
  }
  if (choice.kind != "cvode") {
    throw std::invalid_argument("--tracker " + choice.kind + ": the trackers are cvode and lanes");
  }
  CvodeOptions options;
  options.method = cvode_method(choice.method);
  options.rtol = choice.rtol;
  options.maximum_steps = choice.maximum_steps;
  return make_cvode_tracker(options);
}

void add_start_options(CLI::App& command, StartChoice& choice) {
  command.add_option("--start", choice.kind, "start system: total-degree")->capture_default_str();
  command.add_option("--seed", choice.seed, "of the random numbers in the start system")
      ->check(CLI::Validator(not_negative, ""))
      ->capture_default_str();
}

void require_known(const StartChoice& choice) {
  if (choice.kind == "total-degree") return;
  throw std::invalid_argument("--start " + choice.kind + ": the start system is total-degree");
}

void add_json_option(CLI::App& command, std::string& path) {
  command.add_option("--json", path, "write JSON here; - is standard output")->type_name("PATH");
}

void add_quiet_flag(CLI::App& command, bool& quiet) {
  command.add_flag("--quiet", quiet, "print no text and no progress line");
}

std::string not_negative(const std::string& number) {
  return number.find('-') == std::string::npos ? "" : number + " is negative";
}

void add_examples(CLI::App& command, const std::vector<std::string>& examples) {
  std::string text = "Examples:\n";
  for (const std::string& example : examples) text += "  " + example + '\n';
  command.footer(text);
}

}  // namespace moivre
