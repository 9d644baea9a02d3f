// SPDX-License-Identifier: MIT
// moivre newton FILE: one Newton-Raphson run from a guess, iteration by iteration.
#include <memory>

#include "command.h"
#include "common_options.h"
#include "mechanism_input.h"
#include "moivre/closure_report/kinematics_report.h"
#include "output.h"

namespace moivre {
namespace {

struct NewtonCommand {
  std::string file;
  GuessChoice guess;
  std::vector<std::string> weights;
  NewtonOptions options;
  AngleForm angles;
  bool quiet = false;
  std::string json;
  std::string csv;
};

int run(const NewtonCommand& command) {
  require_distinct({command.json, command.csv}, command.file);
  const Mechanism mechanism = read_any_mechanism(command.file);
  const Phi phi(mechanism);
  NewtonOptions options = command.options;
  options.with_condition = true;
  if (!command.weights.empty()) {
    options.linear.weights = named_values(
        mechanism, command.weights, Eigen::VectorXd::Ones(phi.dimension()), AngleUnit::radians);
  }
  Output json(command.json);
  Output csv(command.csv);
  const NewtonResult result =
      newton(phi, chosen_guess(mechanism, command.guess), command.guess.at, options);
  const KinematicsHeading heading{command.file, command.guess.at, {}};
  deliver({{&json, [&] { return newton_json(result, mechanism, heading); }},
           {&csv, [&] { return newton_csv(result, mechanism, command.angles); }}},
          command.quiet, [&] { return newton_text(result, mechanism, heading); });
  return result.status == NewtonStatus::converged ? kDecided : kUndecided;
}

}  // namespace

void add_newton_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<NewtonCommand>();
  CLI::App& app = *moivre.add_subcommand(
      "newton", "Run Newton-Raphson from a guess; exit code 2 if it does not converge");
  add_any_file(app, command->file);
  add_guess_options(app, command->guess);
  app.add_option("--weight", command->weights,
                 "weight of a coordinate in minimum-norm steps; may be repeated")
      ->type_name("NAME=VALUE");
  app.add_option("--tolerance", command->options.residual_tolerance,
                 "tolerance on |Phi_i|, relative to the sum of the magnitudes of its terms")
      ->capture_default_str();
  app.add_option("--max-iterations", command->options.maximum_iterations, "limit on the iterations")
      ->capture_default_str();
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  app.add_option("--csv", command->csv, "write the table of iterates here")->type_name("PATH");
  add_angles_option(app, command->angles);
  add_examples(app, {"moivre newton four-bar.toml",
                     "moivre newton four-bar.toml --guess coupler.phi=-60 --guess rocker.phi=-90",
                     "moivre newton square-root.phc --guess x=10 --csv -",
                     "moivre newton sphere.phc --guess x=2 --weight y=2 --weight z=4"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
