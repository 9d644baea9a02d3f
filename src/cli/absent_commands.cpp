// SPDX-License-Identifier: MIT
// The commands about mechanisms where mechanisms were not built: each says so, whatever its
// arguments.
#include "absent_command.h"

namespace moivre {
namespace {

void add_absent(CLI::App& moivre, Chosen& chosen, const std::string& name) {
  add_absent_command(moivre, chosen, name,
                     "this program was built without mechanisms (MOIVRE_WITH_MECHANISM)");
}

}  // namespace

void add_closures_command(CLI::App& moivre, Chosen& chosen) {
  add_absent(moivre, chosen, "closures");
}
void add_motion_command(CLI::App& moivre, Chosen& chosen) { add_absent(moivre, chosen, "motion"); }
void add_newton_command(CLI::App& moivre, Chosen& chosen) { add_absent(moivre, chosen, "newton"); }
void add_mobility_command(CLI::App& moivre, Chosen& chosen) {
  add_absent(moivre, chosen, "mobility");
}
void add_sweep_command(CLI::App& moivre, Chosen& chosen) { add_absent(moivre, chosen, "sweep"); }
void add_guesses_command(CLI::App& moivre, Chosen& chosen) {
  add_absent(moivre, chosen, "guesses");
}
void add_mechanism_command(CLI::App& moivre, Chosen& chosen) {
  add_absent(moivre, chosen, "mechanism");
}

}  // namespace moivre
