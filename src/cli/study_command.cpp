// SPDX-License-Identifier: MIT
// moivre study FILE...: error against run time over trackers and tolerances, as tables, diagrams
// and a page.
#include <memory>

#include "command.h"
#include "common_options.h"
#include "run_study.h"

namespace moivre {

void add_study_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<StudyCommand>();
  CLI::App& app = *moivre.add_subcommand(
      "study", "Measure error against run time, over trackers and tolerances");
  app.add_option(
         "FILE", command->files,
         "mechanisms (.toml), else polynomial systems: equations, or another program's text form")
      ->required();
  app.add_option("--settings", command->choice.curves,
                 "bdf_projection, bdf and adams, each also with +newton; lanes, also with +cubic "
                 "or +tangent; default: all")
      ->delimiter(',')
      ->type_name("NAME,...");
  app.add_option("--tolerances", command->choice.tolerances,
                 "rtol of CVODE, tolerance of the lanes; default: 1e-1,1e-2,1e-3,1e-4,1e-6")
      ->delimiter(',')
      ->type_name("NUMBER,...");
  app.add_flag("--full", command->choice.full, "every decade of tolerance from 1e-1 to 1e-10");
  app.add_option("--seed", command->seed, "the first seed")
      ->check(CLI::Validator(not_64_bits, ""))
      ->capture_default_str();
  app.add_option("--seeds", command->seeds, "number of seeds, one after another")
      ->capture_default_str();
  app.add_option("--count", command->count,
                 "known number of isolated roots, with multiplicity; default: from the index.json "
                 "beside the file")
      ->check(CLI::Validator(not_64_bits, ""))
      ->type_name("N");
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  app.add_option("--csv", command->csv, "write a table here, one row per file and setting")
      ->type_name("PATH");
  app.add_option(
         "--out", command->out,
         "write study.csv, index.html and each file's diagrams with their gnuplot scripts into "
         "this folder")
      ->type_name("FOLDER");
  add_examples(app,
               {"moivre study katsura.phc", "moivre study katsura.phc four-bar.toml --out study",
                "moivre study katsura.phc --settings bdf_projection,lanes --full",
                "moivre study katsura.phc --tolerances 1e-2,1e-4 --seeds 1 --json - | jq ."});
  app.callback([command, &chosen] { chosen = [command] { return run_study(*command); }; });
}

}  // namespace moivre
