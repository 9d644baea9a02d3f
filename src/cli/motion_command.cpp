// SPDX-License-Identifier: MIT
// moivre motion FILE: every closure followed along the drivers, or the pose from a guess; text,
// JSON or CSV.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "column_choice.h"
#include "command.h"
#include "common_options.h"
#include "interruption.h"
#include "kept_run.h"
#include "mechanism_input.h"
#include "moivre/closure_report/closure_report.h"
#include "moivre/closure_report/motion_report.h"
#include "moivre/closure_report/page.h"
#include "moivre/closure_report/readings_report.h"
#include "moivre/expression/counted.h"
#include "moivre/mechanism/closure_id.h"
#include "moivre/mechanism/drawn_pose.h"
#include "moivre/motion/circuits.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/report/number_text.h"
#include "output.h"
#include "progress_line.h"
#include "tracker_choice.h"

namespace moivre {
namespace {

struct MotionCommand {
  std::optional<double> time_limit;
  LedgerChoice ledger;
  std::string file;
  StartChoice start;
  TrackerChoice tracker;
  MechanismChoice mechanism;
  AngleForm angles;
  ColumnChoice columns;
  MotionOptions options;
  std::optional<double> to;
  std::vector<std::string> guesses;
  bool from_guess = false;
  std::vector<std::string> closures;
  bool quiet = false;
  std::string json;
  std::string csv;
  std::string svg;
  std::string html;
};

bool prescribes_angle(const Mechanism& mechanism, const Driver& driver) {
  return driver.kind == DriverKind::angle ||
         (driver.kind == DriverKind::unknown && mechanism.unknowns[driver.unknown].is_angle);
}

/// A branch takes a step of `longest_step` at most for a radian of a body, or of half a turn in a
/// quaternion.
void require_reachable(const Mechanism& mechanism, const MotionOptions& options) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double most = 2 * options.branch.maximum_steps * options.branch.longest_step / kTurn;
  const std::vector<double> begin = driver_values(mechanism, options.from);
  const std::vector<double> end = driver_values(mechanism, options.to);
  for (std::size_t k = 0; k < begin.size(); ++k) {
    const Driver& driver = mechanism.drivers[k];
    const double turns = std::abs(end[k] - begin[k]) / kTurn;
    if (!prescribes_angle(mechanism, driver) || turns <= most) continue;
    throw std::invalid_argument(
        "from t = " + exact_text(options.from) + " s to " + exact_text(options.to) + " s driver '" +
        driver.name + "' turns " + std::to_string(std::llround(turns)) +
        " times; a branch is followed for " + std::to_string(std::llround(most)) +
        " turns at most: take a nearer --to");
  }
}

/// Refuses so many samples that a branch of them would not fit into memory.
void require_room(const Mechanism& mechanism, const MotionCommand& command,
                  const QuantityReader* reader) {
  constexpr double kMostInPage = 3e6;   // numbers with their names in one tree: half a gigabyte
  constexpr double kMostInTable = 3e7;  // as text, likewise
  constexpr double kMostInStream = kMostInTable;  // the samples themselves, likewise
  std::size_t places = 0;
  for (const Body& body : mechanism.bodies) places += body.points.size();
  const std::size_t components = mechanism.space == Space::planar ? 2 : 3;
  constexpr double kDerivatives = 3;  // position, velocity, acceleration
  const double numbers =
      kDerivatives * static_cast<double>(coordinates(mechanism).size() + components * places) +
      static_cast<double>(reader == nullptr ? 0 : reader->quantities().size());
  const auto require = [&](const std::string& path, const char* option, double most) {
    if (path.empty() || command.options.steps * numbers <= most) return;
    throw std::invalid_argument(
        std::string(option) + ": " + counted(command.options.steps, "step") +
        " would not fit into memory; take " +
        std::to_string(std::llround(std::floor(most / numbers))) + " at most");
  };
  require_all({[&] { require(command.json, "--json", kMostInStream); },
               [&] { require(command.html, "--html", kMostInPage); },
               [&] { require(command.csv, "--csv", kMostInTable); }});
}

/// Where nothing depends on the time, nothing moves.
void require_mover(const Mechanism& mechanism) {
  const bool has_time =
      std::any_of(mechanism.equations.begin(), mechanism.equations.end(),
                  [](const Equation& equation) { return depends_on_time(equation.formula); });
  if (!mechanism.drivers.empty() || has_time) return;
  throw std::invalid_argument(
      "there is no driver, so that nothing moves: add a [[driver]], such as angle = \"crank\", "
      "start = 0, velocity = 10");
}

/// Where the drawn pose is asked for and does not close, what misses.
void require_drawn(const Mechanism& mechanism, const MotionCommand& command) {
  const auto& asked = command.closures;
  const bool is_asked = std::find(asked.begin(), asked.end(), kDrawn) != asked.end();
  if (!is_asked || is_drawn_at(mechanism, command.options.from)) return;
  throw std::invalid_argument("the drawn pose, all coordinates 0, is no closure at t = " +
                              exact_text(command.options.from) +
                              " s: " + drawn_miss(mechanism, command.options.from));
}

MotionResult closures_moved(const Mechanism& mechanism, const Tracker& tracker,
                            const MotionOptions& options, const std::atomic<bool>& stop) {
  try {
    return find_motion(mechanism, tracker, options, stop);
  } catch (const std::invalid_argument& refusal) {
    throw std::invalid_argument(std::string(refusal.what()) +
                                "\nOne pose can be followed without closures: --from-guess takes "
                                "the one that Newton-Raphson assembles.");
  }
}

MotionResult moved(const Mechanism& mechanism, const MotionCommand& command, const Tracker& tracker,
                   const MotionOptions& options, const std::atomic<bool>& stop) {
  if (command.guesses.empty() && !command.from_guess) {
    return closures_moved(mechanism, tracker, options, stop);
  }
  const GuessChoice choice{options.from, command.guesses};
  return follow_guesses(mechanism, {chosen_guess(mechanism, choice)}, options, stop);
}

/// The tracker that is chosen. Throws std::invalid_argument with all that is wrong with the
/// options.
std::unique_ptr<Tracker> checked_tracker(const MotionCommand& command) {
  std::unique_ptr<Tracker> tracker;
  require_all({[&] { require_known(command.start); },
               [&] { require_threads(command.options.solve.threads); },
               [&] {
                 require_distinct(
                     {command.json, command.csv, command.svg, command.html, command.ledger.path},
                     command.file);
               },
               [&] { require_ending(command.svg, ".svg"); },
               [&] { require_ending(command.html, ".html"); },
               [&] {
                 if (!asks_for_help(command.columns)) groups_of(command.columns);
               },
               [&] { tracker = make_tracker(command.tracker); }});
  return tracker;
}

MotionOptions options_of(const MotionCommand& command, const Mechanism& mechanism,
                         ProgressLine& line, KeptRun& kept) {
  MotionOptions options = command.options;
  options.to = command.to.value_or(options.from + natural_duration(mechanism, options.from));
  options.solve.seed = command.start.seed;
  options.solve.start = kind_of(command.start);
  options.solve.observations = kept.observations();
  if (line.is_active() || kept.is_kept()) {
    options.progress = [&line, &kept](double share) {
      constexpr double kWhole = 1000;
      kept.tell(static_cast<std::uint64_t>(kWhole * share), static_cast<std::uint64_t>(kWhole));
      line.show(std::to_string(static_cast<int>(100 * share)) + " % of the motion", share);
    };
  }
  return options;
}

MotionResult computed(const MotionCommand& command, const Mechanism& mechanism,
                      const Tracker& tracker, MotionOptions options, double parse_s,
                      const std::atomic<bool>& stop) {
  const std::unique_ptr<Tracker> fallback = make_fallback(command.tracker);
  options.solve.fallback = fallback.get();
  options.asked = command.closures;
  MotionResult result = moved(mechanism, command, tracker, options, stop);
  result.time_s.parse = parse_s;
  result.time_s.total += parse_s;
  if (command.closures.empty() || stop) return result;
  const Circuits circuits = find_circuits(mechanism, result);
  return reachable_from(std::move(result), circuits, command.closures);
}

/// `read`: null where no columns were asked for.
int write(const MotionCommand& command, const Mechanism& mechanism, const MotionResult& result,
          const Readings* read, Outputs& outputs, KeptRun& kept) {
  const auto json = [&](const TextSink& sink) {
    write_motion_json(sink, result, mechanism, command.file, command.angles, read);
  };
  const auto csv = [&] {
    return read != nullptr ? columns_csv(result, *read, mechanism, command.angles)
                           : motion_csv(result, mechanism, command.angles);
  };
  const auto svg = [&] { return motion_svg(result, mechanism, command.file); };
  const auto page = [&] { return motion_html(result, mechanism, command.file, read); };
  const auto text = [&] {
    return motion_text(result, mechanism, command.file) +
           (read != nullptr ? extremes_text(*read, mechanism) : "");
  };
  return kept.deliver(
      {{&outputs.json, json}, {&outputs.csv, csv}, {&outputs.svg, svg}, {&outputs.html, page}},
      command.quiet, text, result.complete ? "" : result.message,
      result.complete ? kDecided : kUndecided);
}

int run(const MotionCommand& command) {
  const std::unique_ptr<Tracker> tracker = checked_tracker(command);
  const Stopwatch watch;
  Mechanism mechanism = read_any_mechanism(command.file);
  apply(command.mechanism, mechanism);
  if (asks_for_help(command.columns)) {
    write_to_stdout(columns_help(mechanism));
    return kDecided;
  }
  require_mover(mechanism);
  const std::unique_ptr<const QuantityReader> reader = make_reader(mechanism, command.columns);
  const double parse_s = watch.total();
  ProgressLine line(!command.quiet);
  KeptRun kept(command.ledger, {command.file});
  const MotionOptions options = options_of(command, mechanism, line, kept);
  require_workable(mechanism, options);
  require_reachable(mechanism, options);
  require_drawn(mechanism, command);
  require_room(mechanism, command, reader.get());
  Outputs outputs{Output(command.json), Output(command.csv), Output(command.svg),
                  Output(command.html)};
  if (const auto code = kept.deliver_again(outputs.in_order(), command.quiet)) return *code;
  const Interruption interruption(command.time_limit);
  const MotionResult result =
      computed(command, mechanism, *tracker, options, parse_s, interruption.stop());
  const bool tells_extremes = !command.quiet || outputs.json.is_wanted();
  std::optional<Readings> readings;
  if (reader) readings = read_motion(result, mechanism, *reader, tells_extremes);
  line.end();
  return write(command, mechanism, result, readings ? &*readings : nullptr, outputs, kept);
}

void add_time_options(CLI::App& app, MotionCommand& command) {
  app.add_option("--from", command.options.from, "start time of the drivers, in seconds")
      ->capture_default_str();
  app.add_option("--to", command.to,
                 "end time, in seconds; default: after one turn of the first driver, if it turns");
  app.add_option("--steps", command.options.steps, "number of equal time steps between the samples")
      ->capture_default_str();
  app.add_option("--checkpoints", command.options.checkpoints,
                 "how often the closures are solved again and compared with the branches")
      ->capture_default_str();
}

}  // namespace

