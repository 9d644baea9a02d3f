// SPDX-License-Identifier: MIT
// moivre closures FILE: every way a mechanism can be assembled, and its sensitivities, told as
// text, JSON or CSV.
#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "arm_closures.h"
#include "command.h"
#include "common_options.h"
#include "interruption.h"
#include "kept_run.h"
#include "mechanism_families.h"
#include "mechanism_input.h"
#include "moivre/closure_report/closure_report.h"
#include "moivre/closure_report/page.h"
#include "moivre/closure_report/sensitivity_report.h"
#include "moivre/closure_report/sheet.h"
#include "moivre/expression/joined.h"
#include "moivre/mechanism/read.h"
#include "moivre/numeric/stopwatch.h"
#include "output.h"
#include "progress_line.h"
#include "tracker_choice.h"

namespace moivre {
namespace {

struct ClosuresCommand {
  std::string file;
  StartChoice start;
  TrackerChoice tracker;
  MechanismChoice mechanism;
  AngleForm angles;
  std::string family;
  ArmOptions arm;
  double at = 0;
  bool sensitivity = false;
  bool no_certify = false;
  int threads = 0;
  bool quiet = false;
  std::string json;
  std::string csv;
  std::string svg;
  std::string html;
  bool three_views = false;
  std::optional<double> time_limit;
  LedgerChoice ledger;
};

/// What a page shows where drivers move: one turn of the first driver. None where no page is wanted
/// or nothing moves.
std::optional<MotionResult> motion_for_page(const ClosureResult& result, const Mechanism& mechanism,
                                            const ClosuresCommand& command, const Tracker& tracker,
                                            const ClosureOptions& options, ProgressLine& line,
                                            const std::atomic<bool>& stop) {
  if (command.html.empty() || mechanism.drivers.empty() || result.closures.empty() || stop) {
    return std::nullopt;
  }
  MotionOptions motion;
  motion.from = command.at;
  motion.to = command.at + natural_duration(mechanism, command.at);
  motion.solve = options.solve;
  motion.solve.progress = nullptr;
  if (line.is_active()) {
    motion.progress = [&](double share) {
      line.show(std::to_string(static_cast<int>(100 * share)) + " % of the motion for the page",
                share);
    };
  }
  return find_motion(mechanism, tracker, motion, stop);
}

/// A robot has no drivers and no gears.
void require_no_more(const ClosuresCommand& command) {
  std::vector<std::string> given;
  if (command.at != 0) given.emplace_back("--at");
  if (command.mechanism.fit) given.emplace_back("--fit");
  if (command.mechanism.all_meshings) given.emplace_back("--meshings");
  if (command.no_certify) given.emplace_back("--no-certify");
  if (command.sensitivity) given.emplace_back("--sensitivity");
  if (given.empty()) return;
  throw std::invalid_argument(joined(given, ", ") + (given.size() == 1 ? " is" : " are") +
                              " not for robots (URDF); moivre mechanism makes a mechanism of one");
}

int run_robot(const ClosuresCommand& command, const Source& source) {
  require_no_more(command);
  return run_arm({command.file, command.arm, command.start, command.tracker, command.threads,
                  command.quiet, command.angles.in_degrees, command.three_views, command.json,
                  command.csv, command.svg, command.html, command.time_limit, command.ledger},
                 source);
}

constexpr const char* kTolerance = "--tolerance";

/// With --sensitivity a tolerance is one of dimensions; else the lanes', and none of these is
/// given.
std::optional<double> dimension_tolerance(const ClosuresCommand& command) {
  const std::vector<std::string>& given = command.tracker.of_lanes;
  const bool is_given = std::find(given.begin(), given.end(), kTolerance) != given.end();
  if (!command.sensitivity && is_given && command.tracker.kind == "cvode") {
    throw std::invalid_argument(
        "--tolerance: only the lanes take it (--tracker lanes); of dimensions it needs "
        "--sensitivity");
  }
  if (!command.sensitivity || !is_given) return std::nullopt;
  const double tolerance = std::get<double>(command.tracker.values.at("tolerance"));
  if (!(tolerance >= 0) || !is_workable(tolerance)) {
    throw std::invalid_argument("--tolerance of dimensions must be a length from 0 up");
  }
  return tolerance;
}

/// Without the tolerance that is none of the tracker's.
TrackerChoice tracker_of(const ClosuresCommand& command) {
  TrackerChoice choice = command.tracker;
  if (!command.sensitivity) return choice;
  choice.values["tolerance"] = TrackerChoice().values["tolerance"];
  std::erase(choice.of_lanes, kTolerance);
  return choice;
}

/// None where they are not asked for.
std::optional<Sensitivities> asked_sensitivities(const ClosuresCommand& command,
                                                 const Mechanism& mechanism,
                                                 const ClosureResult& result) {
  if (!command.sensitivity) return std::nullopt;
  return closure_sensitivities(mechanism, result);
}

/// The file's mechanism, or the robot whose loops a side file closes.
Mechanism read_choice(const ClosuresCommand& command, const Source& source) {
  if (is_robot(command.file, source)) {
    return read_mechanism(
        {command.file + ", as a mechanism", robot_as_mechanism(command.file, source, command.arm)});
  }
  if (are_given(command.arm)) {
    throw std::invalid_argument(
        "--base, --tip, --pose, --poses, --hold, --sweep-hold and --loops are for robots (URDF); " +
        command.file + " is none");
  }
  return read_mechanism_file(command.file, source);
}

/// The tracker that is chosen. Throws std::invalid_argument with all that is wrong with the
/// options.
std::unique_ptr<Tracker> checked_tracker(const ClosuresCommand& command) {
  std::unique_ptr<Tracker> tracker;
  require_all(
      {[&] { require_known(command.start); }, [&] { require_threads(command.threads); },
       [&] {
         for (const std::string& input : {command.file, command.arm.loops}) {
           require_distinct({command.json, command.csv, command.svg, command.html, command.family,
                             command.ledger.path},
                            input);
         }
       },
       [&] { require_ending(command.svg, ".svg"); },
       [&] {
         if (!command.three_views || !command.svg.empty()) return;
         throw std::invalid_argument("--three-views needs --svg: it says how that is drawn");
       },
       [&] { require_ending(command.html, ".html"); }, [&] { dimension_tolerance(command); },
       [&] { tracker = make_tracker(tracker_of(command)); }});
  return tracker;
}

/// As it is chosen by the options too.
Mechanism chosen_mechanism(const ClosuresCommand& command, const Source& source) {
  Mechanism mechanism = read_choice(command, source);
  apply(command.mechanism, mechanism);
  if (command.sensitivity) require_dimensions(mechanism);
  if (const auto tolerance = dimension_tolerance(command)) mechanism.tolerance = tolerance;
  if (command.three_views) require_spatial(mechanism);
  return mechanism;
}

ClosureOptions options_of(const ClosuresCommand& command, ProgressLine& line, KeptRun& kept) {
  ClosureOptions options;
  options.time = command.at;
  options.solve.seed = command.start.seed;
  options.solve.start = kind_of(command.start);
  options.solve.threads = command.threads;
  options.solve.certify = !command.no_certify;
  options.with_mobility = !command.json.empty();
  options.solve.observations = kept.observations();
  if (line.is_active() || kept.is_kept()) {
    options.solve.progress = [&line, &kept](const Progress& progress) {
      line.show(progress);
      kept.tell(progress);
    };
  }
  return options;
}

/// All that is computed before anything is written.
struct Computed {
  ClosureResult closures;
  std::optional<Sensitivities> sensitivities;
  std::optional<MotionResult> motion;  ///< of the page
};

Computed computed(const ClosuresCommand& command, const Mechanism& mechanism,
                  const Tracker& tracker, double parse_s, KeptRun& kept,
                  const std::atomic<bool>& stop) {
  ProgressLine line(!command.quiet);
  ClosureOptions options = options_of(command, line, kept);
  MechanismFamilies families(command.family, command.file, command.start.seed);
  options.starts = families.starts();
  const std::unique_ptr<Tracker> fallback = make_fallback(tracker_of(command));
  options.solve.fallback = fallback.get();
  Computed result;
  result.closures = find_closures(mechanism, tracker, options, stop);
  result.closures.time_s.parse = parse_s;
  result.closures.time_s.total += parse_s;
  if (!stop || families.book().learned() > 0) families.keep();
  result.sensitivities = asked_sensitivities(command, mechanism, result.closures);
  result.motion =
      motion_for_page(result.closures, mechanism, command, tracker, options, line, stop);
  return result;
}

int write(const ClosuresCommand& command, const Mechanism& mechanism, const Computed& found,
          Outputs& outputs, KeptRun& kept) {
  const ClosureResult& result = found.closures;
  const bool is_shown = !found.motion || found.motion->complete;
  const std::string page_lacks =
      is_shown ? "" : "the motion on the page is incomplete: " + found.motion->message;
  const auto json = [&](const TextSink& sink) {
    write_closures_json(sink, result, mechanism, command.file,
                        found.sensitivities ? &*found.sensitivities : nullptr);
  };
  const auto csv = [&] {
    return found.sensitivities ? sensitivity_csv(*found.sensitivities, mechanism, command.angles)
                               : closures_csv(result, mechanism, command.angles);
  };
  const auto svg = [&] {
    return closures_svg(result, mechanism, command.file,
                        command.three_views ? Views::three : Views::standing);
  };
  const auto page = [&] {
    return found.motion ? motion_html(*found.motion, mechanism, command.file)
                        : closures_html(result, mechanism, command.file);
  };
  const auto text = [&] {
    return closures_text(result, mechanism, command.file) +
           (found.sensitivities ? sensitivity_text(*found.sensitivities, mechanism) : "") +
           (is_shown ? "" : page_lacks + "\n");
  };
  return kept.deliver(
      {{&outputs.json, json}, {&outputs.csv, csv}, {&outputs.svg, svg}, {&outputs.html, page}},
      command.quiet, text, result.complete ? page_lacks : result.message,
      result.complete && is_shown ? kDecided : kUndecided);
}

int run(const ClosuresCommand& command) {
  const std::unique_ptr<Tracker> tracker = checked_tracker(command);
  const Stopwatch watch;
  const Source source = read_source(command.file);
  const bool has_loops = !command.arm.loops.empty();
  if (is_robot(command.file, source) && !has_loops) return run_robot(command, source);
  const Mechanism mechanism = chosen_mechanism(command, source);
  const double parse_s = watch.total();
  Outputs outputs{Output(command.json), Output(command.csv), Output(command.svg),
                  Output(command.html)};
  KeptRun kept(command.ledger, {command.file, command.arm.loops});
  if (const auto code = kept.deliver_again(outputs.in_order(), command.quiet)) return *code;
  const Interruption interruption(command.time_limit);
  const Computed found = computed(command, mechanism, *tracker, parse_s, kept, interruption.stop());
  return write(command, mechanism, found, outputs, kept);
}

}  // namespace

void add_closures_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<ClosuresCommand>();
  CLI::App& app = *moivre.add_subcommand(
      "closures", "Find every way a mechanism can be assembled, or an arm (URDF) can hold a pose");
  add_mechanism_file(app, command->file);
  add_time_option(app, command->at);
  add_mechanism_options(app, command->mechanism);
  app.add_flag("--sensitivity", command->sensitivity,
               "show how far each closure moves with every dimension (named as in moivre sweep); "
               "with tolerances, also how far it may be off");
  add_arm_options(app, command->arm);
  app.add_flag("--no-certify", command->no_certify,
               "leave out certificates; completeness is then not stated");
  add_start_options(app, command->start);
  add_threads_option(app, command->threads);
  add_time_limit_option(app, command->time_limit);
  add_ledger_option(app, command->ledger);
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  app.add_option("--csv", command->csv, "write a table of the closures here")->type_name("PATH");
  add_angles_option(app, command->angles);
  app.add_option("--svg", command->svg, "draw all closures, side by side to one scale, here")
      ->type_name("PATH");
  app.add_flag("--three-views", command->three_views,
               "in --svg, show a spatial mechanism from the front, from the right and from above");
  app.add_option("--html", command->html,
                 "write a page here that shows all closures, and drives them by a slider")
      ->type_name("PATH");
  app.add_option("--family", command->family,
                 "use the families in this file, and add those that are learned")
      ->type_name("PATH");
  add_tracker_options(app, command->tracker);
  CLI::Option& tolerance = *app.get_option(kTolerance);
  tolerance.description(
      "with --sensitivity: tolerance of point coordinates and rod lengths, in the file's unit; "
      "more specific tolerances in the file come first. Without it, " +
      tolerance.get_description());
  add_examples(app,
               {"moivre closures four-bar.toml", "moivre closures four-bar.toml --at 0.5",
                "moivre closures four-bar.toml --json - | jq .counts",
                "moivre closures four-bar.toml --quiet --csv closures.csv",
                "moivre closures four-bar.toml --svg closures.svg",
                "moivre closures four-bar.toml --html closures.html",
                "moivre closures four-bar.toml --sensitivity --tolerance 0.05",
                "moivre closures puma560.urdf --pose \"0.4 0.1 0.3 1 0 0 0\" --svg postures.svg",
                "moivre closures panda.urdf --tip panda_hand_tcp --hold panda_joint7=0.8 "
                "--poses poses.csv --csv joints.csv",
                "moivre closures delta.urdf --loops delta.loops.toml"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
