// SPDX-License-Identifier: MIT
// moivre mobility FILE: degrees of freedom, redundant rows by name, directions of motion, at an
// assembled pose.
#include <memory>
#include <optional>

#include "command.h"
#include "common_options.h"
#include "interruption.h"
#include "mechanism_input.h"
#include "moivre/closure_report/kinematics_report.h"
#include "moivre/closures/mobility_kinds.h"
#include "output.h"
#include "tracker_choice.h"

namespace moivre {
namespace {

struct MobilityCommand {
  std::string file;
  GuessChoice guess;
  MechanismChoice mechanism;
  bool quiet = false;
  std::string json;
};

int run(const MobilityCommand& command) {
  require_distinct({command.json}, command.file);
  Mechanism mechanism = read_any_mechanism(command.file);
  apply(command.mechanism, mechanism);
  Output json(command.json);
  std::optional<Eigen::VectorXd> guess;
  const Eigen::VectorXd chosen = chosen_guess(mechanism, command.guess);
  if (!command.guess.guesses.empty()) guess = chosen;
  const std::unique_ptr<Tracker> tracker = make_tracker({});
  const Interruption interruption;
  const FoundMobility found =
      find_mobility(mechanism, *tracker, command.guess.at, guess, interruption.stop());
  const KinematicsHeading heading{command.file, command.guess.at, found.kinds};
  deliver({{&json, [&] { return mobility_json(found.mobility, found.pose, mechanism, heading); }}},
          command.quiet,
          [&] { return mobility_text(found.mobility, found.pose, mechanism, heading); });
  return is_taken(found.mobility, found.pose) ? kDecided : kUndecided;
}

}  // namespace

void add_mobility_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<MobilityCommand>();
  CLI::App& app = *moivre.add_subcommand("mobility",
                                         "Find degrees of freedom and redundant constraints: at "
                                         "the closures, or at the pose found from a guess");
  add_any_file(app, command->file);
  add_guess_options(app, command->guess);
  add_mechanism_options(app, command->mechanism);
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  add_examples(app, {"moivre mobility double-parallel-crank.toml",
                     "moivre mobility four-bar.toml --guess rocker.phi=-98",
                     "moivre mobility rounded.toml --fit 0.01",
                     "moivre mobility four-bar.toml --json - | jq .redundant"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
