// SPDX-License-Identifier: MIT
// moivre track FILE --path K: one path step by step, from the start system of solve or from one of
// one's own.
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "interruption.h"
#include "moivre/report/track_report.h"
#include "moivre/solver/trace.h"
#include "output.h"
#include "own_start.h"
#include "tracker_choice.h"

namespace moivre {
namespace {

struct TrackCommand {
  std::string file;
  std::uint64_t path = 0;
  std::string from;
  std::string points;
  StartChoice start;
  TrackerChoice tracker;
  std::string json;
  std::string csv;
  int threads = 0;
  bool quiet = false;
};

Trace follow_path(const TrackCommand& command, const System& f, const Tracker& tracker,
                  const std::atomic<bool>& stop) {
  SolveOptions options;
  options.seed = command.start.seed;
  options.start = kind_of(command.start);
  if (command.from.empty()) {
    return trace_path(f, tracker, options, command.path, stop);
  }
  const OwnStart own = read_own_start(command.from, command.points, command.path, f);
  Trace trace = trace_path(f, own.system, own.point, tracker, options, stop);
  trace.path = command.path;
  trace.paths = own.points;
  return trace;
}

void require_own_start(const TrackCommand& command) {
  if (command.from.empty() == command.points.empty()) return;
  throw std::invalid_argument("--from and --points belong together: a start system and its roots");
}

int run(const TrackCommand& command) {
  std::unique_ptr<Tracker> tracker;
  require_all({[&] { require_known(command.start); }, [&] { require_threads(command.threads); },
               [&] {
                 for (const std::string& input : {command.file, command.from, command.points}) {
                   require_distinct({command.json, command.csv}, input);
                 }
               },
               [&] { require_own_start(command); },
               [&] { tracker = make_tracker(command.tracker); }});
  const System f = read_polynomial_file(command.file);
  Output json(command.json);
  Output csv(command.csv);

  const Interruption interruption;
  const Trace trace = follow_path(command, f, *tracker, interruption.stop());

  const auto report = [&] {
    return track_json(trace, {command.file, command.start.seed, command.from, command.points});
  };
  const auto table = [&] { return track_csv(trace); };
  deliver({{&json, report}, {&csv, table}}, csv.is_wanted(), table);
  if (!command.quiet) std::fputs(track_verdict(trace).c_str(), stderr);
  return trace.end.status == PathStatus::failed ? kUndecided : kDecided;
}

}  // namespace

void add_track_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<TrackCommand>();
  CLI::App& app = *moivre.add_subcommand(
      "track", "Follow one path of a polynomial file and print every step as CSV");
  add_file(app, command->file);
  app.add_option("--path", command->path, "number of the path, as in solve; counts from 0")
      ->check(CLI::Validator(not_64_bits, ""))
      ->required();
  app.add_option("--from", command->from, "a start system of your own, used as it is")
      ->type_name("FILE");
  app.add_option("--points", command->points,
                 "its roots: PHCpack's solution list, a table of solve --csv, or numbers (re im of "
                 "each variable, one point per line)")
      ->type_name("FILE");
  add_start_options(app, command->start);
  app.add_option("--threads", command->threads, "accepted as in solve; one path runs on one thread")
      ->capture_default_str();
  add_json_option(app, command->json);
  app.add_option("--csv", command->csv, "write the steps here instead of to standard output")
      ->type_name("PATH");
  add_quiet_flag(app, command->quiet);
  add_tracker_options(app, command->tracker);
  add_examples(app, {"moivre track katsura.phc --path 3 > path.csv",
                     "moivre track katsura.phc --path 3 --method bdf --rtol 1e-6",
                     "moivre track target.phc --path 0 --from start.phc --points start-roots.csv"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
