// SPDX-License-Identifier: MIT
// moivre info FILE: degrees, path counts of each start system, structure; solves nothing.
#include <memory>

#include "command.h"
#include "common_options.h"
#include "moivre/report/info.h"
#include "output.h"

namespace moivre {
namespace {

struct InfoCommand {
  std::string file;
  StartChoice start;
  int threads = 0;
  std::string json;
  bool quiet = false;
};

int run(const InfoCommand& command) {
  require_all({[&] { require_known(command.start); }, [&] { require_threads(command.threads); },
               [&] { require_distinct({command.json}, command.file); }});
  const System f = read_polynomial_file(command.file);
  Output json(command.json);
  const SystemInfo info = inspect(f);
  deliver({{&json, [&] { return info_json(info, command.file); }}}, command.quiet,
          [&] { return info_text(info, command.file); });
  return kDecided;
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
  add_examples(app,
               {"moivre info katsura.phc", "moivre info katsura.phc --json - | jq .start_systems"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
