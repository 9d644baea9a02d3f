// SPDX-License-Identifier: MIT
// What a run knows of one root, and how is it told.
#include "run.h"

#include "dimension.h"

namespace moivre {

std::string to_string(Rung rung) {
  switch (rung) {
    case Rung::double_precision:
      return "double";
    case Rung::mixed:
      return "mixed";
    case Rung::double_double:
      return "double-double";
  }
  return "";
}

std::string to_string(RootCompleteness completeness) {
  switch (completeness) {
    case RootCompleteness::proved:
      return "proved";
    case RootCompleteness::shown:
      return "shown";
    case RootCompleteness::open:
      return "open";
  }
  return "";
}

SetHere set_of(const Run& run, const Root& root) {
  if (!root.on_set) {
    const Setting& setting = run.setting;
    root.on_set = set_through(*setting.refiner_program, root.point.x, setting.options.seed);
  }
  return *root.on_set;
}

bool is_on_set(const Run& run, const Root& root) { return set_of(run, root) != SetHere::none; }

}  // namespace moivre
