// SPDX-License-Identifier: MIT
// The command study where it was not built.
#include "absent_command.h"

namespace moivre {

void add_study_command(CLI::App& moivre, Chosen& chosen) {
  add_absent_command(moivre, chosen, "study",
                     "this program was built without the study (MOIVRE_WITH_STUDY, "
                     "MOIVRE_WITH_MULTIPRECISION)");
}

}  // namespace moivre
