// SPDX-License-Identifier: MIT
// moivre mobility FILE: degrees of freedom, redundant rows by name, directions of motion, at an assembled pose.
#include <memory>

#include "command.h"
#include "common_options.h"
#include "mechanism_input.h"
#include "moivre/closure_report/kinematics_report.h"
#include "output.h"

namespace moivre {
namespace {

struct MobilityCommand {
  std::string file;
  GuessChoice guess;
  bool quiet = false;
  std::string json;
};

int run(const MobilityCommand& command) {
  require_distinct({command.json}, command.file);
  const Mechanism mechanism = read_any_mechanism(command.file);
  Output json(command.json);
  const Phi phi(mechanism);
  const double t = command.guess.at;
  const NewtonResult pose = newton(phi, chosen_guess(mechanism, command.guess), t);
  const Mobility result = mobility(phi, pose.q, t);
  const KinematicsHeading heading{command.file, t};
  deliver({{&json, [&] { return mobility_json(result, pose, mechanism, heading); }}}, command.quiet,
          [&] { return mobility_text(result, pose, mechanism, heading); });
  return pose.status == NewtonStatus::converged ? kDecided : kUndecided;
}

}  // namespace

void add_mobility_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<MobilityCommand>();
  CLI::App& app =
      *moivre.add_subcommand("mobility",
                             "Tell degrees of freedom and redundant constraints, at the pose that "
                             "Newton-Raphson finds from a guess");
  add_any_file(app, command->file);
  add_guess_options(app, command->guess);
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  add_examples(app, {"moivre mobility double-parallel-crank.toml",
                     "moivre mobility four-bar.toml --guess rocker.phi=-98",
                     "moivre mobility four-bar.toml --json - | jq .redundant"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
