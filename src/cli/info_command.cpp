// SPDX-License-Identifier: MIT
// moivre info FILE: degrees, path counts of each start system, structure; solves nothing.
#include <cstdio>
#include <memory>

#include "command.h"
#include "common_options.h"
#include "interruption.h"
#include "moivre/report/info.h"
#include "output.h"
#include "progress_line.h"

namespace moivre {
namespace {

struct InfoCommand {
  std::string file;
  StartChoice start;
  int threads = 0;
  std::string json;
  bool quiet = false;
  std::optional<double> time_limit;
};

int run(const InfoCommand& command) {
  require_all({[&] { require_known(command.start); }, [&] { require_threads(command.threads); },
               [&] { require_distinct({command.json}, command.file); }});
  const System f = read_polynomial_file(command.file);
  Output json(command.json);
  ProgressLine line(!command.quiet);
  InspectOptions options;
  if (line.is_active()) {
    options.progress = [&line](const CellSearchProgress& search) {
      Progress progress;
      progress.cells = search.cells;
      progress.search = search.fraction;
      line.show(progress);
    };
  }
  const Interruption interruption(command.time_limit);
  options.stop = &interruption.stop();
  const SystemInfo info = inspect(f, options);
  line.end();
  deliver({{&json, [&] { return info_json(info, command.file); }}}, command.quiet,
          [&] { return info_text(info, command.file); });
  if (!interruption.stop()) return kDecided;
  std::fputs("moivre: interrupted: what is finished is reported\n", stderr);
  return kUndecided;
}

}  // namespace

void add_info_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<InfoCommand>();
  CLI::App& app =
      *moivre.add_subcommand("info", "Show the structure of a polynomial file without solving it");
  add_file(app, command->file);
  add_start_options(app, command->start);
  app.add_option("--threads", command->threads, "accepted as in solve; has no effect here")
      ->capture_default_str();
  add_json_option(app, command->json);
  add_quiet_flag(app, command->quiet);
  add_time_limit_option(app, command->time_limit);
  add_examples(app,
               {"moivre info katsura.phc", "moivre info katsura.phc --json - | jq .start_systems"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