void add_motion_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<MotionCommand>();
  CLI::App& app = *moivre.add_subcommand(
      "motion", "Follow every closure along the drivers: position, velocity, acceleration");
  add_any_file(app, command->file);
  add_time_options(app, *command);
  CLI::Option* const guess = app.add_option(
      "--guess", command->guesses,
      "change this value of the file's guess and follow only the pose assembled from "
      "it; angles in the file's unit; may be repeated; no closures are solved");
  guess->type_name("NAME=VALUE");
  CLI::Option* const from_guess = app.add_flag(
      "--from-guess", command->from_guess, "follow only the pose assembled from the file's guess");
  app.add_option(
         "--closure", command->closures,
         "show only the branches that can be reached from this closure without taking the "
         "mechanism apart: A, B, ... at the start of the motion, or drawn; of independent "
         "sub-chains also E.H, one of each, or 1:E, any with E of the first; may be repeated")
      ->excludes(guess)
      ->excludes(from_guess)
      ->type_name("NAME");
  add_mechanism_options(app, command->mechanism);
  add_start_options(app, command->start);
  add_threads_option(app, command->options.solve.threads);
  add_time_limit_option(app, command->time_limit);
  add_ledger_option(app, command->ledger);
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  app.add_option("--csv", command->csv, "write a table of all samples here")->type_name("PATH");
  add_angles_option(app, command->angles);
  add_column_options(app, command->columns);
  app.add_flag(
      "--continuous", command->angles.goes_on,
      "continue angles beyond half a turn along a branch, without a jump, in CSV and JSON");
  app.add_option("--svg", command->svg,
                 "draw the curves of points here, one colour per branch; of typed equations each "
                 "unknown over the time")
      ->type_name("PATH");
  app.add_option("--html", command->html,
                 "write a page here that drives all branches by a slider and plots them")
      ->type_name("PATH");
  add_tracker_options(app, command->tracker);
  add_examples(app, {"moivre motion four-bar.toml",
                     "moivre motion four-bar.toml --from 0 --to 0.1 --steps 50 --csv motion.csv",
                     "moivre motion stephenson-3.toml --closure C --svg circuit.svg",
                     "moivre motion jansen-leg.toml --checkpoints 12 --json - | jq .events",
                     "moivre motion four-bar.toml --svg curves.svg --html motion.html",
                     "moivre motion four-bar.toml --columns joints,transmission --csv joints.csv",
                     "moivre motion four-bar.toml --columns all --html motion.html --quiet",
                     "moivre motion rssr.toml --from-guess",
                     "moivre motion four-bar.toml --guess coupler.phi=-60 --guess rocker.phi=-90"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
