// SPDX-License-Identifier: MIT
// What a run knows of one root, and how is it told.
#include "run.h"

#include "dimension.h"

namespace moivre {

std::string to_string(PathPrecision precision) {
  switch (precision) {
    case PathPrecision::double_precision:
      return "double";
    case PathPrecision::mixed:
      return "mixed";
    case PathPrecision::double_double:
      return "double-double";
    case PathPrecision::multiprecision:
      return "multiprecision";
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

bool Budget::allows(std::uint64_t worth) {
  if (spent_ > worth / 2) return false;
  spent_ = worth;
  return true;
}

SetHere set_of(const Run& run, const Root& root) {
  if (root.is_exact) return SetHere::none;
  if (!root.on_set) {
    const Setting& setting = run.setting;
    run.require_time();
    const SetHere found = set_through(*setting.refiner_program, root.point.x, root.tolerance,
                                      setting.options.seed, &setting.stop);
    run.require_time();
    root.on_set = found;
  }
  return *root.on_set;
}

bool is_on_set(const Run& run, const Root& root) { return set_of(run, root) != SetHere::none; }

}  // namespace moivre
