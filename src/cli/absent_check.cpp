// SPDX-License-Identifier: MIT
// The command check where it was not built.
#include "absent_command.h"

namespace moivre {

void add_check_command(CLI::App& moivre, Chosen& chosen) {
  add_absent_command(moivre, chosen, "check",
                     "this program was built without certificates (MOIVRE_WITH_CERTIFY)");
}

}  // namespace moivre
