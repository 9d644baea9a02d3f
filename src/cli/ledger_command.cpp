// SPDX-License-Identifier: MIT
// moivre ledger RUN.db: how a kept run stands, and its result when it has ended; and ledgers of
// parts put together.
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "command.h"
#include "common_options.h"
#include "moivre/expression/counted.h"
#include "moivre/run_ledger/merge.h"
#include "moivre/run_ledger/standing.h"
#include "output.h"

namespace moivre {
namespace {

struct LedgerCommand {
  std::string file;
  std::string result;
};

struct MergeCommand {
  std::string file;
  std::vector<std::string> parts;
};

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string identity_value(const RunStanding& standing, const std::string& wanted) {
  for (const auto& [name, value] : standing.identity) {
    if (name == wanted) return value;
  }
  return "";
}

std::string state_of(const RunStanding& standing) {
  if (standing.is_finished) {
    return "finished with exit code " + std::to_string(standing.exit_code);
  }
  return standing.is_running ? "running" : "interrupted; the same command goes on";
}

std::string standing_text(const RunStanding& standing, const std::string& file) {
  std::string text =
      file + ": moivre " + identity_value(standing, "command") + ", " + state_of(standing) + '\n';
  // How many loops there will be nobody knows.
  if (standing.done > 0 && !standing.is_finished) {
    text += std::to_string(standing.done) +
            (standing.total > 0 ? " of " + std::to_string(standing.total) : " loops") + " done";
    if (standing.roots > 0) text += ", " + counted(standing.roots, "root") + " so far";
    text += '\n';
  }
  text += number("%.3g s of work", standing.seconds);
  if (standing.outcomes > 0 && standing.seconds > 0) {
    text += number(", %.3g outcomes a second",
                   static_cast<double>(standing.outcomes) / standing.seconds);
  }
  const double left = standing.seconds_left();
  if (!standing.is_finished && left > 0) text += number(", about %.0f s left", std::ceil(left));
  text += "\nobserved: " + counted(standing.outcomes, "outcome") + ", " +
          std::to_string(standing.to_roots) + " finite, " + std::to_string(standing.at_infinity) +
          " at infinity, " + std::to_string(standing.failed) + " failed\n";
  return text;
}

void write_result(const LedgerCommand& command) {
  constexpr const char* kFirst = "0";  // every command's JSON
  Output output(command.result);
  bool is_there = false;
  output.write([&](const TextSink& sink) {
    is_there = read_last_answer(command.file, kFirst, sink);
    if (is_there) return;
    throw std::invalid_argument(command.file +
                                " holds no JSON of a result: the run's own command, with --json, "
                                "writes it");
  });
}

int run(const LedgerCommand& command) {
  if (command.file.empty()) throw std::invalid_argument("LEDGER is required");
  require_distinct({command.result}, command.file);
  const RunStanding standing = read_standing(command.file);
  if (!command.result.empty()) write_result(command);
  if (command.result != "-") {
    write_to_stdout(standing_text(standing, command.file));
    if (standing.is_finished) {
      write_to_stdout("\n");
      read_last_answer(command.file, "text", write_to_stdout);
    }
  }
  return standing.is_finished ? standing.exit_code : kUndecided;
}

int run(const MergeCommand& command) {
  merge_ledgers(command.file, command.parts);
  write_to_stdout(standing_text(read_standing(command.file), command.file));
  return kDecided;
}

void add_merge_command(CLI::App& ledger, Chosen& chosen) {
  const auto command = std::make_shared<MergeCommand>();
  CLI::App& app = *ledger.add_subcommand(
      "merge", "Put the ledgers of a run's parts together, so that the run goes on from there");
  app.add_option("LEDGER", command->file, "the run's file; made where there is none")->required();
  app.add_option("PARTS", command->parts, "what moivre ... --part K/N --ledger PART has kept")
      ->required();
  add_examples(app, {"moivre solve katsura-20.phc --ledger part1.db --part 1/2",
                     "moivre solve katsura-20.phc --ledger part2.db --part 2/2",
                     "moivre ledger merge run.db part1.db part2.db",
                     "moivre solve katsura-20.phc --ledger run.db --json roots.json"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

void add_ledger_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<LedgerCommand>();
  CLI::App& app = *moivre.add_subcommand(
      "ledger", "Show how a run stands that is kept by --ledger, and its result when it has ended");
  app.add_option("LEDGER", command->file, "the run's file; the run may be going on");
  app.add_option("--result", command->result,
                 "write the JSON that the run has written here; - is standard output")
      ->type_name("PATH");
  add_examples(app, {"moivre solve katsura-20.phc --ledger run.db --json roots.json",
                     "moivre ledger run.db", "moivre ledger run.db --result - | jq .paths"});
  add_merge_command(app, chosen);
  app.callback([&app, command, &chosen] {
    if (app.get_subcommands().empty()) chosen = [command] { return run(*command); };
  });
}

}  // namespace moivre
