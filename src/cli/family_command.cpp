// SPDX-License-Identifier: MIT
// moivre family learn|solve|info: a system with parameters solved once, then again at the price of
// its true number of roots.
#include "family_learn.h"
#include "family_solve.h"
#include "moivre/report/family_report.h"
#include "output.h"

namespace moivre {
namespace {

struct FamilyInfoCommand {
  std::string file;
  std::string json;
  bool quiet = false;
};

int run(const FamilyInfoCommand& command) {
  require_distinct({command.json}, command.file);
  const FamilyFile file = load_family(command.file);
  Output json(command.json);
  deliver({{&json, [&] { return family_report_json(file, command.file, "family info"); }}},
          command.quiet, [&] { return family_report_text(file, command.file); });
  return kDecided;
}

void add_info(CLI::App& family, Chosen& chosen) {
  const auto command = std::make_shared<FamilyInfoCommand>();
  CLI::App& app = *family.add_subcommand("info", "Show what a family file holds");
  app.add_option("FILE", command->file, "family file")->required();
  add_json_option(app, command->json);
  add_quiet_flag(app, command->quiet);
  add_examples(app, {"moivre family info arm.family"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

void add_family_command(CLI::App& moivre, Chosen& chosen) {
  CLI::App& app = *moivre.add_subcommand(
      "family",
      "Solve a system with parameters once, then each member with one path per generic root");
  app.require_subcommand(1);
  add_family_learn(app, chosen);
  add_family_solve(app, chosen);
  add_info(app, chosen);
  add_examples(app, {"moivre family learn arm.phc --parameters a,b -o arm.family",
                     "moivre family solve arm.family --at a=1,b=2/3",
                     "moivre family solve arm.family --table poses.csv --csv roots.csv"});
}

}  // namespace moivre
