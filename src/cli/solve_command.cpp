// SPDX-License-Identifier: MIT
// moivre solve FILE: all roots of a polynomial file, told as text, JSON, CSV or PHCpack's solution
// list.
#include <memory>
#include <optional>
#include <stdexcept>

#include "choices.h"
#include "command.h"
#include "common_options.h"
#include "interruption.h"
#include "kept_run.h"
#include "memory.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/polynomial/patches.h"
#include "moivre/report/solve_report.h"
#include "moivre/solver/cross_check.h"
#include "moivre/solver/digits.h"
#include "output.h"
#include "progress_line.h"
#include "root_filter.h"
#include "tracker_choice.h"

namespace moivre {
namespace {

// Their texts take longer than it takes to begin a thread.
constexpr std::size_t kManyRoots = 1000;

struct SolveCommand {
  std::string file;
  StartChoice start;
  TrackerChoice tracker;
  FilterChoice filter;
  int threads = 0;
  bool all = false;
  bool slice = false;
  bool cross_check = false;
  bool no_certify = false;
  bool every_path = false;
  std::optional<int> digits;
  std::string precision = "auto";
  std::optional<double> time_limit;
  bool quiet = false;
  std::string json;
  std::string csv;
  std::string paths;
  std::string phc;
  LedgerChoice ledger;
};

struct Problem {
  System system;
  double parse_s = 0;
};

Problem read_problem(const std::string& file) {
  const Stopwatch watch;
  Problem problem{read_polynomial_file(file)};
  problem.parse_s = watch.total();
  return problem;
}

Precision precision_of(const std::string& name) {
  if (name == "auto") return Precision::automatic;
  if (name == "double") return Precision::double_precision;
  if (name == "double-double") return Precision::double_double;
  throw std::invalid_argument("--precision " + name +
                              ": the precisions are auto, double and double-double");
}

SolveResult solve_interruptibly(const SolveCommand& command, const Problem& problem,
                                const Tracker& tracker, const Tracker* witness, KeptRun& kept,
                                const std::atomic<bool>& stop) {
  SolveOptions options;
  options.seed = command.start.seed;
  options.start = kind_of(command.start);
  options.threads = command.threads;
  options.slice = command.slice;
  options.certify = !command.no_certify;
  options.every_path = command.every_path;
  options.precision = precision_of(command.precision);
  options.memory = memory_state().available;
  const std::unique_ptr<Tracker> fallback = make_fallback(command.tracker);
  options.fallback = fallback.get();
  ProgressLine line(!command.quiet);
  options.observations = kept.observations();
  if (line.is_active() || kept.is_kept()) {
    options.progress = [&](const Progress& progress) {
      line.show(progress);
      kept.tell(progress);
    };
  }
  SolveResult result = solve(problem.system, tracker, options, stop);
  if (witness != nullptr && !stop.load()) {
    cross_check(problem.system, result, tracker, *witness, options, stop);
  }
  const int digits = command.digits.value_or(digits_that_part(problem.system, result));
  if (digits > 0) give_digits(problem.system, digits, result, stop);
  result.time.parse = problem.parse_s;
  result.time.total += problem.parse_s;
  return result;
}

void require_option(int digits) {
  try {
    require_digits(digits);
  } catch (const std::invalid_argument& refusal) {
    throw std::invalid_argument("--digits " + std::to_string(digits) + ": " + refusal.what());
  }
}

/// Roots are refined on the equations as they are.
void require_digits_possible(const SolveCommand& command, const System& f) {
  if (!command.digits || is_square(f)) return;
  throw std::invalid_argument(
      "--digits needs as many equations as unknowns, and no homogeneous groups");
}

int run(const SolveCommand& command) {
  std::unique_ptr<Tracker> tracker;
  std::unique_ptr<Tracker> witness;
  require_all({[&] { require_known(command.start); }, [&] { require_threads(command.threads); },
               [&] { precision_of(command.precision); },
               [&] {
                 if (command.digits) require_option(*command.digits);
               },
               [&] {
                 require_distinct(
                     {command.json, command.csv, command.paths, command.phc, command.ledger.path},
                     command.file);
               },
               [&] { tracker = make_tracker(command.tracker, command.cross_check); },
               [&] {
                 if (command.cross_check) witness = make_witness(command.tracker);
               }});
  RootFilter filter = filter_of(command.filter);
  const Problem problem = read_problem(command.file);
  filter.conditions = conditions_of(command.filter, problem.system);
  require_digits_possible(command, problem.system);
  require_unbroken(broken_rules(filter, problem.system.variables));
  Output json(command.json);
  Output csv(command.csv);
  Output paths(command.paths);
  Output phc(command.phc);

  KeptRun kept(command.ledger, {command.file});
  if (const auto code = kept.deliver_again({&json, &csv, &paths, &phc}, command.quiet)) {
    return *code;
  }
  const Interruption interruption(command.time_limit);
  SolveResult result =
      solve_interruptibly(command, problem, *tracker, witness.get(), kept, interruption.stop());
  keep_wanted(filter, result);

  return kept.deliver(
      {{&json, [&](const TextSink& sink) { write_solve_json(sink, result, command.file); }},
       {&csv, [&](const TextSink& sink) { write_solve_csv(sink, result); }},
       {&paths, [&](const TextSink& sink) { write_paths_csv(sink, result); }},
       {&phc, [&](const TextSink& sink) { write_solve_phc(sink, result, problem.system); }}},
      command.quiet,
      [&](const TextSink& sink) {
        write_solve_text(sink, result, command.file,
                         command.all ? ListedRoots::all : ListedRoots::real);
      },
      result.complete ? "" : result.message, result.complete ? kDecided : kUndecided,
      result.solutions.size() < kManyRoots ? 1 : command.threads);
}

}  // namespace

void add_solve_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<SolveCommand>();
  CLI::App& app = *moivre.add_subcommand("solve", "Find all roots of a polynomial file");
  add_file(app, command->file);
  add_start_options(app, command->start);
  add_threads_option(app, command->threads);
  add_filter_options(app, command->filter);
  add_time_limit_option(app, command->time_limit);
  add_ledger_option(app, command->ledger);
  add_part_option(app, command->ledger);
  app.add_flag("--all", command->all, "also print the roots that are not real");
  app.add_flag(
      "--slice", command->slice,
      "add random linear equations where equations are missing; the roots are witness points");
  app.add_option("--digits", command->digits,
                 "give every nonsingular root to N significant digits, 1 to 1000")
      ->type_name("N");
  app.add_flag("--cross-check", command->cross_check,
               "also solve with the other tracker, and compare path by path");
  app.add_flag("--no-certify", command->no_certify,
               "do not tell certificates and completeness; what is a root is proved all the same");
  app.add_flag("--every-path", command->every_path,
               "follow every path to its end, also where as many roots are known as there can be");
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  app.add_option("--csv", command->csv, "write a table of the roots here")->type_name("PATH");
  app.add_option("--paths", command->paths,
                 "write a table of all paths here: where each ended and what it took")
      ->type_name("PATH");
  app.add_option("--phc", command->phc, "write PHCpack's solution list here")->type_name("PATH");
  add_tracker_options(app, command->tracker);
  CLI::Option* const precision =
      app.add_option("--precision", command->precision,
                     "precision of the paths: auto (more digits where double fails), double or "
                     "double-double; lanes: several paths at once in each")
          ->capture_default_str()
          ->group("Tracker");
  offer(*precision, {"auto", "double", "double-double"});
  add_examples(
      app, {"moivre solve katsura.phc", "moivre solve katsura.phc --all --seed 7",
            "moivre solve cassou.phc --start polyhedral", "moivre solve katsura.phc --digits 50",
            "moivre solve curves.txt --where 'x*y > 2' --where '0 < x <= 5'",
            "moivre solve katsura.phc --json - | jq .paths",
            "moivre solve katsura.phc --quiet --csv roots.csv --phc roots.phc",
            "moivre solve cyclic.phc --paths paths.csv",
            "moivre solve katsura-20.phc --ledger run.db --json roots.json"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
