// SPDX-License-Identifier: MIT
// What stands beside the number of real closures, the same in text and on the page.
#include "assemblies_text.h"

namespace moivre {

std::string beside_text(const Assemblies& found) {
  std::string text;
  if (found.filtered > 0) {
    text += ", " + std::to_string(found.filtered) + " outside a joint's limits";
  }
  if (found.fitted > 0) text += ", " + std::to_string(found.fitted) + " within fit";
  return found.moves ? text + ", and it moves though the drivers stand" : text;
}

}  // namespace moivre
