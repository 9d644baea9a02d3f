// SPDX-License-Identifier: MIT
// moivre guesses FILE: every closure (or real root) as an initial guess for a Newton solve of one's
// own.
#include <memory>

#include "command.h"
#include "common_options.h"
#include "interruption.h"
#include "mechanism_input.h"
#include "moivre/closure_report/kinematics_report.h"
#include "moivre/mechanism/read.h"
#include "moivre/polynomial/read.h"
#include "moivre/solver/filter.h"
#include "output.h"
#include "progress_line.h"
#include "tracker_choice.h"

namespace moivre {
namespace {

struct GuessesCommand {
  std::string file;
  StartChoice start;
  TrackerChoice tracker;
  AngleForm angles;
  double at = 0;
  int threads = 0;
  bool quiet = false;
  std::string json;
  std::string csv;
};

struct Found {
  Mechanism mechanism;
  InitialGuesses guesses;
  Completeness completeness;
};

Found find(const GuessesCommand& command, const Tracker& tracker, const std::atomic<bool>& stop) {
  ClosureOptions options;
  options.time = command.at;
  options.solve.seed = command.start.seed;
  options.solve.start = kind_of(command.start);
  options.solve.threads = command.threads;
  const std::unique_ptr<Tracker> fallback = make_fallback(command.tracker);
  options.solve.fallback = fallback.get();
  ProgressLine line(!command.quiet);
  if (line.is_active()) {
    options.solve.progress = [&](const Progress& progress) { line.show(progress); };
  }
  Found found;
  if (is_mechanism_file(command.file)) {
    found.mechanism = read_mechanism(read_source(command.file));
    const ClosureResult result = find_closures(found.mechanism, tracker, options, stop);
    found.guesses = initial_guesses(result, found.mechanism);
    found.completeness = {result.complete, result.message};
  } else {
    const System f = read_system(read_source(command.file));
    SolveResult result = solve(f, tracker, options.solve, stop);
    keep_wanted({.conditions = f.conditions}, result);
    found.mechanism = typed_mechanism(f);
    found.guesses = initial_guesses(result);
    found.completeness = {result.complete, result.message};
  }
  return found;
}

int run(const GuessesCommand& command) {
  std::unique_ptr<Tracker> tracker;
  require_all({[&] { require_known(command.start); }, [&] { require_threads(command.threads); },
               [&] {
                 require_distinct({command.json, command.csv}, command.file);
               },
               [&] { tracker = make_tracker(command.tracker); }});
  Output json(command.json);
  Output csv(command.csv);
  const Interruption interruption;
  const Found found = find(command, *tracker, interruption.stop());
  const KinematicsHeading heading{command.file, command.at, {}};
  deliver(
      {{&json, [&] { return guesses_json(found.guesses, found.completeness, heading); }},
       {&csv, [&] { return guesses_csv(found.guesses, found.mechanism, command.angles); }}},
      command.quiet,
      [&] { return guesses_text(found.guesses, found.completeness, found.mechanism, heading); },
      found.completeness.complete ? "" : found.completeness.message);
  return found.completeness.complete ? kDecided : kUndecided;
}

}  // namespace

void add_guesses_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<GuessesCommand>();
  CLI::App& app = *moivre.add_subcommand(
      "guesses", "Write every closure or real root as an initial guess for a Newton solve");
  add_any_file(app, command->file);
  add_time_option(app, command->at);
  add_start_options(app, command->start);
  add_threads_option(app, command->threads);
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  app.add_option("--csv", command->csv, "write a table of the guesses here")->type_name("PATH");
  add_angles_option(app, command->angles);
  add_tracker_options(app, command->tracker);
  add_examples(app, {"moivre guesses four-bar.toml", "moivre guesses four-bar.toml --csv -",
                     "moivre guesses plane.phc --json guesses.json"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
