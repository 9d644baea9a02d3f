// SPDX-License-Identifier: MIT
// The families of a mechanism where mechanisms were not built.
#include <stdexcept>

#include "learn_mechanism.h"

namespace moivre {

FamilyFile learn_mechanism(const std::string&, const Tracker&, const SolveOptions&,
                           const std::atomic<bool>&) {
  throw std::invalid_argument("this program was built without mechanisms (MOIVRE_WITH_MECHANISM)");
}

}  // namespace moivre
