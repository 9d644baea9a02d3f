// SPDX-License-Identifier: MIT
// moivre check SYSTEM RESULT: an independent judge of a result; every claim that does not hold is
// named.
#include <memory>
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "interruption.h"
#include "moivre/report/check_report.h"
#include "output.h"

namespace moivre {
namespace {

// What solve writes of some ten million roots.
constexpr std::size_t kLongestResult = 16'000'000'000;

struct CheckCommand {
  std::string file;
  std::string result;
  std::string json;
  bool quiet = false;
  std::optional<double> time_limit;
};

void require_one_stdin(const CheckCommand& command) {
  if (command.file != "-" || command.result != "-") return;
  throw std::invalid_argument("system and result cannot both come from standard input");
}

std::string unfinished(const Judgement& judgement) {
  if (!judgement.holds()) return "some claims do not hold";
  if (judgement.interrupted) return "interrupted: not every claim was judged";
  return judgement.proofs_hold() ? "" : "some claims of a proof cannot be verified";
}

int run(const CheckCommand& command) {
  require_all({[&] { require_one_stdin(command); },
               [&] { require_distinct({command.json}, command.file); },
               [&] { require_distinct({command.json}, command.result); }});
  const System f = read_polynomial_file(command.file);
  const Claims claims = read_claims(read_source(command.result, kLongestResult), f.variables);
  Output json(command.json);
  const Interruption interruption(command.time_limit);
  const Judgement judgement = check(f, claims, interruption.stop());
  const JudgedFiles files{command.file, command.result};
  deliver(
      {{&json, [&] { return check_json(judgement, files); }}}, command.quiet,
      [&] { return check_text(judgement, files); }, unfinished(judgement));
  return judgement.proofs_hold() ? kDecided : kUndecided;
}

}  // namespace

void add_check_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<CheckCommand>();
  CLI::App& app = *moivre.add_subcommand(
      "check",
      "Check a result by certificates, sums and bounds; exit code 2 if a claim is false, or a "
      "claim of a proof cannot be verified");
  add_file(app, command->file);
  app.add_option("RESULT", command->result,
                 "JSON of moivre solve, or PHCpack's solution list; - is standard input")
      ->required();
  add_json_option(app, command->json);
  add_quiet_flag(app, command->quiet);
  add_time_limit_option(app, command->time_limit);
  add_examples(app,
               {"moivre solve katsura.phc --json roots.json; moivre check katsura.phc roots.json",
                "moivre solve katsura.phc --json - | moivre check katsura.phc -",
                "phc -b katsura.phc out; moivre check katsura.phc out",
                "moivre check katsura.phc roots.json --json - | jq .refuted"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
