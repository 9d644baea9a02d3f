// SPDX-License-Identifier: MIT
// moivre mobility FILE: degrees of freedom, redundant rows by name, directions of motion, at an assembled pose.
#include <memory>
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "interruption.h"
#include "mechanism_input.h"
#include "moivre/closure_report/kinematics_report.h"
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

/// Kinds of the closures, where there is no guess to take and closures can be found; else nothing.
std::vector<MobilityKind> kinds_of(const Mechanism& mechanism, const MobilityCommand& command) {
  const bool has_guess = !command.guess.guesses.empty() || !mechanism.guess.empty();
  if (has_guess || mechanism.space == Space::spatial) return {};
  const std::unique_ptr<Tracker> tracker = make_tracker({});
  ClosureOptions options;
  options.time = command.guess.at;
  options.certify = false;
  const Interruption interruption;
  try {
    return mobility_kinds(mechanism,
                          find_closures(mechanism, *tracker, options, interruption.stop()));
  } catch (const std::invalid_argument&) {
    return {};  // equations that are no polynomials have Newton-Raphson's pose
  }
}

int run(const MobilityCommand& command) {
  require_distinct({command.json}, command.file);
  Mechanism mechanism = read_any_mechanism(command.file);
  apply(command.mechanism, mechanism);
  Output json(command.json);
  const Phi phi(mechanism);
  const double t = command.guess.at;
  const Eigen::VectorXd guess = chosen_guess(mechanism, command.guess);
  const KinematicsHeading heading{command.file, t, kinds_of(mechanism, command)};
  const NewtonResult pose = newton(phi, heading.kinds.empty() ? guess : heading.kinds.front().q, t);
  const Mobility result = heading.kinds.empty()
                              ? mobility(phi, pose.q, t, mechanism.fit.value_or(0))
                              : heading.kinds.front().mobility;
  deliver({{&json, [&] { return mobility_json(result, pose, mechanism, heading); }}}, command.quiet,
          [&] { return mobility_text(result, pose, mechanism, heading); });
  return is_taken(result, pose) ? kDecided : kUndecided;
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
