// SPDX-License-Identifier: MIT
// moivre family solve F.family --at a=1,b=2 | --table FILE: members by as many paths as a generic
// one has roots.
#include "family_solve.h"

#include <memory>
#include <stdexcept>

#include "interruption.h"
#include "kept_run.h"
#include "moivre/family/members.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/numeric/threads.h"
#include "moivre/report/family_report.h"
#include "output.h"
#include "progress_line.h"
#include "tracker_choice.h"

namespace moivre {
namespace {

struct FamilySolveCommand {
  std::string file;
  std::string at;
  std::string table;
  std::uint64_t seed = 1;
  TrackerChoice tracker;
  int threads = 0;
  bool all = false;
  bool no_certify = false;
  bool quiet = false;
  std::string json;
  std::string csv;
  std::optional<double> time_limit;
  LedgerChoice ledger;
};

void require_one_kind(const FamilySolveCommand& command) {
  if (command.at.empty() == command.table.empty()) {
    throw std::invalid_argument(
        "give the values of the parameters: --at a=1,b=2 for one member, or --table FILE for many");
  }
}

const Family& polynomial_family(const FamilyFile& file, const std::string& name) {
  if (file.kind == kPolynomialsKind) return file.families.front();
  throw std::invalid_argument(name +
                              ": these are the families of a mechanism; they are used by moivre "
                              "closures FILE --family " +
                              name);
}

struct FamilyScene {
  const FamilySolveCommand& command;
  const Family& family;
  const Tracker& tracker;
  const SolveOptions& options;
  Output& json;
  Output& csv;
  KeptRun& kept;
  ProgressLine& line;
  const std::atomic<bool>& stop;
};

int solve_one(const FamilyScene& scene, const ParameterValues& p) {
  const FamilySolveCommand& command = scene.command;
  const SolveResult result =
      solve_member(scene.family, p, scene.tracker, scene.options, scene.stop);
  scene.line.end();
  return scene.kept.deliver(
      {{&scene.json, [&] { return member_json(result, scene.family, p, command.file); }},
       {&scene.csv, [&] { return solve_csv(result); }}},
      command.quiet,
      [&] {
        return member_text(result, command.file,
                           command.all ? ListedRoots::all : ListedRoots::real);
      },
      result.complete ? "" : result.message, result.complete ? kDecided : kUndecided);
}

int solve_table(const FamilyScene& scene, const std::vector<Point>& members) {
  const FamilySolveCommand& command = scene.command;
  const Stopwatch watch;
  const std::vector<MemberRoots> roots =
      solve_members(scene.family, members, scene.tracker, scene.options, scene.stop);
  scene.line.end();
  MembersRun run{scene.family,
                 members,
                 roots,
                 command.file,
                 command.table,
                 scene.tracker.kind(),
                 scene.tracker.options_in_force(),
                 scene.options.threads,
                 watch.total()};
  return scene.kept.deliver(
      {{&scene.json, [&](const TextSink& sink) { write_members_json(sink, run); }},
       {&scene.csv, [&](const TextSink& sink) { write_members_csv(sink, run); }}},
      command.quiet, [&] { return members_text(run); },
      is_complete(run) ? "" : "some members are not decided",
      is_complete(run) ? kDecided : kUndecided);
}

int run(const FamilySolveCommand& command) {
  std::unique_ptr<Tracker> tracker;
  require_all({[&] { require_one_kind(command); }, [&] { require_threads(command.threads); },
               [&] {
                 require_distinct({command.json, command.csv, command.ledger.path}, command.file);
               },
               [&] {
                 require_distinct({command.json, command.csv, command.ledger.path}, command.table);
               },
               [&] { tracker = make_tracker(command.tracker); }});
  const FamilyFile file = load_family(command.file);
  const Family& family = polynomial_family(file, command.file);
  ParameterValues p;
  std::vector<Point> members;
  if (command.table.empty()) {
    p = values_at(family, command.at);
  } else {
    members = read_members(read_source(command.table), family);
  }
  Output json(command.json);
  Output csv(command.csv);
  KeptRun kept(command.ledger, {command.file, command.table});
  if (const auto code = kept.deliver_again({&json, &csv}, command.quiet)) return *code;
  SolveOptions options;
  options.seed = command.seed;
  options.threads = thread_count(command.threads);
  options.certify = !command.no_certify;
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
  const Interruption interruption(command.time_limit);
  const FamilyScene scene{command, family, *tracker,           options, json, csv,
                          kept,    line,   interruption.stop()};
  return command.table.empty() ? solve_one(scene, p) : solve_table(scene, members);
}

}  // namespace

void add_family_solve(CLI::App& family, Chosen& chosen) {
  const auto command = std::make_shared<FamilySolveCommand>();
  CLI::App& app = *family.add_subcommand("solve", "Find all roots of members of a family");
  app.add_option("FILE", command->file, "family file, as family learn writes it")->required();
  app.add_option("--at", command->at, "values of all parameters: a=1,b=2/3; exact")
      ->type_name("VALUES");
  app.add_option(
         "--table", command->table,
         "solve a member for each row: a column for each parameter, named in the first line")
      ->type_name("PATH");
  app.add_option("--seed", command->seed, "seed of the random numbers when a member is judged")
      ->check(CLI::Validator(not_64_bits, ""))
      ->capture_default_str();
  add_threads_option(app, command->threads);
  add_time_limit_option(app, command->time_limit);
  add_ledger_option(app, command->ledger);
  add_part_option(app, command->ledger);
  app.add_flag("--all", command->all, "also print the roots that are not real");
  app.add_flag("--no-certify", command->no_certify,
               "leave out certificates; many members then take less time");
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  app.add_option("--csv", command->csv, "write a table of the roots here")->type_name("PATH");
  add_tracker_options(app, command->tracker);
  add_examples(app,
               {"moivre family solve conics.family --at a=1,b=2/3,c=-2e-3",
                "moivre family solve arm.family --table poses.csv --csv roots.csv",
                "moivre family solve arm.family --table poses.csv --tracker lanes --no-certify",
                "moivre family solve conics.family --at a=1,b=2,c=3 --json - | jq .paths"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
