// SPDX-License-Identifier: MIT
// What does a command say that this program was built without? The reason, whatever its arguments.
#pragma once

#include <stdexcept>
#include <string>

#include "command.h"

namespace moivre {

inline void add_absent_command(CLI::App& moivre, Chosen& chosen, const std::string& name,
                               const std::string& reason) {
  CLI::App& app = *moivre.add_subcommand(name, "Not here: " + reason);
  app.allow_extras();
  app.callback([name, reason, &chosen] {
    chosen = [name, reason]() -> int { throw std::invalid_argument(name + ": " + reason); };
  });
}

}  // namespace moivre
