// SPDX-License-Identifier: MIT
// The commands about mechanisms where mechanisms were not built: each says so, whatever its arguments.
#include <stdexcept>

#include "command.h"

namespace moivre {
namespace {

void add_absent(CLI::App& moivre, Chosen& chosen, const std::string& name) {
  const std::string reason = "this program was built without mechanisms (MOIVRE_WITH_MECHANISM)";
  CLI::App& app = *moivre.add_subcommand(name, "Not here: " + reason);
  app.allow_extras();
  app.callback([name, reason, &chosen] {
    chosen = [name, reason]() -> int { throw std::invalid_argument(name + ": " + reason); };
  });
}

}  // namespace

void add_closures_command(CLI::App& moivre, Chosen& chosen) {
  add_absent(moivre, chosen, "closures");
}
void add_newton_command(CLI::App& moivre, Chosen& chosen) { add_absent(moivre, chosen, "newton"); }
void add_mobility_command(CLI::App& moivre, Chosen& chosen) {
  add_absent(moivre, chosen, "mobility");
}
void add_guesses_command(CLI::App& moivre, Chosen& chosen) {
  add_absent(moivre, chosen, "guesses");
}

}  // namespace moivre
