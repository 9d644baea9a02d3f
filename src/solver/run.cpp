// SPDX-License-Identifier: MIT
// What a run knows of one root, and how is it told.
#include "run.h"

#include <algorithm>

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

std::vector<std::vector<std::uint64_t>> groups_beside_sets(const Run& run) {
  std::vector<std::vector<std::uint64_t>> groups;
  const auto& roots = run.ledger.roots();
  const auto is_simple = [&](std::uint64_t path) { return roots.at(path).point.simple; };
  for (auto& group : run.ledger.groups()) {
    auto& beside = groups.emplace_back(std::move(group));
    if (beside.size() == 1 || std::none_of(beside.begin(), beside.end(), is_simple)) continue;
    const auto on_set = std::stable_partition(beside.begin(), beside.end(), [&](auto path) {
      return is_simple(path) || !is_on_set(run, roots.at(path));
    });
    std::vector<std::uint64_t> set(on_set, beside.end());
    beside.erase(on_set, beside.end());
    if (!set.empty()) groups.push_back(std::move(set));
  }
  return groups;
}

}  // namespace moivre
