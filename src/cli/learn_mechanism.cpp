// SPDX-License-Identifier: MIT
// The families that a mechanism's closures ask for.
#include "learn_mechanism.h"

#include <stdexcept>

#include "mechanism_input.h"
#include "moivre/closures/closures.h"
#include "moivre/family/book.h"

namespace moivre {

FamilyFile learn_mechanism(const std::string& path, const Tracker& tracker,
                           const SolveOptions& options, const std::atomic<bool>& stop) {
  const Mechanism mechanism = read_mechanism_file(path);
  FamilyBook book({}, options.seed);
  ClosureOptions closures;
  closures.solve = options;
  closures.certify = false;  // what is kept are families, and their roots are certified there
  closures.starts = &book;
  find_closures(mechanism, tracker, closures, stop);
  FamilyFile file;
  file.kind = kMechanismKind;
  file.source = path;
  file.families = book.families();
  if (stop && file.families.empty()) {
    throw std::invalid_argument("interrupted: nothing was learned");
  }
  return file;
}

}  // namespace moivre
