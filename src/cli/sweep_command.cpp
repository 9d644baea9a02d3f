// SPDX-License-Identifier: MIT
// moivre sweep FILE --vary NAME=FROM:TO:N: closures counted while one or two numbers of a mechanism
// vary.
#include <cmath>
#include <memory>
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "interruption.h"
#include "kept_run.h"
#include "mechanism_families.h"
#include "mechanism_input.h"
#include "moivre/closure_report/sweep_report.h"
#include "moivre/expression/words.h"
#include "output.h"
#include "progress_line.h"
#include "tracker_choice.h"

namespace moivre {
namespace {

struct SweepCommand {
  std::string file;
  std::vector<std::string> vary;
  double at = 0;
  MechanismChoice mechanism;
  StartChoice start;
  TrackerChoice tracker;
  std::string family;
  int threads = 0;
  bool no_borders = false;
  bool quiet = false;
  std::string json;
  std::string csv;
  std::string svg;
  std::string html;
  std::optional<double> time_limit;
  LedgerChoice ledger;
};

/// "crank.A.x=10:50:200".
Varied varied_of(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  const std::size_t first = text.find(':', equals);
  const std::size_t second = text.find(':', first + 1);
  const auto refuse = [&](const std::string& reason) -> Varied {
    throw std::invalid_argument("--vary " + text + ": " + reason);
  };
  if (equals == std::string::npos || first == std::string::npos || second == std::string::npos) {
    return refuse("write NAME=FROM:TO:N, as in crank.A.x=10:50:200");
  }
  const auto from =
      to_number(trimmed(std::string_view(text).substr(equals + 1, first - equals - 1)));
  const auto to = to_number(trimmed(std::string_view(text).substr(first + 1, second - first - 1)));
  const auto count = to_number(trimmed(std::string_view(text).substr(second + 1)));
  if (!from || !to) return refuse("FROM and TO must be numbers, without a unit");
  constexpr double kMost = 1e6;
  if (!count || !(*count >= 2 && *count <= kMost) || *count != std::floor(*count)) {
    return refuse("the number of values is whole, and at least 2");
  }
  return {std::string(trimmed(text.substr(0, equals))), *from, *to,
          static_cast<std::size_t>(*count)};
}

std::vector<Varied> varied_of(const std::vector<std::string>& texts) {
  std::vector<Varied> varied;
  for (const std::string& text : texts) varied.push_back(varied_of(text));
  return varied;
}

int run(const SweepCommand& command) {
  std::unique_ptr<Tracker> tracker;
  require_all({[&] { require_known(command.start); }, [&] { require_threads(command.threads); },
               [&] {
                 require_distinct({command.json, command.csv, command.svg, command.html,
                                   command.family, command.ledger.path},
                                  command.file);
               },
               [&] { require_ending(command.svg, ".svg"); },
               [&] { require_ending(command.html, ".html"); }, [&] { varied_of(command.vary); },
               [&] { tracker = make_tracker(command.tracker); }});
  Mechanism mechanism = read_mechanism_file(command.file);
  apply(command.mechanism, mechanism);
  Output json(command.json);
  Output csv(command.csv);
  Output svg(command.svg);
  Output html(command.html);
  KeptRun kept(command.ledger, {command.file});
  if (const auto code = kept.deliver_again({&json, &csv, &svg, &html}, command.quiet)) {
    return *code;
  }
  MechanismFamilies families(command.family, command.file, command.start.seed);
  SweepOptions options;
  options.closures.time = command.at;
  options.closures.solve.seed = command.start.seed;
  options.closures.solve.start = kind_of(command.start);
  options.closures.solve.threads = command.threads;
  options.sharpen = !command.no_borders;
  options.keep_closures = !command.html.empty();
  const std::unique_ptr<Tracker> fallback = make_fallback(command.tracker);
  options.closures.solve.fallback = fallback.get();
  ProgressLine line(!command.quiet);
  options.closures.solve.observations = kept.observations();
  if (line.is_active() || kept.is_kept()) {
    options.progress = [&](std::size_t done, std::size_t total) {
      kept.tell(done, total);
      line.show(std::to_string(done) + " of " + std::to_string(total) + " samples",
                static_cast<double>(done) / static_cast<double>(total));
    };
  }
  const Interruption interruption(command.time_limit);
  const SweepResult result = sweep(mechanism, varied_of(command.vary), *tracker, families.book(),
                                   options, interruption.stop());
  if (!interruption.stop() || families.book().learned() > 0) families.keep();
  line.end();
  return kept.deliver(
      {{&json, [&] { return sweep_json(result, command.file, mechanism.warnings); }},
       {&csv, [&] { return sweep_csv(result); }},
       {&svg, [&] { return sweep_svg(result, command.file); }},
       {&html, [&] { return sweep_html(result, mechanism, command.file); }}},
      command.quiet, [&] { return sweep_text(result, command.file, mechanism.warnings); },
      result.complete ? "" : "some samples are not decided",
      result.complete ? kDecided : kUndecided);
}

}  // namespace

void add_sweep_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<SweepCommand>();
  CLI::App& app = *moivre.add_subcommand(
      "sweep", "Count a mechanism's closures while one or two of its numbers vary");
  add_mechanism_file(app, command->file);
  app.add_option("--vary", command->vary,
                 "what varies and its values, NAME=FROM:TO:N; names: body.point.x, body.point.y, "
                 "joint.length, joint.turn, a driver's name; once or twice")
      ->required()
      ->type_name("RANGE");
  add_time_option(app, command->at);
  add_mechanism_options(app, command->mechanism);
  add_start_options(app, command->start);
  add_threads_option(app, command->threads);
  add_time_limit_option(app, command->time_limit);
  add_ledger_option(app, command->ledger);
  add_part_option(app, command->ledger);
  app.add_flag("--no-borders", command->no_borders, "do not locate where the counts change");
  app.add_option("--family", command->family,
                 "use the families in this file, and add those that are learned")
      ->type_name("PATH");
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  app.add_option("--csv", command->csv, "write a table of the samples here")->type_name("PATH");
  app.add_option("--svg", command->svg, "draw a curve, or a map of counts, here")
      ->type_name("PATH");
  app.add_option("--html", command->html,
                 "write a page here: the curve or the map, and the closures where one points")
      ->type_name("PATH");
  add_tracker_options(app, command->tracker);
  add_examples(
      app,
      {"moivre sweep four-bar.toml --vary crank.A.x=10:150:100 --svg counts.svg",
       "moivre sweep four-bar.toml --vary crank=0:360:181 --csv counts.csv",
       "moivre sweep 3-rpr.toml --vary \"leg 1.length=8:24:60\" --vary \"leg 2.length=8:24:60\" "
       "--html map.html"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
